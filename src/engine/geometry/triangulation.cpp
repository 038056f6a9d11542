#include "engine/geometry/triangulation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/geometry/bowyer_watson.h"
#include "engine/geometry/polygon.h"

namespace muster {
namespace {

constexpr std::int32_t kMostVertices = 20000;
// Least distance of interior points from the boundary, as a share of the spacing: it avoids flat triangles.
constexpr double kBoundaryMargin = 0.6;

struct BoundaryEdge {
    std::int32_t from;
    std::int32_t to;
};

// The outline and the holes as valid polygons; the outline first.
Result<std::vector<Polygon>> cleanLoops(const PolygonWithHoles& shape) {
    std::vector<Polygon> loops;
    Result<Polygon> outline = cleanPolygon(shape.outline);
    if (!outline.ok()) return outline.status().within("outline");
    loops.push_back(std::move(*outline));
    for (std::size_t i = 0; i < shape.holes.size(); ++i) {
        Result<Polygon> hole = cleanPolygon(shape.holes[i]);
        if (!hole.ok()) return hole.status().within("hole " + std::to_string(i));
        loops.push_back(std::move(*hole));
    }
    return loops;
}

bool loopsCross(const Polygon& a, const Polygon& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (segmentsCross(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return true;
        }
    }
    return false;
}

Status checkLoops(const std::vector<Polygon>& loops) {
    for (std::size_t i = 1; i < loops.size(); ++i) {
        const std::string name = "hole " + std::to_string(i - 1);
        if (loopsCross(loops[i], loops[0]) || !containsPoint(loops[0], loops[i][0])) {
            return invalidArgument(name + " leaves the outline");
        }
        for (std::size_t j = 1; j < i; ++j) {
            if (loopsCross(loops[i], loops[j]) || containsPoint(loops[j], loops[i][0]) ||
                containsPoint(loops[i], loops[j][0])) {
                return invalidArgument(name + " meets hole " + std::to_string(j - 1));
            }
        }
    }
    return {};
}

Status tooManyVertices() {
    return invalidArgument("the mesh would need more than 20,000 vertices; take a larger spacing");
}

// Meshes one shape: samples it, triangulates the samples and removes triangles outside.
class Mesher {
public:
    Mesher(std::vector<Polygon> loops, double spacing) : loops_(std::move(loops)), spacing_(spacing) {}

    Result<TriangleMesh> run() {
        if (Status status = sampleBoundary(); !status.ok()) return status;
        if (Status status = sampleInterior(); !status.ok()) return status;
        BowyerWatson mesh(points_, firstTriple());
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!mesh.insert(static_cast<std::int32_t>(i))) return closeSamples();
        }
        if (Status status = conform(mesh); !status.ok()) return status;
        return cutOut(mesh);
    }

private:
    static Status closeSamples() {
        return invalidArgument("two parts of the outline are too near to each other");
    }

    Status sampleBoundary() {
        for (const Polygon& loop : loops_) {
            const auto first = static_cast<std::int32_t>(points_.size());
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
                const double pieces = std::max(1.0, std::ceil(distance(a, b) / spacing_ - 1e-9));
                if (pieces + static_cast<double>(points_.size()) > kMostVertices) return tooManyVertices();
                for (double k = 0.0; k < pieces; k += 1.0) points_.push_back(lerp(a, b, k / pieces));
            }
            const auto end = static_cast<std::int32_t>(points_.size());
            for (std::int32_t i = first; i < end; ++i) edges_.push_back({i, i + 1 < end ? i + 1 : first});
        }
        boundaryCount_ = points_.size();
        return {};
    }

    bool farFromBoundary(Vec2 p) const {
        const double margin = kBoundaryMargin * spacing_;
        return std::all_of(loops_.begin(), loops_.end(), [&](const Polygon& loop) {
            return closestOnBoundary(loop, p).distance >= margin;
        });
    }

    bool insideShape(Vec2 p) const {
        if (!containsPoint(std::span(loops_[0]), p)) return false;
        return std::none_of(loops_.begin() + 1, loops_.end(),
                            [&](const Polygon& hole) { return containsPoint(std::span(hole), p); });
    }

    // A square lattice fitted to the bounding box, so that a rectangle gets a regular mesh.
    Status sampleInterior() {
        const Box box = boundsOf(loops_[0]);
        const double columns = std::max(1.0, std::ceil(box.width() / spacing_ - 1e-9));
        const double rows = std::max(1.0, std::ceil(box.height() / spacing_ - 1e-9));
        if (columns * rows > 50.0 * kMostVertices) return tooManyVertices();
        const double dx = box.width() / columns, dy = box.height() / rows;
        for (double j = 1.0; j < rows; j += 1.0) {
            for (double i = 1.0; i < columns; i += 1.0) {
                const Vec2 p = box.min + Vec2{i * dx, j * dy};
                if (!insideShape(p) || !farFromBoundary(p)) continue;
                points_.push_back(p);
                if (points_.size() > kMostVertices) return tooManyVertices();
            }
        }
        return {};
    }

    // Three points of the outline that do not lie on one line; they exist, since the area is not zero.
    std::array<std::int32_t, 3> firstTriple() const {
        const auto count = static_cast<std::int32_t>(boundaryCount_);
        for (std::int32_t i = 2; i < count; ++i) {
            if (orientation(points_[0], points_[1], points_[i]) != 0) return {0, 1, i};
        }
        return {0, 1, 2};
    }

    // Makes the triangulation conforming: halves every boundary edge that is not an edge of it, until all
    // are. Only other boundary points can be near an edge, so that few rounds are needed.
    Status conform(BowyerWatson& mesh) {
        for (bool changed = true; changed;) {
            changed = false;
            const std::size_t count = edges_.size();
            for (std::size_t i = 0; i < count; ++i) {
                const BoundaryEdge edge = edges_[i];
                if (mesh.hasEdge(edge.from, edge.to)) continue;
                if (mesh.points().size() >= kMostVertices) return tooManyVertices();
                const std::int32_t middle = mesh.addPoint(
                    lerp(mesh.points()[edge.from], mesh.points()[edge.to], 0.5));
                if (!mesh.insert(middle)) return closeSamples();
                edges_[i] = {edge.from, middle};
                edges_.push_back({middle, edge.to});
                changed = true;
            }
        }
        return {};
    }

    bool isBoundary(std::int32_t a, std::int32_t b) const {
        const std::array<std::int32_t, 2> key{std::min(a, b), std::max(a, b)};
        return std::binary_search(keys_.begin(), keys_.end(), key);
    }

    // Finds the faces inside the shape, from the hull inwards: each boundary edge crossed changes sides.
    std::vector<std::int8_t> markInside(const BowyerWatson& mesh) {
        for (BoundaryEdge e : edges_) keys_.push_back({std::min(e.from, e.to), std::max(e.from, e.to)});
        std::sort(keys_.begin(), keys_.end());
        const auto& faces = mesh.faces();
        std::vector<std::int8_t> inside(faces.size(), -1);
        std::vector<std::int32_t> queue;
        for (std::size_t i = 0; i < faces.size(); ++i) {
            if (!faces[i].alive || !BowyerWatson::isGhost(faces[i])) continue;
            inside[i] = 0;
            queue.push_back(static_cast<std::int32_t>(i));
        }
        for (std::size_t next = 0; next < queue.size(); ++next) {
            const BowyerWatson::Face& face = faces[queue[next]];
            for (std::size_t i = 0; i < 3; ++i) {
                const std::int32_t across = face.neighbour[i];
                if (inside[across] >= 0) continue;
                const bool flips = isBoundary(face.vertex[(i + 1) % 3], face.vertex[(i + 2) % 3]);
                inside[across] = static_cast<std::int8_t>(flips ? 1 - inside[queue[next]]
                                                                : inside[queue[next]]);
                queue.push_back(across);
            }
        }
        return inside;
    }

    TriangleMesh cutOut(const BowyerWatson& mesh) {
        const std::vector<std::int8_t> inside = markInside(mesh);
        std::vector<Triangle> triangles;
        std::vector<std::int32_t> number(mesh.points().size(), -1);
        for (std::size_t i = 0; i < mesh.faces().size(); ++i) {
            const BowyerWatson::Face& face = mesh.faces()[i];
            if (!face.alive || inside[i] != 1) continue;
            triangles.push_back(face.vertex);
            for (std::int32_t v : face.vertex) number[v] = 0;
        }
        TriangleMesh result;
        for (std::size_t v = 0; v < number.size(); ++v) {
            if (number[v] < 0) continue;
            number[v] = static_cast<std::int32_t>(result.vertices.size());
            result.vertices.push_back(mesh.points()[v]);
        }
        for (Triangle triangle : triangles) {
            for (std::int32_t& v : triangle) v = number[v];
            std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
            result.triangles.push_back(triangle);
        }
        std::sort(result.triangles.begin(), result.triangles.end());
        return result;
    }

    std::vector<Polygon> loops_;
    double spacing_;
    std::vector<Vec2> points_;
    std::vector<BoundaryEdge> edges_;
    std::vector<std::array<std::int32_t, 2>> keys_;
    std::size_t boundaryCount_ = 0;
};

}  // namespace

Result<TriangleMesh> triangulate(const PolygonWithHoles& shape, double spacing) {
    if (!std::isfinite(spacing) || spacing <= 0.0)
        return invalidArgument("the spacing of a mesh must be positive");
    Result<std::vector<Polygon>> loops = cleanLoops(shape);
    if (!loops.ok()) return loops.status();
    if (Status status = checkLoops(*loops); !status.ok()) return status;
    return Mesher(std::move(*loops), spacing).run();
}

}  // namespace muster
