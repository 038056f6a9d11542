// A crowd that follows a formation, with costs in closed form and the exact optimum for comparison.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/maths.h"
#include "base/random.h"
#include "engine/assignment/transport/dense/jonker_volgenant.h"
#include "engine/assignment/transport/dynamic/dynamic_assignment.h"

namespace muster_test {

using muster::Vec2;

/// Lengths of shortest paths: straight lines, or around the ends of one wall.
class WallCosts : public muster::CostOracle {
public:
    std::vector<Vec2> characters;    ///< Positions [m].
    std::vector<Vec2> places;        ///< Positions [m].
    std::vector<double> unitCostOf;  ///< Per character: cost of a metre; empty for 1 each.
    bool wall = false;               ///< The wall exists.
    Vec2 low{0, -4};                 ///< One end of the wall [m].
    Vec2 high{0, 4};                 ///< The other end [m].

    /// The length of the shortest path.
    double pathLength(Vec2 a, Vec2 b) const {
        if (!wall || !crosses(a, b)) return distance(a, b);
        return std::min(distance(a, low) + distance(low, b), distance(a, high) + distance(high, b));
    }
    /// The first corner of the shortest path.
    Vec2 nextCorner(Vec2 a, Vec2 b) const {
        if (!wall || !crosses(a, b)) return b;
        const bool byLow = distance(a, low) + distance(low, b) < distance(a, high) + distance(high, b);
        const Vec2 end = byLow ? low : high;
        return end + normalized(end - (low + high) * 0.5) * 0.2;
    }
    /// The cost in double precision.
    virtual double exact(std::size_t i, std::size_t j) const {
        return (unitCostOf.empty() ? 1.0 : unitCostOf[i]) * pathLength(characters[i], places[j]);
    }
    float cost(std::int32_t i, std::int32_t j) override { return static_cast<float>(exact(i, j)); }
    double leastUnitCost() const override {
        return unitCostOf.empty() ? 1.0 : *std::min_element(unitCostOf.begin(), unitCostOf.end());
    }
    void evaluate(std::span<const muster::AssignmentPair> pairs, std::span<float> cost,
                  muster::ThreadPool& pool) override {
        constexpr std::size_t kChunk = 128;
        forChunks(&pool, pairs.size(), kChunk, [&](std::size_t k) {
            cost[k] = static_cast<float>(exact(pairs[k].character, pairs[k].place));
        });
    }

private:
    bool crosses(Vec2 a, Vec2 b) const {
        const auto separates = [](Vec2 u, Vec2 v, Vec2 p, Vec2 q) {
            return cross(v - u, p - u) * cross(v - u, q - u) < 0;
        };
        return separates(a, b, low, high) && separates(low, high, a, b);
    }
};

/// A definition whose thresholds keep back little, since these tests judge the search.
inline muster::DynamicAssignmentDef lowThresholds() {
    return {.threshold = 0.1, .thresholdShare = 0.001};
}

/// The optimum of a cost matrix, row-major, with no more rows than columns: the column of each row.
inline std::vector<std::int32_t> optimalColumns(std::int32_t rows, std::int32_t columns,
                                                const std::vector<double>& matrix) {
    muster::JonkerVolgenantSolver dense;
    dense.solve(rows, columns, matrix.data());
    return dense.columnOf();
}

/// The least sum of such a matrix.
inline double leastSum(std::int32_t rows, std::int32_t columns, const std::vector<double>& matrix) {
    const std::vector<std::int32_t> columnOf = optimalColumns(rows, columns, matrix);
    double sum = 0.0;
    for (std::int32_t a = 0; a < rows; ++a) sum += matrix[a * columns + columnOf[a]];
    return sum;
}

/// A block of places that moves and turns, and the crowd that walks after it.
struct AssignmentScene {
    WallCosts costs;
    std::vector<Vec2> shape;            ///< Places around the centre [m].
    std::vector<std::uint8_t> usable;   ///< As AssignmentInput::usable.
    std::vector<std::uint8_t> present;  ///< As AssignmentInput::present.
    Vec2 centre;                        ///< [m]
    double angle = 0.0;                 ///< [rad]
    double time = 0.0;                  ///< [s]
    muster::Random random;

    AssignmentScene(std::int32_t characters, std::int32_t places, std::uint64_t seed, double away = 2.0)
        : random(seed) {
        std::int32_t columns = 1;
        while (columns * columns < places) ++columns;
        for (std::int32_t k = 0; k < places; ++k)
            shape.push_back(Vec2{(k % columns - 0.5 * columns) * 0.8, (k / columns - 0.5 * columns) * 0.8} +
                            Vec2{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)});
        const double half = 0.4 * columns;
        for (std::int32_t k = 0; k < characters; ++k)
            costs.characters.push_back({random.uniform(-half, half) - away, random.uniform(-half, half)});
        movePlaces();
    }
    void movePlaces() {
        costs.places.clear();
        const muster::Rotation rotation{muster::cosine(angle), muster::sine(angle)};
        for (const Vec2 p : shape) costs.places.push_back(centre + rotation.apply(p));
    }
    muster::AssignmentInput input() const { return {costs.characters, costs.places, usable, present}; }
    /// One sixtieth of a second: the formation moves by `velocity` and turns, everybody walks.
    void step(Vec2 velocity, double turning, std::span<const std::int32_t> placeOf) {
        constexpr double kStep = 1.0 / 60.0;
        time += kStep;
        centre += velocity * kStep;
        angle += turning * kStep;
        movePlaces();
        for (std::size_t i = 0; i < costs.characters.size(); ++i) {
            if (placeOf[i] < 0) continue;
            Vec2& p = costs.characters[i];
            const Vec2 goal = costs.places[placeOf[i]];
            const double speed = std::min(2.0, costs.pathLength(p, goal) / 0.8);
            p += normalized(costs.nextCorner(p, goal) - p) * (speed * kStep) +
                 Vec2{random.uniform(-0.004, 0.004), random.uniform(-0.004, 0.004)};
        }
    }
    /// The least objective with as many pairs as possible, by a dense solver.
    double optimum(double p) const {
        std::vector<std::int32_t> rows;
        std::vector<std::int32_t> columns;
        for (std::int32_t i = 0; i < std::ssize(costs.characters); ++i)
            if (input().isPresent(i)) rows.push_back(i);
        for (std::int32_t j = 0; j < std::ssize(costs.places); ++j)
            if (input().isUsable(j)) columns.push_back(j);
        const bool transposed = rows.size() > columns.size();
        std::vector<double> matrix;
        for (const std::int32_t a : transposed ? columns : rows)
            for (const std::int32_t b : transposed ? rows : columns)
                matrix.push_back(muster::power(transposed ? costs.exact(b, a) : costs.exact(a, b), p));
        return leastSum(static_cast<std::int32_t>(std::min(rows.size(), columns.size())),
                        static_cast<std::int32_t>(std::max(rows.size(), columns.size())), matrix);
    }
    /// The objective of an assignment, by the exact costs.
    double objective(std::span<const std::int32_t> placeOf, double p) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < placeOf.size(); ++i)
            if (placeOf[i] >= 0) sum += muster::power(costs.exact(i, placeOf[i]), p);
        return sum;
    }
    /// How far an assignment is from the optimum, as a share (SPEC: of at least (0.25 m)^p each).
    double gap(std::span<const std::int32_t> placeOf, double p) const {
        const double best = optimum(p);
        const double least = static_cast<double>(costs.characters.size()) * muster::power(0.25, p);
        return (objective(placeOf, p) - best) / std::max(best, least);
    }
    /// As many pairs as possible, nobody and nothing twice, nothing forbidden.
    bool valid(std::span<const std::int32_t> placeOf) const {
        std::vector<int> taken(costs.places.size(), 0);
        int presentCount = 0;
        int usableCount = 0;
        int pairs = 0;
        for (std::int32_t j = 0; j < std::ssize(taken); ++j) usableCount += input().isUsable(j) ? 1 : 0;
        for (std::int32_t i = 0; i < std::ssize(placeOf); ++i) {
            presentCount += input().isPresent(i) ? 1 : 0;
            const std::int32_t j = placeOf[i];
            if (j < 0) continue;
            if (j >= std::ssize(taken) || !input().isUsable(j) || !input().isPresent(i) || taken[j]++ > 0)
                return false;
            ++pairs;
        }
        return pairs == std::min(presentCount, usableCount);
    }
};

}  // namespace muster_test
