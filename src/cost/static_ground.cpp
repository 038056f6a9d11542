#include "cost/static_ground.h"

#include <algorithm>
#include <cmath>

#include "base/bilinear.h"
#include "cost/chamfer_distance.h"
#include "cost/ground_cost.h"

namespace muster {
namespace {

constexpr double kHalfDiagonal = 0.70710678118654752;  // Of a cell of edge 1.
constexpr float kFarAway = 1e6f;                       // More cells than any distance on a grid.
constexpr std::int32_t kBlock = 4;  // Edge of a block for clearances beyond the limit [cells].
// Lines of sight may enter walls by this much, because of rounding [m].
constexpr double kPenetration = 0.02;
// Least step of sphere tracing [m].
constexpr double kLeastStep = 0.12;
// Clearances below this are interpolated, which is slower but more precise [m].
constexpr double kInterpolated = 0.75;

}  // namespace

void StaticGround::update(const Environment& environment, double openCost, double radius) {
    if (environmentVersion_ == environment.staticVersion() && openCost_ == openCost && radius_ == radius &&
        grid_ == environment.grid())
        return;
    environmentVersion_ = environment.staticVersion();
    openCost_ = openCost;
    radius_ = radius;
    grid_ = environment.grid();
    ++version_;
    perCell_ = 1.0 / grid_.cell;
    halfDiagonal_ = kHalfDiagonal * grid_.cell;
    const std::span<const float> clearance = environment.staticClearance();
    const std::span<const float> patchSpeed = environment.staticPatchSpeed();
    speed_.resize(patchSpeed.size());
    unit_.resize(patchSpeed.size());
    for (std::size_t k = 0; k < patchSpeed.size(); ++k) {
        speed_[k] = patchSpeed[k] < kUnreachableCost ? patchSpeed[k] : 1.0f;
        unit_[k] = static_cast<float>(openCost / speed_[k]);
    }
    computeLevel(fine_, {grid_, clearance, speed_});
    computeUniformClearance();
    open_ = environment.obstacleIds().empty() && environment.patchIds().empty();
    computeMiddle(clearance);
    computeCoarse();
}

void StaticGround::computeLevel(GroundLevel& level, const GroundRasters& rasters) {
    UnitCost& cost = level.cost;
    const std::int32_t count = rasters.grid.count();
    cost.grid = rasters.grid;
    cost.radius = radius_;
    cost.cells.assign(count, {kUnreachableCost, kUnreachableCost, kUnreachableCost, kUnreachableCost});
    cost.nodes.clear();
    std::vector<float>& unit = scratch_;
    unit.assign(count, kUnreachableCost);
    computeGroundCost(rasters, radius_, openCost_, 0, count, {cost.cells, unit, cost.nodes});
    cost.lowest = *std::min_element(unit.begin(), unit.end());
    if (!(cost.lowest < kUnreachableCost)) cost.lowest = static_cast<float>(openCost_);
    level.clearance.resize(count);
    const auto radius = static_cast<float>(radius_);
    for (std::int32_t k = 0; k < count; ++k) level.clearance[k] = rasters.clearance[k] - radius;
}

// The centre of a cell twice as wide is the corner where four ground cells meet: it takes their mean
// clearance and mean unit cost.
void StaticGround::computeMiddle(std::span<const float> clearance) {
    const Grid grid{grid_.origin, 2.0 * grid_.cell, (grid_.width + 1) / 2, (grid_.height + 1) / 2};
    middle_.cost.grid = grid;
    if (open_) return;  // No query reads the level on open ground.
    middleClearance_.resize(grid.count());
    middleSpeed_.resize(middleClearance_.size());
    for (std::int32_t k = 0; k < grid.count(); ++k) {
        const Cell c = grid.at(k);
        float mean = 0.0f;
        float slowness = 0.0f;
        for (const std::int32_t y : {2 * c.y, std::min(2 * c.y + 1, grid_.height - 1)})
            for (const std::int32_t x : {2 * c.x, std::min(2 * c.x + 1, grid_.width - 1)}) {
                mean += 0.25f * clearance[grid_.index({x, y})];
                slowness += 0.25f / speed_[grid_.index({x, y})];
            }
        middleClearance_[k] = mean;
        middleSpeed_[k] = 1.0f / slowness;
    }
    computeLevel(middle_, {grid, middleClearance_, middleSpeed_});
    middle_.uniformClearance.resize(middleClearance_.size());
    for (std::int32_t k = 0; k < grid.count(); ++k)
        middle_
            .uniformClearance[k] = fine_.uniformClearance[grid_.index({2 * grid.at(k).x, 2 * grid.at(k).y})];
}

void StaticGround::computeUniformClearance() {
    fine_.uniformClearance = fine_.clearance;
    extendClearance();
    limitByPatches();
}

// The environment caps clearances at a limit. Beyond it, the distance to the nearest block of cells with a
// smaller clearance is added.
void StaticGround::extendClearance() {
    constexpr auto kLimit = static_cast<float>(Environment::kClearanceLimit);
    const float capped = kLimit - static_cast<float>(radius_) - 1e-4f;
    const std::int32_t width = (grid_.width + kBlock - 1) / kBlock;
    const std::int32_t height = (grid_.height + kBlock - 1) / kBlock;
    std::vector<float>& blocks = scratch_;
    const auto blockOf = [&](std::int32_t cell) {
        return static_cast<std::size_t>(grid_.at(cell).y / kBlock) * width + grid_.at(cell).x / kBlock;
    };
    blocks.assign(static_cast<std::size_t>(width) * height, kFarAway);
    for (std::int32_t k = 0; k < grid_.count(); ++k)
        if (fine_.uniformClearance[k] < capped) blocks[blockOf(k)] = 0.0f;
    chamferDistance(width, height, blocks);
    const auto edge = static_cast<float>(kBlock * grid_.cell);
    for (std::int32_t k = 0; k < grid_.count(); ++k) {
        if (fine_.uniformClearance[k] < capped) continue;
        fine_.uniformClearance[k] += std::max(0.0f, kChamferLowerBound * blocks[blockOf(k)] - 1.5f) * edge;
    }
}

// Limits the uniform clearance by the distance to the nearest cell with a neighbour of another unit cost.
void StaticGround::limitByPatches() {
    std::vector<float>& border = scratch_;
    border.assign(unit_.size(), kFarAway);
    uniform_ = true;
    for (std::int32_t k = 0; k < grid_.count(); ++k) {
        const Cell c = grid_.at(k);
        const bool east = c.x + 1 < grid_.width && unit_[k + 1] != unit_[k];
        const bool north = c.y + 1 < grid_.height && unit_[k + grid_.width] != unit_[k];
        if (east) border[k] = border[k + 1] = 0.0f;
        if (north) border[k] = border[k + grid_.width] = 0.0f;
        if (east || north) uniform_ = false;
    }
    if (uniform_) return;
    chamferDistance(grid_.width, grid_.height, border);
    const auto edge = static_cast<float>(grid_.cell);
    for (std::int32_t k = 0; k < grid_.count(); ++k)
        fine_.uniformClearance[k] = std::min(fine_.uniformClearance[k],
                                             (kChamferLowerBound * border[k] - 0.5f) * edge);
}

double StaticGround::interpolatedClearance(Vec2 p) const {
    return interpolate(fine_.uniformClearance, p);
}

double StaticGround::interpolate(const std::vector<float>& clearance, Vec2 p) const {
    const Vec2 cells = inCells(p);
    if (!holds(cells)) return -1.0;
    const BilinearPoint at = bilinearPoint(grid_, cells.x, cells.y);
    const float* low = clearance.data() + grid_.index(at.low);
    const float* high = low + (grid_.height > 1 ? grid_.width : 0);
    const std::int32_t right = grid_.width > 1 ? 1 : 0;
    return interpolateBilinear(low[0], low[right], high[0], high[right], at.fx, at.fy);
}

double StaticGround::lineCost(Vec2 a, Vec2 b) const {
    if (uniform_) return fine_.cost.lowest * distance(a, b);
    constexpr int kSamples = 8;
    double sum = 0.0;
    for (int k = 0; k < kSamples; ++k) sum += unitCost(a + (b - a) * ((k + 0.5) / kSamples));
    return sum / kSamples * distance(a, b);
}

bool StaticGround::lineOfSight(Vec2 a, Vec2 b, double length) const {
    if (open_) return true;
    // A path that leaves slow ground and returns may be faster, unless both ends lie deep in that ground.
    if (!uniform_ && unitCost(b) > fine_.cost.lowest)
        return unitCost(a) == unitCost(b) && uniformClearance(a) + uniformClearance(b) >= length;
    return traceSpheres(fine_.uniformClearance, a, b, length);
}

// Sphere tracing (Hart 1996): steps along the line as far as the clearance at each point reaches.
bool StaticGround::traceSpheres(const std::vector<float>& clearance, Vec2 a, Vec2 b, double length) const {
    const auto lowerBound = [&](Vec2 p) {
        const std::int32_t cell = cellAt(p);
        return cell >= 0 ? static_cast<double>(clearance[cell]) - halfDiagonal_ : -1.0;
    };
    // No wall fits between two points so near to each other. They may stand in a door so narrow that no cell
    // of it is free.
    if (length <= radius_) return true;
    // The disc round the end needs no steps.
    const double last = length - std::max(lowerBound(b), 0.0);
    double free = lowerBound(a);
    if (free >= kInterpolated && free >= last) return true;
    const Vec2 direction = (b - a) / length;
    for (double at = 0.0; at < last;) {
        const Vec2 p = a + direction * at;
        free = lowerBound(p);
        if (free < kInterpolated) free = interpolate(clearance, p);
        if (free < -kPenetration) return false;
        at += std::max(free, kLeastStep);
    }
    return true;
}

}  // namespace muster
