#include "cost/dynamic_cost.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cost/discomfort.h"

namespace muster {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr double kPeak = 0.02;         // Precision of the time at which a moving thing is worst.
constexpr double kHazardStep = 0.5;    // Between two points at which moving things are read [m].
constexpr float kSameUnit = 0.01f;     // Grounds whose costs differ by less, relatively, are the same.
constexpr float kLeastShare = 0.02f;   // Of cells on the same ground that their reading takes.
constexpr std::int32_t kSamples = 16;  // Along a line, at most: else one per cell.

// Speed in the direction of `side`, relative to the free speed of the ground (SPEC A4).
double crowdSpeed(const UnitCostDef& def, const DensityField& density, Vec2 p, Vec2 side,
                  double travelSpeed) {
    const Vec2 ahead = p + side * def.lookAhead;
    const double crowd = density.densityAt(ahead);
    if (crowd <= def.densityMin) return 1.0;
    const double flow = std::max(0.0, dot(density.velocityAt(ahead), side)) / (def.freeSpeed * travelSpeed);
    const double share = std::min(1.0, (crowd - def.densityMin) / (def.densityMax - def.densityMin));
    return std::max(def.minSpeed, 1.0 + share * (std::min(1.0, flow) - 1.0));
}

std::int32_t samplesAlong(double length, double step) {
    return std::min(kSamples, static_cast<std::int32_t>(length / step) + 1);
}

// The mean of what is read at points, each with its share of the line.
template <class Read>
double meanAlong(Vec2 a, Vec2 b, std::int32_t samples, const Read& read) {
    const double share = 1.0 / samples;
    const Vec2 way = b - a;
    double sum = 0.0;
    for (std::int32_t k = 0; k < samples; ++k) sum += read(a + way * ((k + 0.5) * share), (k + 0.5) * share);
    return sum * share;
}

bool isNone(const CellCost& c) {
    return c.east == 0.0f && c.north == 0.0f && c.west == 0.0f && c.south == 0.0f;
}

}  // namespace

struct DynamicCost::Sides {
    float CellCost::*x;
    float CellCost::*y;
    float toX;
    float toY;

    explicit Sides(Vec2 to)
        : x(to.x > 0.0 ? &CellCost::east : &CellCost::west),
          y(to.y > 0.0 ? &CellCost::north : &CellCost::south),
          toX(static_cast<float>(to.x)),
          toY(static_cast<float>(to.y)) {}
    // The excess of going there where a metre to these sides costs so much, relative to empty ground.
    double excess(float costX, float costY) const {
        const float alongX = toX * costX;
        const float alongY = toY * costY;
        return static_cast<double>(std::sqrt(alongX * alongX + alongY * alongY)) - 1.0;
    }
};

void DynamicCost::clear() {
    for (const std::int32_t cell : listed_) excess_[cell] = {0.0f, 0.0f, 0.0f, 0.0f};
    for (const std::int32_t cell : busyList_) busy_[cell] = 0;
    for (const std::int32_t cell : lookedList_) looked_[cell] = 0;
    for (const std::int32_t cell : moved_) hazard_[cell] = 0.0f;
    for (const std::int32_t cell : seenList_) seen_[cell] = 0;
    for (const std::int32_t cell : takenList_) taken_[cell] = 0;
    takenList_.clear();
    moved_.clear();
    seenList_.clear();
    listed_.clear();
    busyList_.clear();
    lookedList_.clear();
}

void DynamicCost::set(std::int32_t cell, const CellCost& value) {
    if (isNone(value)) return;
    if (isNone(excess_[cell])) listed_.push_back(cell);
    excess_[cell] = value;
}

void DynamicCost::reset(const Grid& ground, const Grid& cells) {
    if (!(cells == grid_)) {
        grid_ = cells;
        locator_ = BilinearLocator(grid_);
        const auto count = static_cast<std::size_t>(grid_.count());
        excess_.assign(count, {0.0f, 0.0f, 0.0f, 0.0f});
        unit_.assign(count, 0.0f);
        busy_.assign(count, 0);
        looked_.assign(count, 0);
        listed_.reserve(count);
        busyList_.reserve(count);
        busySum_.reserve(static_cast<std::size_t>(grid_.width + 1) * (grid_.height + 1));
        lookedList_.reserve(count);
        listed_.clear();
        busyList_.clear();
        lookedList_.clear();
        hazardGrid_ = Grid::covering(grid_.box(), kMovingCell);
        movingLocator_ = BilinearLocator(hazardGrid_);
        hazard_.assign(static_cast<std::size_t>(hazardGrid_.count()), 0.0f);
        seen_.assign(hazard_.size(), 0);
        moved_.clear();
        seenList_.clear();
    }
    clear();
    if (!(ground == ground_)) {
        ground_ = ground;
        taken_.assign(static_cast<std::size_t>(ground_.count()), 0);
    }
}

void DynamicCost::update(const UnitCostDef& def, const Environment& environment, const DensityField& density,
                         double radius) {
    reset(environment.grid(), density.grid());
    if (grid_.count() == 0) return;
    if (def.density) addCrowd(def, density, environment);
    if (def.discomfort && def.gamma > 0.0)
        for (const ObstaclePiece& piece : environment.pieces()) addDiscomfortOf(def, piece);
    addMovedGround(environment, radius);
    markBusy();
}

// Only cells near dense ones can be slowed.
void DynamicCost::addCrowd(const UnitCostDef& def, const DensityField& density,
                           const Environment& environment) {
    const auto reach = static_cast<std::int32_t>(std::ceil(def.lookAhead / grid_.cell));
    const double price = def.alpha + def.beta;
    perMetre_ = static_cast<float>(def.alpha / price);
    perSecond_ = static_cast<float>(def.beta / price);
    const std::span<const float> travel = environment.travelSpeed();
    const Grid& ground = environment.grid();
    const auto priceCell = [&](std::int32_t cell) {
        const Vec2 p = grid_.centre(grid_.at(cell));
        const double speed = travel[ground.index(ground.nearestCell(p))];
        unit_[cell] = static_cast<float>(price / speed);
        const auto excess = [&](Vec2 side) {
            const double f = crowdSpeed(def, density, p, side, speed);
            return f < 1.0 ? static_cast<float>((def.alpha * f + def.beta) / (f * price) - 1.0) : 0.0f;
        };
        set(cell, {excess({1.0, 0.0}), excess({0.0, 1.0}), excess({-1.0, 0.0}), excess({0.0, -1.0})});
    };
    for (const std::int32_t dense : density.occupied()) {
        if (!(density.density()[dense] > def.densityMin)) continue;
        const Cell c = grid_.at(dense);
        for (std::int32_t y = std::max(0, c.y - reach); y <= std::min(grid_.height - 1, c.y + reach); ++y)
            for (std::int32_t x = std::max(0, c.x - reach); x <= std::min(grid_.width - 1, c.x + reach);
                 ++x) {
                const std::int32_t cell = grid_.index({x, y});
                if (looked_[cell] != 0) continue;
                looked_[cell] = 1;
                lookedList_.push_back(cell);
                priceCell(cell);
            }
    }
}

void DynamicCost::setHazard(std::int32_t cell, float value) {
    if (value == 0.0f) return;
    if (hazard_[cell] == 0.0f) moved_.push_back(cell);
    hazard_[cell] = std::min(value, kBlocked);
}

void DynamicCost::addDiscomfortOf(const UnitCostDef& def, const ObstaclePiece& piece) {
    if (!piece.moving) return;
    const auto scale = static_cast<float>(def.gamma / (def.alpha + def.beta));
    const Vec2 end = piece.centre + piece.velocity * def.discomfortTime;
    const double reach = piece.radius + def.discomfortRange;
    const Cell low = hazardGrid_.nearestCell(
        {std::min(piece.centre.x, end.x) - reach, std::min(piece.centre.y, end.y) - reach});
    const Cell high = hazardGrid_.nearestCell(
        {std::max(piece.centre.x, end.x) + reach, std::max(piece.centre.y, end.y) + reach});
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const std::int32_t cell = hazardGrid_.index({x, y});
            const auto g = static_cast<float>(discomfortAt(def, piece, hazardGrid_.centre({x, y}), kPeak));
            setHazard(cell, std::max(hazard_[cell], scale * g));
        }
}

// Bodies of moving obstacles, and ground that moving patches slow or speed up.
void DynamicCost::addMovedGround(const Environment& environment, double radius) {
    for (const CellRect& area : environment.movingPatchAreas())
        if (!area.empty()) addMovedPatches(environment, area);
    const std::span<const float> live = environment.clearance();
    const std::span<const float> still = environment.staticClearance();
    // Not the rim, where those stand who touch the obstacle.
    const auto least = static_cast<float>(radius);
    const auto most = static_cast<float>(radius - 0.5 * ground_.cell);
    for (const CellRect& area : environment.movingObstacleAreas()) {
        if (area.empty()) continue;
        for (std::int32_t y = area.low.y; y <= area.high.y; ++y)
            for (std::int32_t x = area.low.x; x <= area.high.x; ++x) {
                const std::int32_t cell = ground_.index({x, y});
                if (taken_[cell] != 0 || live[cell] >= most || still[cell] < least) continue;
                taken_[cell] = 1;
                takenList_.push_back(cell);
            }
    }
}

void DynamicCost::addMovedPatches(const Environment& environment, const CellRect& area) {
    const std::span<const float> travel = environment.travelSpeed();
    const std::span<const float> patch = environment.staticPatchSpeed();
    const Cell low = hazardGrid_.nearestCell(ground_.centre(area.low));
    const Cell high = hazardGrid_.nearestCell(ground_.centre(area.high));
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) {
            const std::int32_t cell = hazardGrid_.index({x, y});
            if (seen_[cell] != 0) continue;
            seen_[cell] = 1;
            seenList_.push_back(cell);
            const std::int32_t at = ground_.index(ground_.nearestCell(hazardGrid_.centre({x, y})));
            const float stillSpeed = patch[at] < kInfinite ? patch[at] : 1.0f;
            if (travel[at] != stillSpeed)
                setHazard(cell, (1.0f + hazard_[cell]) * (stillSpeed / travel[at]) - 1.0f);
        }
}

void DynamicCost::markBusy() {
    crowdBounds_ = {};
    for (const std::int32_t cell : listed_) {
        const Cell c = grid_.at(cell);
        for (std::int32_t y = std::max(0, c.y - 1); y <= std::min(grid_.height - 1, c.y + 1); ++y)
            for (std::int32_t x = std::max(0, c.x - 1); x <= std::min(grid_.width - 1, c.x + 1); ++x) {
                std::uint8_t& busy = busy_[grid_.index({x, y})];
                if (busy == 0) busyList_.push_back(grid_.index({x, y}));
                busy = 1;
            }
        crowdBounds_.take(grid_.centre(c), grid_.cell);
    }
    sumBusy();
    hazardBounds_ = {};
    for (const std::int32_t cell : moved_)
        hazardBounds_.take(hazardGrid_.centre(hazardGrid_.at(cell)), kMovingCell);
    takenBounds_ = {};
    for (const std::int32_t cell : takenList_) {
        hazardBounds_.take(ground_.centre(ground_.at(cell)), ground_.cell);
        takenBounds_.take(ground_.centre(ground_.at(cell)), ground_.cell);
    }
}

// Over the box round all busy cells; one more row and column, of zeros, below and left of it.
void DynamicCost::sumBusy() {
    busyLow_ = {grid_.width, grid_.height};
    busyHigh_ = {-1, -1};
    for (const std::int32_t cell : busyList_) {
        const Cell c = grid_.at(cell);
        busyLow_ = {std::min(busyLow_.x, c.x), std::min(busyLow_.y, c.y)};
        busyHigh_ = {std::max(busyHigh_.x, c.x), std::max(busyHigh_.y, c.y)};
    }
    busyStride_ = std::max(0, busyHigh_.x - busyLow_.x + 1) + 1;
    const std::int32_t rows = std::max(0, busyHigh_.y - busyLow_.y + 1) + 1;
    busySum_.assign(static_cast<std::size_t>(busyStride_) * rows, 0);
    for (std::int32_t y = 1; y < rows; ++y) {
        std::int32_t row = 0;
        const std::uint8_t* busy = busy_.data() + grid_.index({busyLow_.x, busyLow_.y + y - 1});
        std::int32_t* out = busySum_.data() + static_cast<std::size_t>(y) * busyStride_;
        for (std::int32_t x = 1; x < busyStride_; ++x) {
            row += busy[x - 1];
            out[x] = out[x - busyStride_] + row;
        }
    }
}

// Excess of the crowd at `p` for somebody who goes towards these sides.
inline double DynamicCost::crowdAlong(Vec2 p, const Sides& sides) const {
    const BilinearLocator::Location at = locator_.at(p);
    if ((busy_[at.low] | busy_[at.low + locator_.right() + locator_.up()]) == 0) return 0.0;
    const CellCost* low = excess_.data() + at.low;
    const CellCost* high = low + locator_.up();
    const auto read = [&](float CellCost::*side) {
        const float below = low->*side + (low[locator_.right()].*side - low->*side) * at.fx;
        const float above = high->*side + (high[locator_.right()].*side - high->*side) * at.fx;
        return 1.0f + below + (above - below) * at.fy;
    };
    return sides.excess(read(sides.x), read(sides.y));
}

// The same on ground that costs so much, by those of the four cells around whose ground costs as much: beside
// a patch the flow is much for one of its speeds and little for the other. There single cells are slow by who
// has just come in or gone out; speeds themselves are interpolated, which gives these least.
inline double DynamicCost::crowdAlong(Vec2 p, const Sides& sides, float unit) const {
    const BilinearLocator::Location at = locator_.at(p);
    if ((busy_[at.low] | busy_[at.low + locator_.right() + locator_.up()]) == 0) return 0.0;
    const std::int32_t upper = at.low + locator_.up();
    const std::int32_t cell[] = {at.low, at.low + locator_.right(), upper, upper + locator_.right()};
    float share[] = {(1.0f - at.fx) * (1.0f - at.fy), at.fx * (1.0f - at.fy), (1.0f - at.fx) * at.fy,
                     at.fx * at.fy};
    float sum = 0.0f;
    for (int k = 0; k < 4; ++k) {
        const bool other = looked_[cell[k]] != 0 && std::fabs(unit_[cell[k]] - unit) > kSameUnit * unit;
        if (other) share[k] = 0.0f;
        sum += share[k];
    }
    if (!(sum > kLeastShare)) return crowdAlong(p, sides);
    const auto read = [&](float CellCost::*side) {
        float speed = 0.0f;
        for (int k = 0; k < 4; ++k) speed += share[k] * speedAt(excess_[cell[k]].*side);
        return perMetre_ + perSecond_ * sum / speed;
    };
    return sides.excess(read(sides.x), read(sides.y));
}

double DynamicCost::hazardRead(Vec2 p) const {
    if (takenBounds_.meets(p, p) && taken_[ground_.index(ground_.nearestCell(p))] != 0) return kBlocked;
    const BilinearLocator::Location at = movingLocator_.at(p);
    const float* low = hazard_.data() + at.low;
    const float* high = low + movingLocator_.up();
    const float below = low[0] + (low[movingLocator_.right()] - low[0]) * at.fx;
    const float above = high[0] + (high[movingLocator_.right()] - high[0]) * at.fx;
    return static_cast<double>(below + (above - below) * at.fy);
}

// Whether some crowd can be read within the box round the line, by sums over all cells below and left of one.
bool DynamicCost::busyAlong(Vec2 a, Vec2 b) const {
    if (listed_.empty() || !crowdBounds_.meets(a, b)) return false;
    const Cell p = grid_.nearestCell(a - 0.5 * Vec2{grid_.cell, grid_.cell});
    const Cell q = grid_.nearestCell(b - 0.5 * Vec2{grid_.cell, grid_.cell});
    const std::int32_t left = std::max(std::min(p.x, q.x), busyLow_.x);
    const std::int32_t low = std::max(std::min(p.y, q.y), busyLow_.y);
    const std::int32_t right = std::min(std::max(p.x, q.x) + 2, busyHigh_.x + 1);
    const std::int32_t high = std::min(std::max(p.y, q.y) + 2, busyHigh_.y + 1);
    if (left >= right || low >= high) return false;
    const auto sum = [&](std::int32_t x, std::int32_t y) {
        return busySum_[static_cast<std::size_t>(y - busyLow_.y) * busyStride_ + (x - busyLow_.x)];
    };
    return sum(right, high) - sum(left, high) - sum(right, low) + sum(left, low) > 0;
}

double DynamicCost::relativeAlong(Vec2 a, Vec2 b, double length) const {
    const bool crowd = busyAlong(a, b);
    const bool hazard = hazardMeets(a, b);
    if ((!crowd && !hazard) || !(length > 0.0)) return 0.0;
    double excess = 0.0;
    if (crowd) {
        const Sides sides((b - a) / length);
        excess += meanAlong(a, b, samplesAlong(length, grid_.cell),
                            [&](Vec2 p, double) { return crowdAlong(p, sides); });
    }
    if (hazard)
        excess += meanAlong(a, b, samplesAlong(length, kHazardStep),
                            [&](Vec2 p, double) { return movingCostAt(p); });
    return excess * length;
}

double DynamicCost::costAlong(const StaticGround& ground, Vec2 a, Vec2 b, double length) const {
    if (ground.uniform()) return ground.unitCost(a) * relativeAlong(a, b, length);
    const bool crowd = busyAlong(a, b);
    const bool hazard = hazardMeets(a, b);
    if ((!crowd && !hazard) || !(length > 0.0)) return 0.0;
    const Sides sides((b - a) / length);
    const std::int32_t samples = samplesAlong(length, hazard ? kHazardStep : grid_.cell);
    const double cost = meanAlong(a, b, samples, [&](Vec2 p, double) {
        const float unit = ground.unitCost(p);
        return unit * ((crowd ? crowdAlong(p, sides, unit) : 0.0) + (hazard ? movingCostAt(p) : 0.0));
    });
    return cost * length;
}

double DynamicCost::movingCostCentroid(Vec2 a, Vec2 b, double length) const {
    if (!hazardMeets(a, b)) return -1.0;
    double moment = 0.0;
    const std::int32_t samples = samplesAlong(length, kHazardStep);
    const double sum = meanAlong(a, b, samples, [&](Vec2 p, double share) {
        const double here = std::max(0.0, movingCostAt(p));
        moment += here * share;
        return here;
    });
    return sum > 0.0 ? moment / (sum * samples) : -1.0;
}

}  // namespace muster
