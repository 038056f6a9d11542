// Line integrals of the dynamic cost, by the midpoint rule.
#include <algorithm>
#include <cmath>

#include "engine/fields/cost/dynamic_cost.h"

namespace muster {
namespace {

// Distance between samples of the moving cost along a line [m].
constexpr double kMovingStep = 0.5;
// Largest number of samples along a line.
constexpr std::int32_t kMaxSamples = 16;
// Relative difference of unit costs up to which two cells are of the same ground.
constexpr float kSameUnit = 0.01f;
// Weight of the cells on the same ground below which they are too few for an interpolation.
constexpr float kLeastWeight = 0.02f;

std::int32_t samplesAlong(double length, double step) {
    return std::min(kMaxSamples, static_cast<std::int32_t>(length / step) + 1);
}

// Narrows a range of samples to those that may lie between two bounds along one axis, where a line begins at
// `from` and has the extent `line`. A further sample at either end makes up for rounding.
void narrow(double min, double max, double from, double line, std::int32_t samples, double& first,
            double& last) {
    constexpr double kAlong = 1e-6;  // Extent below which a line stays where it is [m].
    if (std::fabs(line) < kAlong) return;
    const double perMetre = samples / line;
    const double one = (min - from) * perMetre - 0.5, other = (max - from) * perMetre - 0.5;
    first = std::max(first, std::min(one, other) - 1.0);
    last = std::min(last, std::max(one, other) + 1.0);
}

// The samples of a line that may lie in a box, from `first` to before `end`.
struct Samples {
    std::int32_t first, end;

    Samples(const DynamicCost::Bounds& box, double margin, Vec2 from, Vec2 line, std::int32_t count) {
        double low = 0.0, high = count - 1.0;
        narrow(box.min.x - margin, box.max.x + margin, from.x, line.x, count, low, high);
        narrow(box.min.y - margin, box.max.y + margin, from.y, line.y, count, low, high);
        end = low <= high ? static_cast<std::int32_t>(high) + 1 : 0;
        first = end > 0 ? static_cast<std::int32_t>(low) : 0;
    }
};

}  // namespace

struct DynamicCost::Direction {
    float CellCost::*sideX;  // The side that is crossed along x.
    float CellCost::*sideY;  // The side that is crossed along y.
    float x;                 // Unit vector.
    float y;

    explicit Direction(Vec2 unitVector)
        : sideX(unitVector.x > 0.0 ? &CellCost::east : &CellCost::west),
          sideY(unitVector.y > 0.0 ? &CellCost::north : &CellCost::south),
          x(static_cast<float>(unitVector.x)),
          y(static_cast<float>(unitVector.y)) {}
    // The relative cost of this direction, from the costs of crossing the sides relative to empty ground.
    double relativeCost(float costX, float costY) const {
        const float alongX = x * costX;
        const float alongY = y * costY;
        return static_cast<double>(std::sqrt(alongX * alongX + alongY * alongY)) - 1.0;
    }
};

// Relative crowd cost at `p`, with bilinear costs.
inline double DynamicCost::crowdCost(Vec2 p, const Direction& direction) const {
    const BilinearLocator::Location at = locator_.at(p);
    const std::int32_t opposite = at.low + locator_.right() + locator_.up();
    if ((nearCrowd_.flags()[at.low] | nearCrowd_.flags()[opposite]) == 0) return 0.0;
    const CellCost* low = crowdCost_.data() + at.low;
    const CellCost* high = low + locator_.up();
    const auto read = [&](float CellCost::*side) {
        const float below = low->*side + (low[locator_.right()].*side - low->*side) * at.fx;
        const float above = high->*side + (high[locator_.right()].*side - high->*side) * at.fx;
        return 1.0f + below + (above - below) * at.fy;
    };
    return direction.relativeCost(read(direction.sideX), read(direction.sideY));
}

// Relative crowd cost at a point on ground of one unit cost, from those of the four cells around that lie on
// the same ground: at the edge of a patch the same flow is fast relative to one side and slow relative to the
// other. Speeds are interpolated here instead of costs, which gives least weight to single slow cells.
inline double DynamicCost::crowdCostOnGround(Vec2 p, const Direction& direction, float unitCost) const {
    const BilinearLocator::Location at = locator_.at(p);
    const std::int32_t opposite = at.low + locator_.right() + locator_.up();
    if ((nearCrowd_.flags()[at.low] | nearCrowd_.flags()[opposite]) == 0) return 0.0;
    const std::int32_t upper = at.low + locator_.up();
    const std::int32_t cell[] = {at.low, at.low + locator_.right(), upper, upper + locator_.right()};
    float weight[] = {(1.0f - at.fx) * (1.0f - at.fy), at.fx * (1.0f - at.fy), (1.0f - at.fx) * at.fy,
                      at.fx * at.fy};
    float sum = 0.0f;
    for (int k = 0; k < 4; ++k) {
        const bool otherGround = evaluated_.contains(cell[k]) &&
                                 std::fabs(staticUnit_[cell[k]] - unitCost) > kSameUnit * unitCost;
        if (otherGround) weight[k] = 0.0f;
        sum += weight[k];
    }
    if (!(sum > kLeastWeight)) return crowdCost(p, direction);
    const auto read = [&](float CellCost::*side) {
        float speed = 0.0f;
        for (int k = 0; k < 4; ++k) speed += weight[k] * speedAt(crowdCost_[cell[k]].*side);
        return lengthShare_ + timeShare_ * sum / speed;
    };
    return direction.relativeCost(read(direction.sideX), read(direction.sideY));
}

double DynamicCost::readSparse(const BilinearPoint& at) const {
    const Cell high{at.low.x + (movingLocator_.right() > 0 ? 1 : 0),
                    at.low.y + (movingLocator_.up() > 0 ? 1 : 0)};
    const auto [value] = movingCost_.square(at.low, high);
    return static_cast<double>(interpolateBilinear(value[0], value[1], value[2], value[3],
                                                   static_cast<float>(at.fx), static_cast<float>(at.fy)));
}

// True where the crowd cost may differ from zero in the bounding box of the line.
bool DynamicCost::crowdMeets(Vec2 a, Vec2 b) const {
    if (crowdCells_.empty() || !crowdBounds_.meets(a, b)) return false;
    const Cell p = locator_.point(a).low, q = locator_.point(b).low;
    return nearCrowdSums_.any(
        {{std::min(p.x, q.x), std::min(p.y, q.y)}, {std::max(p.x, q.x) + 1, std::max(p.y, q.y) + 1}});
}

/// The centroid of the positive part of the moving cost along a line.
struct DynamicCost::Centroid {
    double sum = 0.0;
    double moment = 0.0;
    std::int32_t samples = 0;

    // Takes a sample, and returns it.
    double add(double cost, double fraction) {
        const double here = std::max(0.0, cost);
        sum += here;
        moment += here * fraction;
        ++samples;
        return cost;
    }
    double fraction() const {
        if (!(sum > 0.0)) return -1.0;
        const double mean = sum * (1.0 / samples);
        return moment / (mean * samples);
    }
};

// The mean of the moving cost along a line. Samples outside the bounds are zero.
inline double DynamicCost::movingAlong(Vec2 a, Vec2 b, double length, Centroid& centroid) const {
    const std::int32_t count = samplesAlong(length, kMovingStep);
    const double share = 1.0 / count;
    const Vec2 line = b - a;
    const Samples samples(movingBounds_, 0.0, a, line, count);
    double sum = 0.0;
    for (std::int32_t k = samples.first; k < samples.end; ++k) {
        const double fraction = (k + 0.5) * share;
        sum += centroid.add(movingCostAt(a + line * fraction), fraction);
    }
    centroid.samples = count;
    return sum * share;
}

// The mean of the crowd cost along a line. A cell farther than another one outside the bounds reads no cost.
inline double DynamicCost::crowdAlong(Vec2 a, Vec2 b, double length) const {
    const std::int32_t count = samplesAlong(length, grid_.cell);
    const double share = 1.0 / count;
    const Vec2 line = b - a;
    const Direction direction(line / length);
    const Samples samples(crowdBounds_, grid_.cell, a, line, count);
    double sum = 0.0;
    for (std::int32_t k = samples.first; k < samples.end; ++k)
        sum += crowdCost(a + line * ((k + 0.5) * share), direction);
    return sum * share;
}

// Crowd and moving cost along a line, with spacings of their own.
inline double DynamicCost::sumAlong(Vec2 a, Vec2 b, double length, Centroid& centroid) const {
    const bool crowd = crowdMeets(a, b);
    const bool moving = movingCostMeets(a, b);
    if ((!crowd && !moving) || !(length > 0.0)) return 0.0;
    double mean = 0.0;
    if (crowd) mean += crowdAlong(a, b, length);
    if (moving) mean += movingAlong(a, b, length, centroid);
    return mean * length;
}

double DynamicCost::relativeAlong(Vec2 a, Vec2 b, double length) const {
    Centroid centroid;
    return sumAlong(a, b, length, centroid);
}

// Sums the dynamic cost along a line over ground of several unit costs.
double DynamicCost::sumOnGround(const StaticGround& ground, Vec2 a, Vec2 b, double length,
                                Centroid& centroid) const {
    const bool crowd = crowdMeets(a, b);
    const bool moving = movingCostMeets(a, b);
    if ((!crowd && !moving) || !(length > 0.0)) return 0.0;
    const Direction direction((b - a) / length);
    const std::int32_t samples = samplesAlong(length, moving ? kMovingStep : grid_.cell);
    const double share = 1.0 / samples;
    double sum = 0.0;
    for (std::int32_t k = 0; k < samples; ++k) {
        const double fraction = (k + 0.5) * share;
        const Vec2 p = a + (b - a) * fraction;
        const float unitCost = ground.unitCost(p);
        sum += unitCost * ((crowd ? crowdCostOnGround(p, direction, unitCost) : 0.0) +
                           (moving ? centroid.add(movingCostAt(p), fraction) : 0.0));
    }
    return sum * share * length;
}

DynamicCost::LineCost DynamicCost::costAndCentroid(const StaticGround& ground, Vec2 a, Vec2 b,
                                                   double length) const {
    Centroid centroid;
    const double cost = ground.uniform() ? ground.unitCost(a) * sumAlong(a, b, length, centroid)
                                         : sumOnGround(ground, a, b, length, centroid);
    return {cost, centroid.fraction()};
}

double DynamicCost::movingCostCentroid(Vec2 a, Vec2 b, double length) const {
    if (!movingCostMeets(a, b)) return -1.0;
    Centroid centroid;
    movingAlong(a, b, length, centroid);
    return centroid.fraction();
}

}  // namespace muster
