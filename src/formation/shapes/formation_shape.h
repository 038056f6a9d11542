// Places of the named shapes and the outlines of their meshes, before both are joined.
#pragma once

#include <vector>

#include "formation/shapes/formation.h"

namespace muster {

/// Where the places lie and what the mesh must cover. A mesh without outline covers the box of the
/// places with a uniform strip of triangles.
struct Layout {
    std::vector<Vec2> places;  ///< [m], any order.
    PolygonWithHoles outline;  ///< Empty for a rectangle.
};

/// As many files as ranks; a short rear rank is centred.
Layout squareLayout(std::int32_t count, double spacing);
Layout lineLayout(std::int32_t count, double spacing);    ///< Two ranks abreast.
Layout columnLayout(std::int32_t count, double spacing);  ///< Two files along the heading.
Layout wedgeLayout(std::int32_t count, double spacing);   ///< Filled triangle with its tip in front.
Layout ringLayout(std::int32_t count, double spacing);    ///< Concentric circles round an open middle.
Layout circleLayout(std::int32_t count, double spacing);  ///< Filled disc.
/// Thick arc, open towards the front by the angle `opening` [rad].
Layout crescentLayout(std::int32_t count, double spacing, double opening);
/// Disc with a mouth of the angle `opening` [rad] towards the front.
Layout pacmanLayout(std::int32_t count, double spacing, double opening);
/// The clean shape scaled until it holds the count on a triangular lattice. Fails with InvalidArgument
/// where no scale does.
Result<Layout> outlineLayout(std::int32_t count, double spacing, const PolygonWithHoles& shape);

/// The convex hull of the points, grown by `margin` [m] (round corners of eight sides).
Polygon grownHull(std::span<const Vec2> points, double margin);

/// Meshes the layout with at most about 400 vertices, wherever the places lie; where its outline
/// leaves a place uncovered or cannot be meshed, the grown hull of the places is meshed instead.
Result<TriangleMesh> meshLayout(const Layout& layout, double spacing);

}  // namespace muster
