// Meshes of formation shapes.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/formation/shapes/formation_shape.h"
#include "engine/geometry/mesh_locator.h"

namespace muster {
namespace {

constexpr double kMaxVertices = 400.0;

// A regular grid of cells, each cut into two triangles with alternating diagonals.
TriangleMesh gridMesh(const Box& box, std::int32_t columns, std::int32_t rows) {
    TriangleMesh mesh;
    const auto vertex = [&](std::int32_t i, std::int32_t j) { return j * (columns + 1) + i; };
    for (std::int32_t j = 0; j <= rows; ++j)
        for (std::int32_t i = 0; i <= columns; ++i)
            mesh.vertices.push_back(
                {box.min.x + box.width() * i / columns, box.min.y + box.height() * j / rows});
    for (std::int32_t j = 0; j < rows; ++j) {
        for (std::int32_t i = 0; i < columns; ++i) {
            const std::int32_t a = vertex(i, j);
            const std::int32_t b = vertex(i + 1, j);
            const std::int32_t c = vertex(i + 1, j + 1);
            const std::int32_t d = vertex(i, j + 1);
            if ((i + j) % 2 == 0)
                mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
            else
                mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
        }
    }
    return mesh;
}

TriangleMesh rectangleMesh(const std::vector<Vec2>& places, double spacing) {
    const Box box = boundsOf(places).grown(0.5 * spacing);
    const double step = std::max(spacing, std::sqrt(box.width() * box.height() / 320.0));
    const double columns = std::max(1.0, std::floor(box.width() / step + 0.5));
    const double rows = std::max(1.0, std::floor(box.height() / step + 0.5));
    // A long thin rectangle gets fewer, longer cells along its length.
    const double mostColumns = std::floor(kMaxVertices / (rows + 1.0)) - 1.0;
    const double mostRows = std::floor(kMaxVertices / (columns + 1.0)) - 1.0;
    const bool wide = columns >= rows;
    return gridMesh(box, static_cast<std::int32_t>(wide ? std::min(columns, mostColumns) : columns),
                    static_cast<std::int32_t>(wide ? rows : std::min(rows, mostRows)));
}

double perimeter(const Polygon& polygon) {
    double sum = 0.0;
    for (std::size_t k = 0; k < polygon.size(); ++k)
        sum += distance(polygon[k], polygon[(k + 1) % polygon.size()]);
    return sum;
}

Formation formationOn(TriangleMesh mesh, const std::vector<Vec2>& places) {
    Formation formation;
    formation.mesh = std::move(mesh);
    const MeshLocator locator(formation.mesh.triangles, formation.mesh.vertices);
    formation.places.reserve(places.size());
    for (const Vec2 p : places) formation.places.push_back(locator.locate(p));
    return formation;
}

// True where the mesh covers the points for which its places stand.
bool covers(const Formation& formation, const std::vector<Vec2>& points, double spacing) {
    const TriangleMesh& mesh = formation.mesh;
    for (std::size_t k = 0; k < points.size(); ++k)
        if (distance(formation.places[k].position(mesh.triangles, mesh.vertices), points[k]) > 1e-9 * spacing)
            return false;
    return true;
}

Result<TriangleMesh> outlineMesh(const PolygonWithHoles& outline, double spacing) {
    double area = signedArea(outline.outline);
    double around = perimeter(outline.outline);
    for (const Polygon& hole : outline.holes) {
        area -= std::fabs(signedArea(hole));
        around += perimeter(hole);
    }
    double step = std::max({spacing, std::sqrt(std::max(0.0, area) / 220.0), around / 180.0});
    // Detailed outlines need more vertices than estimated, so the step is enlarged up to three times.
    for (int k = 0;; ++k, step *= 1.3) {
        Result<TriangleMesh> mesh = triangulate(outline, step);
        if (k == 3 || !mesh.ok() || static_cast<double>(mesh->vertices.size()) <= kMaxVertices) return mesh;
    }
}

}  // namespace

Polygon grownHull(std::span<const Vec2> points, double margin) {
    const double c = std::sqrt(0.5);
    // Corners of an octagon whose sides lie at the margin.
    const double reach = margin / 0.92387953251128674;
    const Vec2 directions[8] = {{1, 0}, {c, c}, {0, 1}, {-c, c}, {-1, 0}, {-c, -c}, {0, -1}, {c, -c}};
    std::vector<Vec2> grown;
    const Polygon hull = convexHull(points);
    for (const Vec2 p : hull.empty() ? std::vector<Vec2>(points.begin(), points.end()) : hull)
        for (const Vec2 d : directions) grown.push_back(p + d * reach);
    return convexHull(grown);
}

Result<Formation> meshShape(const FormationShape& shape, double spacing) {
    if (shape.outline.outline.empty()) return formationOn(rectangleMesh(shape.places, spacing), shape.places);
    Result<TriangleMesh> mesh = outlineMesh(shape.outline, spacing);
    if (mesh.ok()) {
        Formation formation = formationOn(std::move(*mesh), shape.places);
        if (covers(formation, shape.places, spacing)) return formation;
    }
    mesh = outlineMesh({grownHull(shape.places, 0.5 * spacing), {}}, spacing);
    if (!mesh.ok()) return mesh.status();
    return formationOn(std::move(*mesh), shape.places);
}

}  // namespace muster
