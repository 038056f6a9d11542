// Ground grid, obstacles and patches.
#include <algorithm>
#include <cmath>

#include "engine/geometry/polygon.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "lab/picture/canvas.h"
#include "lab/picture/theme.h"

namespace muster {
namespace {

/// Parallel lines at 45 degrees inside a convex polygon, `gap` [m] apart.
void hatch(const Pen& pen, const Polygon& corners, double gap, const Stroke& stroke) {
    const Box box = boundsOf(corners);
    const double low = box.min.x - box.max.y, high = box.max.x - box.min.y;
    std::vector<std::vector<Vec2>> lines;
    for (double c = std::ceil(low / gap) * gap; c < high; c += gap) {
        std::vector<Vec2> hits;  // Points where x - y = c crosses the edges.
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Vec2 a = corners[i], b = corners[(i + 1) % corners.size()];
            const double da = a.x - a.y - c, db = b.x - b.y - c;
            if ((da < 0.0) != (db < 0.0)) hits.push_back(lerp(a, b, da / (da - db)));
        }
        if (hits.size() == 2) lines.push_back(std::move(hits));
    }
    pen.draw.lines(lines, stroke);
}

Colour patchColour(const Theme& theme, const std::string& motion) {
    if (motion == "swim") return theme.water;
    if (motion == "crawl") return theme.net;
    if (motion == "climb") return theme.brick;
    if (motion == "duck") return theme.branch;
    if (motion == "jump") return theme.jump;
    return theme.plain;
}

/// Draws the texture of a patch's floor: a net's meshes, waves, bricks.
void patchTexture(const Pen& pen, const Polygon& corners, const std::string& motion, Colour colour) {
    const Box box = boundsOf(corners);
    const Stroke fine = pen.stroke(faded(colour, 0.30), 1.0);
    std::vector<std::vector<Vec2>> lines;
    const auto inside = [&](Vec2 a, Vec2 b) {
        if (containsPoint(corners, a) && containsPoint(corners, b)) lines.push_back({a, b});
    };
    if (motion == "crawl") {
        for (double x = box.min.x + 0.5; x < box.max.x; x += 0.5) inside({x, box.min.y}, {x, box.max.y});
        for (double y = box.min.y + 0.5; y < box.max.y; y += 0.5) inside({box.min.x, y}, {box.max.x, y});
    } else if (motion == "swim") {
        int row = 0;
        for (double y = box.min.y + 0.45; y < box.max.y; y += 0.7, ++row) {
            for (double x = box.min.x + (row % 2 == 0 ? 0.3 : 1.1); x + 0.8 < box.max.x; x += 1.6) {
                std::vector<Vec2> wave;
                for (int k = 0; k <= 8; ++k) wave.push_back({x + 0.1 * k, y + 0.09 * std::sin(k * 0.785398)});
                if (containsPoint(corners, wave.front()) && containsPoint(corners, wave.back()))
                    lines.push_back(std::move(wave));
            }
        }
    } else if (motion == "climb") {
        int row = 0;
        for (double y = box.min.y; y < box.max.y; y += 0.5, ++row) {
            if (row > 0) inside({box.min.x, y}, {box.max.x, y});
            for (double x = box.min.x + (row % 2 == 0 ? 0.4 : 0.8); x < box.max.x; x += 0.8)
                inside({x, y}, {x, std::min(y + 0.5, box.max.y)});
        }
    }
    pen.draw.lines(lines, fine);
}

}  // namespace

void drawGroundLines(const Pen& pen) {
    const Box box = inspect::environment(pen.world).def().box;
    const double step = pen.draw.pixel() * 5.0 > 1.0 ? 25.0 : 5.0;
    const bool fine = pen.draw.pixel() * 12.0 < 1.0;
    std::vector<std::vector<Vec2>> thin, thick;
    const auto add = [&](double value, Vec2 from, Vec2 to) {
        if (std::fmod(value, step) == 0.0)
            thick.push_back({from, to});
        else if (fine)
            thin.push_back({from, to});
    };
    const double each = fine ? 1.0 : step;
    for (double x = std::ceil(box.min.x / each) * each; x <= box.max.x; x += each)
        add(x, {x, box.min.y}, {x, box.max.y});
    for (double y = std::ceil(box.min.y / each) * each; y <= box.max.y; y += each)
        add(y, {box.min.x, y}, {box.max.x, y});
    pen.draw.lines(thin, pen.stroke(pen.theme.gridFine, 1.0));
    pen.draw.lines(thick, pen.stroke(pen.theme.gridCoarse, 1.0));
}

void drawObstacles(const Pen& pen) {
    const auto pieces = inspect::environment(pen.world).pieces();
    const auto& theme = pen.theme;
    for (const ObstaclePiece& piece : pieces) {  // All shadows come first, so that obstacles cover them.
        const ObstacleDef* def = inspect::environment(pen.world).obstacle(piece.obstacle);
        const double length = 0.16 * std::min(def != nullptr ? def->height : 3.0, 3.2);
        const Vec2 cast{length, -0.6 * length};
        if (piece.corners.empty()) {
            pen.draw.disc(piece.centre + cast, piece.radius, theme.shadow, {});
            continue;
        }
        std::vector<Vec2> both = piece.corners;
        for (Vec2 p : piece.corners) both.push_back(p + cast);
        pen.draw.polygon(convexHull(both), theme.shadow, {});
    }
    const Stroke edge = pen.stroke(theme.obstacleEdge, 1.6), lines = pen.stroke(theme.hatch, 1.0);
    for (const ObstaclePiece& piece : pieces) {
        if (piece.corners.empty()) {
            pen.draw.disc(piece.centre, piece.radius, theme.obstacleFill, edge);
        } else {
            pen.draw.polygon(piece.corners, theme.obstacleFill, edge);
        }
    }
    // Draws roofs without outlines over the seams between the pieces of an obstacle.
    for (const ObstaclePiece& piece : pieces) {
        if (piece.corners.empty()) continue;
        pen.draw.polygon(piece.corners, theme.obstacleFill, {});
        if (pen.metres(14.0) < 4.0) hatch(pen, piece.corners, pen.metres(14.0), lines);
    }
}

void drawPatches(const Pen& pen) {
    const Environment& environment = inspect::environment(pen.world);
    const auto& clips = environment.def().clips;
    for (PatchId id : environment.patchIds()) {
        const PatchDef& def = *environment.patch(id);
        const Polygon corners = environment.patchPolygon(id);
        const std::string& motion = clips[def.motion].name;
        const Colour colour = patchColour(pen.theme, motion);
        pen.draw.polygon(corners, faded(colour, 0.20), {});
        patchTexture(pen, corners, motion, colour);
        pen.draw.polygon(corners, {}, pen.stroke(faded(colour, 0.9), 1.6, 6.0));
    }
}

/// Draws items as discs, and collected items as rings.
void drawItems(const Pen& pen) {
    const auto items = pen.world.items();
    const auto collected = pen.world.collected();
    const Colour colour = pen.theme.accents[1];
    for (std::size_t k = 0; k < items.size(); ++k) {
        const bool there = collected[k] == 0;
        pen.draw.disc(items[k].position, items[k].radius, faded(colour, there ? 0.25 : 0.0),
                      pen.stroke(faded(colour, there ? 0.9 : 0.35), 1.4));
        if (there) pen.draw.disc(items[k].position, 0.5 * items[k].radius, colour, {});
    }
}

/// Draws one label per name, at the upper edge of the first patch with that name.
void drawPatchTags(const Pen& pen) {
    const Environment& environment = inspect::environment(pen.world);
    std::vector<std::string> named;
    for (PatchId id : environment.patchIds()) {
        const std::string& name = environment.patch(id)->name;
        const Box box = boundsOf(environment.patchPolygon(id));
        const bool again = std::find(named.begin(), named.end(), name) != named.end();
        const double half = pen.metres(4.2 * static_cast<double>(plainLetters(name).size()) + 9.0),
                     high = pen.metres(10.0);
        if (again || name.empty() || box.width() < 2.0 * half) continue;
        named.push_back(name);
        const Vec2 at{(box.min.x + box.max.x) * 0.5,
                      std::min(box.max.y, pen.draw.view().max.y - 2.0 * high) - high * 0.2};
        const Polygon tag{{at.x - half, at.y - high},
                          {at.x + half, at.y - high},
                          {at.x + half, at.y + high},
                          {at.x - half, at.y + high}};
        pen.draw.polygon(tag, pen.theme.panel, pen.stroke(faded(pen.theme.ink, 0.12), 1.0));
        pen.draw.text(at, name, 12.0 * pen.unit, pen.theme.ink, TextAnchor::Centre);
    }
}

}  // namespace muster
