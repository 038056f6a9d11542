// Incremental Delaunay triangulation that can be added to (Bowyer 1981, Watson 1981).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/triangulation.h"

namespace muster {

/// Keeps the triangulation of all points added so far. Beyond the hull lie ghost triangles that share
/// one vertex at infinity, so the hull needs no special care and no outer triangle distorts it.
class BowyerWatson {
public:
    static constexpr std::int32_t kGhost = -1;  ///< The vertex at infinity.

    /// A triangle with its neighbours: neighbour i lies across the edge from vertex i+1 to i+2.
    struct Face {
        std::array<std::int32_t, 3> vertex;
        std::array<std::int32_t, 3> neighbour;
        bool alive = true;
    };

    /// Starts from three points that do not lie on one line.
    BowyerWatson(std::vector<Vec2> points, std::array<std::int32_t, 3> first);

    /// Adds the point with that number; false where it repeats a point that is there already.
    bool insert(std::int32_t point);
    /// Appends a point and returns its number; insert() still has to be called.
    std::int32_t addPoint(Vec2 p);
    /// True where the two points are joined by an edge.
    bool hasEdge(std::int32_t a, std::int32_t b) const;
    /// All points.
    const std::vector<Vec2>& points() const { return points_; }
    /// All faces, dead and ghost ones too.
    const std::vector<Face>& faces() const { return faces_; }
    /// True where one of the face's vertices is at infinity.
    static bool isGhost(const Face& face);

private:
    struct RimEdge {
        std::int32_t from;
        std::int32_t to;
        std::int32_t outside;  // Face across.
    };

    bool conflicts(const Face& face, Vec2 p) const;
    std::int32_t findConflict(Vec2 p) const;
    void collectCavity(std::int32_t start, Vec2 p);
    void fillCavity(std::int32_t point);
    std::int32_t newFace(std::array<std::int32_t, 3> vertex);
    void replaceNeighbour(std::int32_t face, std::int32_t from, std::int32_t to, std::int32_t neighbour);

    std::vector<Vec2> points_;
    std::vector<Face> faces_;
    std::vector<std::int32_t> free_;
    std::vector<std::int32_t> faceOf_;  // Some face at each point, -1 where not inserted.
    std::vector<std::int32_t> cavity_;
    std::vector<RimEdge> rim_;
    std::int32_t last_ = 0;  // Where the next walk starts.
};

}  // namespace muster
