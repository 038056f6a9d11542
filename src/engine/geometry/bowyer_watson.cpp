#include "engine/geometry/bowyer_watson.h"

#include <algorithm>

#include "engine/geometry/polygon.h"

namespace muster {

bool BowyerWatson::isGhost(const Face& face) {
    return face.vertex[0] == kGhost || face.vertex[1] == kGhost || face.vertex[2] == kGhost;
}

BowyerWatson::BowyerWatson(std::vector<Vec2> points, std::array<std::int32_t, 3> first)
    : points_(std::move(points)), faceOf_(points_.size(), -1) {
    auto [a, b, c] = first;
    if (orientation(points_[a], points_[b], points_[c]) < 0) std::swap(b, c);
    // One face, and a ghost across each of its edges.
    newFace({a, b, c});
    newFace({c, b, kGhost});
    newFace({a, c, kGhost});
    newFace({b, a, kGhost});
    faces_[0].neighbour = {1, 2, 3};
    faces_[1].neighbour = {3, 2, 0};
    faces_[2].neighbour = {1, 3, 0};
    faces_[3].neighbour = {2, 1, 0};
}

std::int32_t BowyerWatson::addPoint(Vec2 p) {
    points_.push_back(p);
    faceOf_.push_back(-1);
    return static_cast<std::int32_t>(points_.size()) - 1;
}

std::int32_t BowyerWatson::newFace(std::array<std::int32_t, 3> vertex) {
    std::int32_t index = static_cast<std::int32_t>(faces_.size());
    if (free_.empty()) {
        faces_.emplace_back();
    } else {
        index = free_.back();
        free_.pop_back();
    }
    faces_[index] = {vertex, {-1, -1, -1}, true};
    for (std::int32_t v : vertex) {
        if (v != kGhost) faceOf_[v] = index;
    }
    return index;
}

// True where p lies inside the face's circumcircle. The circumcircle of a ghost is the half plane beyond its
// hull edge, with the edge itself.
bool BowyerWatson::conflicts(const Face& face, Vec2 p) const {
    for (std::size_t i = 0; i < 3; ++i) {
        if (face.vertex[i] != kGhost) continue;
        const Vec2 a = points_[face.vertex[(i + 1) % 3]];
        const Vec2 b = points_[face.vertex[(i + 2) % 3]];
        const int side = orientation(a, b, p);
        if (side != 0) return side > 0;
        return dot(p - a, p - b) < 0.0;
    }
    return inCircle(points_[face.vertex[0]], points_[face.vertex[1]], points_[face.vertex[2]], p) > 0;
}

// Point location by walking: the face reached contains p, or is a ghost across a hull edge from it.
std::int32_t BowyerWatson::findConflict(Vec2 p) const {
    std::int32_t at = last_;
    // A walk through a Delaunay triangulation never returns to a face (Edelsbrunner 1990). The bound is a
    // safeguard.
    for (std::size_t step = 0; step < faces_.size() && !isGhost(faces_[at]); ++step) {
        const Face& face = faces_[at];
        std::int32_t next = -1;
        for (std::size_t i = 0; i < 3 && next < 0; ++i) {
            const Vec2 a = points_[face.vertex[(i + 1) % 3]];
            const Vec2 b = points_[face.vertex[(i + 2) % 3]];
            if (orientation(a, b, p) < 0) next = face.neighbour[i];
        }
        if (next < 0) break;
        at = next;
    }
    if (conflicts(faces_[at], p)) return at;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        if (faces_[i].alive && conflicts(faces_[i], p)) return static_cast<std::int32_t>(i);
    }
    return -1;
}

void BowyerWatson::collectCavity(std::int32_t start, Vec2 p) {
    ++insertions_;
    cavity_.assign(1, start);
    rim_.clear();
    faces_[start].alive = false;
    for (std::size_t next = 0; next < cavity_.size(); ++next) {
        const Face face = faces_[cavity_[next]];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::int32_t across = face.neighbour[i];
            Face& other = faces_[across];
            if (!other.alive || other.tested == insertions_) continue;
            other.tested = insertions_;
            if (conflicts(other, p)) {
                other.alive = false;
                cavity_.push_back(across);
            }
        }
    }
    for (std::int32_t index : cavity_) {
        const Face& face = faces_[index];
        for (std::size_t i = 0; i < 3; ++i) {
            if (!faces_[face.neighbour[i]].alive) continue;
            rim_.push_back({face.vertex[(i + 1) % 3], face.vertex[(i + 2) % 3], face.neighbour[i]});
        }
    }
}

void BowyerWatson::replaceNeighbour(std::int32_t face, std::int32_t from, std::int32_t to,
                                    std::int32_t neighbour) {
    Face& changed = faces_[face];
    for (std::size_t i = 0; i < 3; ++i) {
        if (changed.vertex[(i + 1) % 3] == from && changed.vertex[(i + 2) % 3] == to)
            changed.neighbour[i] = neighbour;
    }
}

void BowyerWatson::fillCavity(std::int32_t point) {
    // Sorts the rim into a loop: each edge ends where the next one starts.
    for (std::size_t i = 0; i + 1 < rim_.size(); ++i) {
        std::size_t j = i + 1;
        while (j < rim_.size() && rim_[j].from != rim_[i].to) ++j;
        MUSTER_ASSERT(j < rim_.size());
        std::swap(rim_[i + 1], rim_[j]);
    }
    free_.insert(free_.end(), cavity_.rbegin(), cavity_.rend());
    cavity_.clear();
    for (const RimEdge& edge : rim_) {
        const std::int32_t face = newFace({edge.from, edge.to, point});
        faces_[face].neighbour[2] = edge.outside;
        replaceNeighbour(edge.outside, edge.to, edge.from, face);
        cavity_.push_back(face);
    }
    const std::size_t count = cavity_.size();
    for (std::size_t i = 0; i < count; ++i) {
        faces_[cavity_[i]].neighbour[0] = cavity_[(i + 1) % count];
        faces_[cavity_[i]].neighbour[1] = cavity_[(i + count - 1) % count];
        if (!isGhost(faces_[cavity_[i]])) last_ = cavity_[i];
    }
}

bool BowyerWatson::insert(std::int32_t point) {
    if (faceOf_[point] >= 0) return true;
    const std::int32_t start = findConflict(points_[point]);
    if (start < 0) return false;
    collectCavity(start, points_[point]);
    fillCavity(point);
    return true;
}

bool BowyerWatson::hasEdge(std::int32_t a, std::int32_t b) const {
    const std::int32_t start = faceOf_[a];
    std::int32_t at = start;
    do {
        const Face& face = faces_[at];
        std::size_t i = 0;
        while (face.vertex[i] != a) ++i;
        if (face.vertex[(i + 1) % 3] == b || face.vertex[(i + 2) % 3] == b) return true;
        at = face.neighbour[(i + 1) % 3];
    } while (at != start);
    return false;
}

}  // namespace muster
