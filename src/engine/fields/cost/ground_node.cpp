#include "engine/fields/cost/ground_node.h"

#include <cmath>

namespace muster {
namespace {

// Least slope of the clearance away from a wall; where it is flatter the cell lies between two walls.
constexpr double kLeastSlope = 0.7;
// Largest misfit of a model of the clearance that is accepted [cells].
constexpr double kMaxMisfit = 0.05;

// One-sided difference along an axis, on the side where the clearance rises more; 0 at a maximum.
double risingSlope(double here, double after, double before) {
    if (after <= here && before <= here) return 0.0;
    return after >= before ? after - here : here - before;
}

// One-sided difference along an axis, on the side where the clearance falls more; 0 at a minimum.
double fallingSlope(double here, double after, double before) {
    if (after >= here && before >= here) return 0.0;
    return after <= before ? after - here : here - before;
}

double centralSlope(double oneSided, double after, double before) {
    return after > 0.0 && before > 0.0 ? 0.5 * (after - before) : oneSided;
}

}  // namespace

GroundNode GroundNodeFinder::find(Cell cell) const {
    if (!ground_.grid.contains(cell)) return {};
    const double edge = ground_.grid.cell;
    const double here = at(cell.x, cell.y);
    const double depth = (radius_ - here) / edge;  // Depth of the centre in the forbidden zone [cells].
    constexpr double kWidestBand = 0.70710678118654752;
    if (depth <= -kWidestBand) return {.free = true};
    if (depth > kWidestBand || !(here > 0.0)) return {};
    Vec2 gradient;
    const bool oneWall = clearanceGradient(cell, depth <= 0.0, gradient);
    const double steepness = length(gradient);
    // In the very middle of a thin wall no side is nearer than the other.
    if (oneWall && !(steepness > 1e-6 * edge)) return {.free = depth <= 0.0};
    // Cells whose centres lie within the band form a 4-connected chain along the wall.
    const double band = oneWall ? 0.5 * (std::fabs(gradient.x) + std::fabs(gradient.y)) / steepness : 0.0;
    // Of two cells whose centres lie symmetrically about the wall only one gets a wall node.
    constexpr double kTieBreak = 1e-4;
    if (depth > band + kTieBreak) return {};
    if (depth < -band + kTieBreak || !oneWall) return {.free = depth <= 0.0};
    const Vec2 away = refineNormal(cell, gradient / steepness);
    return {true, static_cast<float>(depth * away.x), static_cast<float>(depth * away.y),
            static_cast<float>(away.x), static_cast<float>(away.y)};
}

// The gradient of the clearance per cell at a cell near one wall; false where the cell lies between two
// walls. For a centre that is free the gradient towards its own wall is accepted there.
bool GroundNodeFinder::clearanceGradient(Cell cell, bool free, Vec2& gradient) const {
    const double here = at(cell.x, cell.y);
    const double east = at(cell.x + 1, cell.y);
    const double west = at(cell.x - 1, cell.y);
    const double north = at(cell.x, cell.y + 1);
    const double south = at(cell.x, cell.y - 1);
    const double least = kLeastSlope * kLeastSlope * ground_.grid.cell * ground_.grid.cell;
    gradient = {risingSlope(here, east, west), risingSlope(here, north, south)};
    if (lengthSquared(gradient) >= least) {
        // Central differences give the direction better where both neighbours lie outside obstacles.
        gradient = {centralSlope(gradient.x, east, west), centralSlope(gradient.y, north, south)};
        return true;
    }
    if (free) gradient = {fallingSlope(here, east, west), fallingSlope(here, north, south)};
    return free && lengthSquared(gradient) >= least;
}

GroundNodeFinder::Slope GroundNodeFinder::slopeOf(double here, Cell after, Cell before) const {
    const double edge = ground_.grid.cell;
    const double a = ground_.grid.contains(after) ? at(after.x, after.y) / edge : 0.0;
    const double b = ground_.grid.contains(before) ? at(before.x, before.y) / edge : 0.0;
    const double higher = std::max(a, b);
    const double side = a >= b ? 1.0 : -1.0;
    return {side * (higher - here), side * (higher * higher - here * here - 1.0) / (2.0 * here),
            (a * a - b * b) / (4.0 * here), a > 0.0 && b > 0.0, a >= b ? 1 : -1};
}

// A better normal than the gradient of the clearance: that of a straight wall or of a corner, whichever
// fits the neighbours and the diagonal neighbour outside; `coarse` where none fits. The clearance rises
// by a metre per metre, so that the slopes of a good model have length 1.
Vec2 GroundNodeFinder::refineNormal(Cell cell, Vec2 coarse) const {
    const double here = at(cell.x, cell.y) / ground_.grid.cell;
    const Slope x = slopeOf(here, {cell.x + 1, cell.y}, {cell.x - 1, cell.y});
    const Slope y = slopeOf(here, {cell.x, cell.y + 1}, {cell.x, cell.y - 1});
    const double diagonal = at(cell.x + x.outer, cell.y + y.outer) / ground_.grid.cell;
    double best = kMaxMisfit;
    Vec2 found = coarse;
    const auto tryModel = [&](Vec2 slope, bool corner) {
        const double rise = slope.x * x.outer + slope.y * y.outer;
        const double expected = corner ? std::sqrt(std::max(0.0, here * here + 2.0 * here * rise + 2.0))
                                       : here + rise;
        const double misfit = std::fabs(lengthSquared(slope) - 1.0) + std::fabs(diagonal - expected);
        if (!(misfit < best)) return;
        best = misfit;
        found = slope;
    };
    tryModel({x.bothOutside ? x.central : x.wall, y.bothOutside ? y.central : y.wall}, false);
    tryModel({x.bothOutside ? x.central : x.corner, y.bothOutside ? y.central : y.corner}, true);
    tryModel({x.wall, y.wall}, false);
    tryModel({x.corner, y.corner}, true);
    return normalized(found);
}

}  // namespace muster
