// A crowd that follows a formation, with costs in closed form, and the exact optimum beside it.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "assignment/dense/jonker_volgenant.h"
#include "assignment/dynamic/dynamic_assignment.h"
#include "base/maths.h"
#include "base/random.h"

namespace muster_test {

using muster::Vec2;

/// Straight distances, or the shorter way round a wall.
class ClosedCosts : public muster::CostOracle {
public:
    std::vector<Vec2> characters;
    std::vector<Vec2> places;
    std::vector<double> weightOf;  ///< Per character; empty for 1 each.
    bool wall = false;
    Vec2 low{0, -4};  ///< Ends of the wall.
    Vec2 high{0, 4};

    /// The length of the shortest way.
    double way(Vec2 a, Vec2 b) const {
        if (!wall || !crosses(a, b)) return distance(a, b);
        return std::min(distance(a, low) + distance(low, b), distance(a, high) + distance(high, b));
    }
    /// Where to go first on it.
    Vec2 next(Vec2 a, Vec2 b) const {
        if (!wall || !crosses(a, b)) return b;
        const bool byLow = distance(a, low) + distance(low, b) < distance(a, high) + distance(high, b);
        const Vec2 end = byLow ? low : high;
        return end + normalized(end - (low + high) * 0.5) * 0.2;
    }
    virtual double exact(std::size_t i, std::size_t j) const {
        return (weightOf.empty() ? 1.0 : weightOf[i]) * way(characters[i], places[j]);
    }
    float cost(std::int32_t i, std::int32_t j) override {
        return static_cast<float>(exact(static_cast<std::size_t>(i), static_cast<std::size_t>(j)));
    }
    double leastUnitCost() const override {
        return weightOf.empty() ? 1.0 : *std::min_element(weightOf.begin(), weightOf.end());
    }
    void evaluate(std::span<const muster::AssignmentPair> pairs, std::span<float> cost,
                  muster::ThreadPool& pool) override {
        fillPairs_ = pairs;
        fillCost_ = cost;
        constexpr std::size_t kChunk = 128;
        pool.run(static_cast<std::int32_t>((pairs.size() + kChunk - 1) / kChunk), [this](std::int32_t item,
                                                                                         std::int32_t) {
            const auto begin = static_cast<std::size_t>(item) * kChunk;
            for (std::size_t k = begin; k < std::min(begin + kChunk, fillPairs_.size()); ++k)
                fillCost_[k] = static_cast<float>(exact(static_cast<std::size_t>(fillPairs_[k].character),
                                                        static_cast<std::size_t>(fillPairs_[k].place)));
        });
    }

private:
    bool crosses(Vec2 a, Vec2 b) const {
        const auto sides = [](Vec2 u, Vec2 v, Vec2 p, Vec2 q) {
            return cross(v - u, p - u) * cross(v - u, q - u) < 0;
        };
        return sides(a, b, low, high) && sides(low, high, a, b);
    }
    std::span<const muster::AssignmentPair> fillPairs_;
    std::span<float> fillCost_;
};

/// A definition whose thresholds keep back little: what these tests judge is the search.
inline muster::DynamicAssignmentDef lowThresholds() {
    muster::DynamicAssignmentDef def;
    def.threshold = 0.1;
    def.thresholdShare = 0.001;
    return def;
}

/// The least sum of a matrix of costs, row by row, over assignments of all rows, by a dense solver; no more
/// rows than columns.
inline double leastSum(std::int32_t rows, std::int32_t columns, const std::vector<double>& matrix) {
    muster::JonkerVolgenantSolver dense;
    dense.solve(rows, columns, matrix.data());
    double sum = 0.0;
    for (std::size_t a = 0; a < static_cast<std::size_t>(rows); ++a)
        sum += matrix[a * static_cast<std::size_t>(columns) + static_cast<std::size_t>(dense.columnOf()[a])];
    return sum;
}

/// A block of places that moves and turns, and the crowd that walks after it.
struct AssignmentScene {
    ClosedCosts costs;
    std::vector<Vec2> shape;
    std::vector<std::uint8_t> usable;
    std::vector<std::uint8_t> present;
    Vec2 centre;
    double angle = 0.0;
    double time = 0.0;
    muster::Random random;

    AssignmentScene(std::int32_t people, std::int32_t places, std::uint64_t seed, double away = 2.0)
        : random(seed) {
        std::int32_t columns = 1;
        while (columns * columns < places) ++columns;
        for (std::int32_t k = 0; k < places; ++k)
            shape.push_back(Vec2{(k % columns - 0.5 * columns) * 0.8, (k / columns - 0.5 * columns) * 0.8} +
                            Vec2{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05)});
        const double half = 0.4 * columns;
        for (std::int32_t k = 0; k < people; ++k)
            costs.characters.push_back({random.uniform(-half, half) - away, random.uniform(-half, half)});
        place();
    }
    void place() {
        costs.places.clear();
        const muster::Rotation turn{muster::cosine(angle), muster::sine(angle)};
        for (const Vec2 p : shape) costs.places.push_back(centre + turn.apply(p));
    }
    muster::AssignmentInput input() const { return {costs.characters, costs.places, usable, present}; }
    /// One sixtieth of a second: the formation moves by `velocity` and turns, everybody walks.
    void step(Vec2 velocity, double turning, std::span<const std::int32_t> placeOf) {
        constexpr double kStep = 1.0 / 60.0;
        time += kStep;
        centre += velocity * kStep;
        angle += turning * kStep;
        place();
        for (std::size_t i = 0; i < costs.characters.size(); ++i) {
            if (placeOf[i] < 0) continue;
            Vec2& p = costs.characters[i];
            const Vec2 goal = costs.places[placeOf[i]];
            const double speed = std::min(2.0, costs.way(p, goal) / 0.8);
            p += normalized(costs.next(p, goal) - p) * (speed * kStep) +
                 Vec2{random.uniform(-0.004, 0.004), random.uniform(-0.004, 0.004)};
        }
    }
    /// The least objective with as many pairs as possible, found by a dense solver.
    double optimum(double p) const {
        std::vector<std::size_t> rows;
        std::vector<std::size_t> columns;
        for (std::size_t i = 0; i < costs.characters.size(); ++i)
            if (input().takesPart(i)) rows.push_back(i);
        for (std::size_t j = 0; j < costs.places.size(); ++j)
            if (input().mayTake(j)) columns.push_back(j);
        const bool turned = rows.size() > columns.size();
        std::vector<double> matrix;
        for (const std::size_t a : turned ? columns : rows)
            for (const std::size_t b : turned ? rows : columns)
                matrix.push_back(muster::power(turned ? costs.exact(b, a) : costs.exact(a, b), p));
        return leastSum(static_cast<std::int32_t>(std::min(rows.size(), columns.size())),
                        static_cast<std::int32_t>(std::max(rows.size(), columns.size())), matrix);
    }
    /// The objective of an assignment, by the exact costs.
    double objective(std::span<const std::int32_t> placeOf, double p) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < placeOf.size(); ++i)
            if (placeOf[i] >= 0)
                sum += muster::power(costs.exact(i, static_cast<std::size_t>(placeOf[i])), p);
        return sum;
    }
    /// How far an assignment is from the optimum, as a share (SPEC: of at least (0.25 m)^p each).
    double gap(std::span<const std::int32_t> placeOf, double p) const {
        const double best = optimum(p);
        const double least = static_cast<double>(costs.characters.size()) * muster::power(0.25, p);
        return (objective(placeOf, p) - best) / std::max(best, least);
    }
    /// As many pairs as can be, nobody and nothing twice, nothing forbidden.
    bool valid(std::span<const std::int32_t> placeOf) const {
        std::vector<int> taken(costs.places.size(), 0);
        std::size_t people = 0;
        std::size_t free = 0;
        std::size_t pairs = 0;
        for (std::size_t j = 0; j < taken.size(); ++j) free += input().mayTake(j) ? 1 : 0;
        for (std::size_t i = 0; i < placeOf.size(); ++i) {
            people += input().takesPart(i) ? 1 : 0;
            if (placeOf[i] < 0) continue;
            const auto j = static_cast<std::size_t>(placeOf[i]);
            if (j >= taken.size() || !input().mayTake(j) || !input().takesPart(i) || taken[j]++ > 0)
                return false;
            ++pairs;
        }
        return pairs == std::min(people, free);
    }
};

}  // namespace muster_test
