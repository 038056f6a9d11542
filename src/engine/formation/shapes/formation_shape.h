// Shapes of formations: places and the outline of the mesh, before the mesh is made.
#pragma once

#include <vector>

#include "engine/formation/shapes/make_formation.h"

namespace muster {

/// The places of a shape and the outline of its mesh.
struct FormationShape {
    std::vector<Vec2> places;  ///< Places in any order [m].
    PolygonWithHoles outline;  ///< Outline of the mesh [m]; empty for the box of the places.
};

/// A square of `files` files, for 0 as many as ranks; a short rear rank is centred.
FormationShape squareShape(std::int32_t count, double spacing, std::int32_t files = 0);
FormationShape lineShape(std::int32_t count, double spacing);    ///< Two ranks abreast.
FormationShape columnShape(std::int32_t count, double spacing);  ///< Two files along the heading.
FormationShape wedgeShape(std::int32_t count, double spacing);   ///< Filled triangle with its tip in front.
FormationShape ringShape(std::int32_t count, double spacing);    ///< Concentric circles round an open middle.
FormationShape circleShape(std::int32_t count, double spacing);  ///< Filled disc.
/// Thick arc, open towards the front by the angle `opening` [rad].
FormationShape crescentShape(std::int32_t count, double spacing, double opening);
/// Disc with a mouth of the angle `opening` [rad] towards the front.
FormationShape pacmanShape(std::int32_t count, double spacing, double opening);
/// A clean outline scaled until it holds the count on a triangular lattice. Fails with InvalidArgument where
/// no scale does.
Result<FormationShape> outlineShape(std::int32_t count, double spacing, const PolygonWithHoles& outline);

/// The convex hull of the points, grown by `margin` [m]; its round corners have eight sides per turn.
Polygon grownHull(std::span<const Vec2> points, double margin);

/// Meshes a shape with at most about 400 vertices: a box by a regular grid, another outline by a Delaunay
/// triangulation. Where an outline leaves a place uncovered or cannot be meshed, the grown hull of the places
/// is meshed instead. Finds the places on the mesh.
Result<Formation> meshShape(const FormationShape& shape, double spacing);

}  // namespace muster
