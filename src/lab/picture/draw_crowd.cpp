// Meshes, places, paths, controls and characters.
#include <algorithm>

#include "engine/formation/mesh/formation_mesh.h"
#include "engine/formation/places/place_tracker.h"
#include "engine/world/inspect.h"
#include "lab/picture/theme.h"
#include "muster/views.h"

namespace muster {
namespace {

std::vector<Vec2> loopPoints(const std::vector<std::int32_t>& loop, const std::vector<Vec2>& vertices) {
    std::vector<Vec2> points;
    for (std::int32_t v : loop) points.push_back(vertices[v]);
    return points;
}

void drawHandle(const Pen& pen, ControlKind kind, Vec2 at, Colour accent) {
    const Stroke casing = pen.stroke(Colour::of(0xFFFFFF), 2.5);
    if (kind == ControlKind::Area) {
        const double half = pen.metres(8.0);
        pen.draw.polygon(std::vector<Vec2>{at + Vec2{-half, -half}, at + Vec2{half, -half},
                                           at + Vec2{half, half}, at + Vec2{-half, half}},
                         accent, casing);
        return;
    }
    pen.draw.disc(at, pen.metres(kind == ControlKind::Point ? 11.0 : 8.0), accent, casing);
    if (kind == ControlKind::Point) pen.draw.disc(at, pen.metres(3.5), Colour::of(0xFFFFFF), {});
}

void drawControl(const Pen& pen, const Control& control, Colour accent) {
    std::vector<Vec2> held;
    for (const ControlPoint& point : control.points) held.push_back(point.position);
    if (control.kind == ControlKind::Area) {
        const Polygon hull = convexHull(held);
        pen.draw.polygon(hull, faded(accent, 0.17), pen.stroke(accent, 3.0));
    } else if (control.kind == ControlKind::Line) {
        pen.draw.line(held, pen.stroke(Colour::of(0xFFFFFF), 10.0));
        pen.draw.line(held, pen.stroke(accent, 5.5));
    }
    for (Vec2 at : held) drawHandle(pen, control.kind, at, accent);
}

}  // namespace

void drawMeshes(const Pen& pen) {
    for (std::size_t g = 0; g < pen.world.groupCount(); ++g) {
        const FormationMesh& mesh = inspect::mesh(pen.world, g);
        const TriangleMesh& rest = mesh.formation().mesh;
        const auto& vertices = mesh.finalMesh();
        const auto loops = boundaryLoops(rest);
        std::vector<std::vector<Vec2>> outline;
        for (const auto& loop : loops) outline.push_back(loopPoints(loop, vertices));
        pen.draw.area(outline, pen.accent(g, 0.09), {});
        const Stroke inner = pen.stroke(pen.accent(g, 0.34), 1.0);
        std::vector<std::vector<Vec2>> edges;
        for (const Triangle& t : rest.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                const std::int32_t a = t[k], b = t[(k + 1) % 3];
                if (a > b) continue;  // Each inner edge has two triangles of opposite orientation.
                edges.push_back({vertices[a], vertices[b]});
            }
        }
        pen.draw.lines(edges, inner);
        pen.draw.area(outline, {}, pen.stroke(pen.accent(g, 0.85), 2.0));
    }
}

void drawPlaces(const Pen& pen) {
    for (std::size_t g = 0; g < pen.world.groupCount(); ++g) {
        const PlaceTracker& places = inspect::places(pen.world, g);
        const double reach = 0.14;
        for (std::size_t i = 0; i < places.positions().size(); ++i) {
            const Vec2 at = places.positions()[i];
            pen.draw.disc(at, 0.24, {}, pen.stroke(pen.accent(g, 0.5), 1.5));
            if (places.fit()[i] != 0) continue;
            const Stroke cross = pen.stroke(pen.accent(g, 0.7), 1.5);
            pen.draw.line(std::vector<Vec2>{at + Vec2{-reach, -reach}, at + Vec2{reach, reach}}, cross);
            pen.draw.line(std::vector<Vec2>{at + Vec2{-reach, reach}, at + Vec2{reach, -reach}}, cross);
        }
    }
}

void drawTrails(const Pen& pen) {
    const CharactersView characters = pen.world.characters();
    for (std::size_t i = 0; i < pen.def.trails.size() && i < characters.size(); ++i)
        pen.draw.line(pen.def.trails[i], pen.stroke(pen.accent(characters.group[i], 0.30), 1.4));
}

void drawPaths(const Pen& pen) {
    for (std::size_t g = 0; g < pen.world.groupCount(); ++g) {
        for (const Control& control : pen.world.group(g).controls) {
            for (const ControlPoint& point : control.points) {
                std::vector<Vec2> path{point.position};
                for (const Checkpoint& checkpoint : point.trajectory) path.push_back(checkpoint.position);
                if (path.size() < 2) continue;
                pen.draw.line(path, pen.stroke(Colour::of(0xFFFFFF, 0.9), 5.0));
                pen.draw.line(path, pen.stroke(pen.accent(g), 2.2));
                for (std::size_t k = 1; k < path.size(); ++k) {
                    const bool next = k == 1;
                    pen.draw.disc(path[k], pen.metres(next ? 5.5 : 3.0),
                                  next ? pen.accent(g) : Colour::of(0xFFFFFF),
                                  pen.stroke(pen.accent(g), 1.4));
                }
            }
        }
    }
}

void drawControls(const Pen& pen) {
    for (std::size_t g = 0; g < pen.world.groupCount(); ++g) {
        for (const Control& control : pen.world.group(g).controls) drawControl(pen, control, pen.accent(g));
    }
}

void drawCharacters(const Pen& pen) {
    const CharactersView characters = pen.world.characters();
    // Characters are drawn larger than life where the scale is small.
    const double radius = std::max(pen.world.parameters().character.radius, pen.metres(3.5));
    for (std::size_t i = 0; i < characters.size(); ++i)
        pen.draw.disc(characters.position[i] + Vec2{0.4, -0.28} * radius, radius, pen.theme.shadow, {});
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const Vec2 at = characters.position[i], ahead = characters.heading[i];
        const Colour accent = pen.accent(characters.group[i]);
        // The shoulders, then the head a little ahead of their centre.
        pen.draw.disc(at, radius, accent, pen.stroke(Colour::of(0xFFFFFF, 0.85), 1.2));
        const Vec2 side = perpendicular(ahead);
        const std::vector<Vec2> nose{at + ahead * radius * 0.95,
                                     at + ahead * radius * 0.25 + side * radius * 0.5,
                                     at + ahead * radius * 0.25 - side * radius * 0.5};
        pen.draw.polygon(nose, Colour::of(0xFFFFFF, 0.92), {});
    }
}

}  // namespace muster
