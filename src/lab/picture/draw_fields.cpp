// Coloured rasters: the potential field, the cost field of one place, the density.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>

#include "engine/fields/cost/density.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "lab/picture/theme.h"

namespace muster {
namespace {

/// Samples of a field over the ground.
struct Samples {
    Grid grid;
    std::vector<double> values;  ///< Values in rows from the lower left; not finite where unknown.
};

Samples sample(const Pen& pen, const std::function<double(Vec2)>& value) {
    const Environment& environment = inspect::environment(pen.world);
    const double cell = std::max(environment.grid().cell, environment.grid().box().width() / 1024.0);
    Samples samples{Grid::covering(environment.def().box, cell), {}};
    samples.values.resize(samples.grid.count());
    for (std::int32_t i = 0; i < samples.grid.count(); ++i)
        samples.values[i] = value(samples.grid.centre(samples.grid.at(i)));
    return samples;
}

/// Fills unknown cells with the mean of their known neighbours, so that no background shows at walls.
void growKnown(const Grid& grid, std::vector<double>& values) {
    const std::vector<double> old = values;
    for (std::int32_t i = 0; i < grid.count(); ++i) {
        if (std::isfinite(old[i])) continue;
        double sum = 0.0;
        int known = 0;
        const Cell cell = grid.at(i);
        for (int k = 0; k < 9; ++k) {
            const Cell near{cell.x + k % 3 - 1, cell.y + k / 3 - 1};
            if (!grid.contains(near)) continue;
            const double value = old[grid.index(near)];
            if (!std::isfinite(value)) continue;
            sum += value;
            ++known;
        }
        if (known > 0) values[i] = sum / known;
    }
}

void drawSamples(const Pen& pen, const Samples& samples, double highest, double opacity, bool hideZero) {
    std::vector<Colour> colours(samples.values.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const double value = samples.values[i];
        if (!std::isfinite(value) || (hideZero && value <= 0.0)) continue;
        colours[i] = faded(pen.theme.shade(value / highest), opacity);
        if (hideZero) colours[i].opacity *= std::min(1.0, 4.0 * value / highest);
    }
    pen.draw.raster(samples.grid.box(), samples.grid.width, samples.grid.height, colours);
}

void drawContours(const Pen& pen, const Samples& samples, double step, double highest) {
    const Grid& grid = samples.grid;
    int index = 1;
    for (double level = step; level < highest; level += step, ++index) {
        const Stroke stroke = pen.stroke(faded(pen.theme.ink, index % 5 == 0 ? 0.55 : 0.22),
                                         index % 5 == 0 ? 1.5 : 1.0);
        const auto world = [&](Vec2 p) { return grid.origin + (p + Vec2{0.5, 0.5}) * grid.cell; };
        std::vector<std::vector<Vec2>> lines;
        for (const auto& [a, b] : contourSegments(grid.width, grid.height, samples.values, level))
            lines.push_back({world(a), world(b)});
        pen.draw.lines(lines, stroke);
    }
}

/// Draws a colour bar with its end values at the lower left of the picture.
void drawLegend(const Pen& pen, const std::string& title, double highest, const char* unit) {
    const Box view = pen.draw.view();
    const double px = pen.metres(1.0);
    const Vec2 at{view.min.x + 20 * px, view.min.y + 18 * px};
    const auto panel = [&](Vec2 a, Vec2 b) { return std::vector<Vec2>{a, {b.x, a.y}, b, {a.x, b.y}}; };
    pen.draw.polygon(panel(at, at + Vec2{236 * px, 58 * px}), pen.theme.panel,
                     pen.stroke(faded(pen.theme.ink, 0.12), 1.0));
    std::vector<Colour> bar;
    for (int i = 0; i < 64; ++i) bar.push_back(pen.theme.shade(i / 63.0));
    pen.draw.raster({at + Vec2{12 * px, 22 * px}, at + Vec2{224 * px, 32 * px}}, 64, 1, bar);
    char most[48];
    std::snprintf(most, sizeof(most), "%.3g %s", highest, unit);
    const double size = 12.0 * pen.unit;
    pen.draw.text(at + Vec2{12 * px, 44 * px}, title, size, pen.theme.ink, TextAnchor::Left);
    pen.draw.text(at + Vec2{12 * px, 12 * px}, "0", size, pen.theme.ink2, TextAnchor::Left);
    pen.draw.text(at + Vec2{224 * px, 12 * px}, most, size, pen.theme.ink2, TextAnchor::Right);
}

/// The place whose cost field is shown: the requested one, or that of the character with the most expensive
/// path.
std::int32_t shownPlace(const Pen& pen) {
    if (pen.def.place >= 0) return pen.def.place;
    const CharactersView characters = pen.world.characters();
    std::int32_t place = 0;
    double longest = -1.0;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        if (characters.group[i] != pen.def.group || characters.place[i] < 0) continue;
        if (std::isfinite(characters.cost[i]) && characters.cost[i] > longest) {
            longest = characters.cost[i];
            place = characters.place[i];
        }
    }
    return place;
}

/// The unit cost of the plan, or of the ground before the first plan.
UnitCost costNow(const World& world) {
    if (inspect::unitCost(world) != nullptr) return *inspect::unitCost(world);
    UnitCost cost;
    UnitCostBuilder builder;
    builder.build({}, inspect::environment(world), inspect::density(world),
                  world.parameters().character.radius, cost);
    return cost;
}

/// The path of steepest descent of the field from `at` to its source.
std::vector<Vec2> descend(const CostField& field, Vec2 at) {
    std::vector<Vec2> path{at};
    for (int i = 0; i < 4000 && distance(at, field.source()) > 0.2; ++i) {
        const Vec2 direction = field.direction(at);
        if (lengthSquared(direction) < 0.5) return path;
        at += direction * 0.1;
        if (i % 3 == 0) path.push_back(at);
    }
    path.push_back(field.source());
    return path;
}

}  // namespace

void drawPotentialField(const Pen& pen) {
    const Environment& environment = inspect::environment(pen.world);
    const auto strength = [&](Vec2 p) {
        return environment.distanceToObstacle(p, 0.01) <= 0.0 ? std::numeric_limits<double>::infinity()
                                                              : length(environment.potentialField(p));
    };
    const Samples samples = sample(pen, strength);
    double highest = 0.0;
    for (double v : samples.values) {
        if (std::isfinite(v)) highest = std::max(highest, v);
    }
    if (highest <= 0.0) return;
    Samples grown = samples;
    for (int round = 0; round < 2; ++round) growKnown(grown.grid, grown.values);
    drawSamples(pen, grown, highest, 0.85, true);
    const double gap = std::max(1.0, pen.metres(26.0));
    const Box box = environment.def().box;
    for (double y = box.min.y + gap / 2; y < box.max.y; y += gap) {
        for (double x = box.min.x + gap / 2; x < box.max.x; x += gap) {
            const Vec2 p{x, y}, force = environment.potentialField(p);
            if (length(force) < 0.02 * highest || environment.distanceToObstacle(p, 0.01) <= 0.0) continue;
            const Vec2 tip = p + clampLength(force, 1.0) * (gap * 0.75), along = normalized(force);
            const Vec2 side = perpendicular(along);
            const double head = pen.metres(5.0);
            const Stroke stroke = pen.stroke(faded(pen.theme.ink, 0.7), 1.3);
            pen.draw.line(std::vector<Vec2>{p, tip}, stroke);
            pen.draw.line(std::vector<Vec2>{tip - along * head + side * head * 0.6, tip,
                                            tip - along * head - side * head * 0.6},
                          stroke);
        }
    }
    drawLegend(pen, "Potential field", highest, "");
}

void drawCostField(const Pen& pen) {
    if (pen.def.group >= pen.world.groupCount()) return;
    const auto places = pen.world.group(pen.def.group).placePositions;
    const std::int32_t place = shownPlace(pen);
    if (static_cast<std::size_t>(place) >= places.size()) return;
    EikonalSolver solver;
    CostField field;
    solver.solve(costNow(pen.world), places[place], {}, field);
    const Samples samples = sample(pen, [&](Vec2 p) { return field.cost(p); });
    double highest = 0.0;
    for (double v : samples.values) {
        if (std::isfinite(v)) highest = std::max(highest, v);
    }
    if (highest <= 0.0) return;
    Samples grown = samples;
    for (int round = 0; round < 3; ++round) growKnown(grown.grid, grown.values);
    drawSamples(pen, grown, highest, 1.0, false);
    drawContours(pen, samples, highest > 60.0 ? 5.0 : 1.0, highest);
    drawLegend(pen, "Cost to place " + std::to_string(place), highest, "m");
    const CharactersView characters = pen.world.characters();
    for (std::size_t i = 0; i < characters.size(); ++i) {
        if (characters.group[i] != pen.def.group || characters.place[i] != place) continue;
        const auto path = descend(field, characters.position[i]);
        pen.draw.line(path, pen.stroke(Colour::of(0xFFFFFF), 5.5));
        pen.draw.line(path, pen.stroke(pen.accent(pen.def.group), 2.6));
    }
    pen.draw.disc(field.source(), pen.metres(8.0), pen.accent(pen.def.group),
                  pen.stroke(Colour::of(0xFFFFFF), 2.5));
}

void drawDensity(const Pen& pen) {
    const DensityField& density = inspect::density(pen.world);
    if (density.grid().count() == 0) return;
    const Samples samples = sample(pen, [&](Vec2 p) { return static_cast<double>(density.densityAt(p)); });
    const double highest = std::max(1.0, *std::max_element(samples.values.begin(), samples.values.end()));
    drawSamples(pen, samples, highest, 0.9, true);
    drawLegend(pen, "Density", highest, "per m2");
}

}  // namespace muster
