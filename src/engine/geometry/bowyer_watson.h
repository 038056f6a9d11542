// Incremental Delaunay triangulation (Bowyer 1981; Watson 1981).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/geometry/triangulation.h"

namespace muster {

/// The triangulation of all points inserted so far. Beyond the convex hull lie ghost triangles, which share
/// one vertex at infinity: the hull needs no special cases, and no large outer triangle distorts it.
class BowyerWatson {
public:
    static constexpr std::int32_t kGhost = -1;  ///< The vertex at infinity.

    /// A triangle with its neighbours: neighbour i lies across the edge from vertex i+1 to i+2.
    struct Face {
        std::array<std::int32_t, 3> vertex;
        std::array<std::int32_t, 3> neighbour;
        bool alive = true;        ///< False once its circumcircle has held an inserted point.
        std::int32_t tested = 0;  ///< Number of the insertion whose point was tested against it last.
    };

    /// Starts from three of the points, which must not lie on one line.
    BowyerWatson(std::vector<Vec2> points, std::array<std::int32_t, 3> first);

    /// Inserts the point of that index; false where it repeats an inserted point.
    bool insert(std::int32_t point);
    /// Appends a point without inserting it; returns its index.
    std::int32_t addPoint(Vec2 p);
    /// True where an edge joins the two inserted points.
    bool hasEdge(std::int32_t a, std::int32_t b) const;
    /// All points.
    const std::vector<Vec2>& points() const { return points_; }
    /// All faces, including ghosts and those that are not alive.
    const std::vector<Face>& faces() const { return faces_; }
    /// True where one of the face's vertices is at infinity.
    static bool isGhost(const Face& face);

private:
    // An edge of the cavity's boundary.
    struct RimEdge {
        std::int32_t from;
        std::int32_t to;
        std::int32_t outside;  // The face outside the cavity.
    };

    bool conflicts(const Face& face, Vec2 p) const;
    std::int32_t findConflict(Vec2 p) const;
    void collectCavity(std::int32_t start, Vec2 p);
    void fillCavity(std::int32_t point);
    std::int32_t newFace(std::array<std::int32_t, 3> vertex);
    void replaceNeighbour(std::int32_t face, std::int32_t from, std::int32_t to, std::int32_t neighbour);

    std::vector<Vec2> points_;
    std::vector<Face> faces_;
    std::vector<std::int32_t> free_;  // Faces that are not alive, for reuse.
    std::int32_t insertions_ = 0;
    std::vector<std::int32_t> faceOf_;  // Per point: one of its faces, -1 where not inserted.
    std::vector<std::int32_t> cavity_;  // Faces whose circumcircles hold the point being inserted.
    std::vector<RimEdge> rim_;
    std::int32_t last_ = 0;  // The face at which the next point location starts.
};

}  // namespace muster
