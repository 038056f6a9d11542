#include "engine/steering/gates.h"

#include <algorithm>
#include <cmath>

#include "engine/ground/environment/obstacle_piece.h"
#include "engine/steering/characters.h"

namespace muster {
namespace {

constexpr double kReach = 5.0;       // Visitors are this near to the gate [m].
constexpr double kCoarseCell = 8.0;  // Edge of a coarse cell [m].
constexpr double kLongest = 3.0;     // Half the length of a gate, at most [m];
constexpr double kDepthStep = 0.1;   // it is measured in such steps [m].
constexpr double kAtPlace = 0.5;     // Who is nearer to its place passes no gate [m].
constexpr double kLane = 3.0;        // How far beyond a mouth the lane is kept free [m].
constexpr double kMargin = 0.3;      // Kept from the lane [m].
constexpr double kTurn = 20.0;       // Time for which one direction has the gate [s],
constexpr double kClearing = 2.0;    // in the last part of which nobody enters.
constexpr double kHeading = 0.7;     // Cosine from which somebody heads for the gate.
constexpr double kWalking = 0.2;     // Who is slower in the gate stands [m/s].
constexpr double kStopping = 0.3;    // Time within which who must not enter stops [s].

// True where something that stands still is nearer than `reach`. Where moving things are just now must not
// matter, because the gates are kept.
bool isNarrow(const Environment& environment, Vec2 p, double reach) {
    bool narrow = false;
    environment.forPiecesNear(p, reach, [&](const ObstaclePiece& piece) {
        narrow = narrow || (!piece.moving && piece.signedDistance(p) < reach);
    });
    return narrow;
}

}  // namespace

void Gates::find(const Environment& environment, double radius) {
    if (instance_ == environment.instance() && version_ == environment.staticVersion() && radius_ == radius)
        return;
    instance_ = environment.instance();
    version_ = environment.staticVersion();
    radius_ = radius;
    gates_.clear();
    gaps_.clear();
    const Box box = environment.def().box;
    environment.closedGaps(box, 4.0 * radius, gaps_);
    for (const ClosedGap& gap : gaps_) {
        const double width = distance(gap.a, gap.b);
        if (width < 2.0 * radius - 1e-6) continue;
        const Vec2 across = (gap.b - gap.a) / width;
        const Vec2 centre = 0.5 * (gap.a + gap.b), through = perpendicular(across);
        double depth = 0.0;
        for (const double way : {1.0, -1.0}) {
            double end = 0.0;
            while (end < kLongest && isNarrow(environment, centre + through * (way * end), 2.0 * radius))
                end += kDepthStep;
            depth = std::max(depth, end);
        }
        gates_.push_back({centre, through, across, 0.5 * width, depth});
    }
    visitors_.resize(gates_.size());
    sortIntoCells(box);
}

// Sorts the gates by the coarse cells from which they may be visited.
void Gates::sortIntoCells(const Box& box) {
    grid_ = Grid::covering(box, kCoarseCell);
    first_.assign(grid_.count() + 1, 0);
    const auto forCells = [&](const Gate& gate, const auto& visit) {
        const Cell low = grid_.nearestCell(gate.centre - Vec2{kReach, kReach});
        const Cell high = grid_.nearestCell(gate.centre + Vec2{kReach, kReach});
        for (std::int32_t y = low.y; y <= high.y; ++y)
            for (std::int32_t x = low.x; x <= high.x; ++x) visit(grid_.index({x, y}));
    };
    for (const Gate& gate : gates_) forCells(gate, [&](std::int32_t cell) { ++first_[cell + 1]; });
    for (std::int32_t cell = 0; cell < grid_.count(); ++cell) first_[cell + 1] += first_[cell];
    near_.resize(first_.back());
    std::vector<std::int32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t g = 0; g < gates_.size(); ++g)
        forCells(gates_[g], [&](std::int32_t cell) { near_[next[cell]++] = static_cast<std::int32_t>(g); });
}

void Gates::listVisitors(const Characters& now) {
    for (const std::int32_t g : visited_) visitors_[g].clear();
    visited_.clear();
    for (std::size_t i = 0; i < now.size(); ++i) {
        const std::int32_t cell = grid_.index(grid_.nearestCell(now.position[i]));
        for (std::int32_t k = first_[cell]; k < first_[cell + 1]; ++k) {
            const Gate& gate = gates_[near_[k]];
            const Vec2 from = now.position[i] - gate.centre;
            const double left = length(from);
            if (left > kReach || !(now.cost[i] > kAtPlace)) continue;
            Visitor visitor{static_cast<std::int32_t>(i), dot(from, gate.through), dot(from, gate.across), 0,
                            false};
            const double heading = dot(now.direction[i], gate.through);
            const bool inside = std::fabs(visitor.through) < gate.depth &&
                                std::fabs(visitor.across) < gate.halfWidth;
            const bool comes = -dot(now.direction[i], from) > kHeading * left &&
                               visitor.through * heading < 0.0 && now.cost[i] > left;
            if (inside || comes) visitor.way = heading > 0.0 ? 1 : -1;
            visitor.passing = comes ||
                              (inside && dot(now.velocity[i], gate.through) * visitor.way > kWalking);
            if (visitors_[near_[k]].empty()) visited_.push_back(near_[k]);
            visitors_[near_[k]].push_back(visitor);
        }
    }
}

// Has to leave the gate and the lane behind it, in which the others come out, or not to enter.
void Gates::wait(const Gate& gate, const Visitor& visitor, double turn, double topSpeed, double radius,
                 std::span<Vec2> leaving, std::span<Vec2> preferred) {
    Vec2& own = preferred[visitor.character];
    const double half = gate.halfWidth + radius + kMargin;
    const double out = visitor.through * turn;  // Along the way of those whose turn it is.
    if (std::fabs(visitor.through) < gate.depth && std::fabs(visitor.across) < gate.halfWidth) {
        leaving[visitor.character] = gate.through * (turn * topSpeed);
        any_ = true;
    } else if (out > 0.0 && out < gate.depth + kLane && std::fabs(visitor.across) < half) {
        leaving[visitor.character] = gate.across * (visitor.across < 0.0 ? -topSpeed : topSpeed);
        any_ = true;
    } else if (out > 0.0 && out < gate.depth + kLane + 0.5) {
        const double side = visitor.across < 0.0 ? -1.0 : 1.0;
        const double gap = std::fabs(visitor.across) - half;
        const double entering = -side * dot(own, gate.across);
        if (entering * kStopping > gap) own += gate.across * (side * (entering - gap / kStopping));
    }
}

void Gates::takeTurns(const Gate& gate, double time, double topSpeed, double radius,
                      std::span<const Visitor> visitors, std::span<Vec2> leaving, std::span<Vec2> preferred) {
    const auto wants = [&](std::int8_t way) {
        return std::any_of(visitors.begin(), visitors.end(),
                           [&](const Visitor& v) { return v.passing && v.way == way; });
    };
    if (!wants(1) || !wants(-1)) return;
    const double turns = std::floor(time / kTurn);
    const double turn = turns - 2.0 * std::floor(0.5 * turns) > 0.5 ? -1.0 : 1.0;
    const bool clearing = time - turns * kTurn > kTurn - kClearing;
    for (const Visitor& visitor : visitors) {
        if (visitor.way == -turn) {
            wait(gate, visitor, turn, topSpeed, radius, leaving, preferred);
        } else if (clearing && visitor.way == turn && visitor.through * turn < -0.5 * gate.depth) {
            Vec2& own = preferred[visitor.character];
            const double gap = -visitor.through * turn - 0.5 * gate.depth;
            const double entering = turn * dot(own, gate.through);
            if (entering * kStopping > gap) own -= gate.through * (turn * (entering - gap / kStopping));
        }
    }
}

bool Gates::run(const Parameters::Character& def, const Characters& now, const Environment& environment,
                std::span<Vec2> leaving, std::span<Vec2> preferred) {
    find(environment, def.radius);
    any_ = false;
    if (gates_.empty()) return false;
    listVisitors(now);
    for (const std::int32_t g : visited_)
        takeTurns(gates_[g], environment.time(), def.maxSpeed, def.radius, visitors_[g], leaving, preferred);
    return any_;
}

}  // namespace muster
