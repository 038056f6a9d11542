#include "engine/steering/overtaking.h"

#include <algorithm>
#include <limits>

#include "engine/steering/lane.h"
#include "muster/vec2.h"

namespace muster {
namespace {

// Rotations by 0, 20, 40 and 60 degrees.
constexpr Rotation kTurn[kOvertakingTurns + 1] = {{1.0, 0.0},
                                                  {0.93969262078590838405, 0.34202014332566873304},
                                                  {0.76604444311897803520, 0.64278760968653932632},
                                                  {0.5, 0.86602540378443864676}};
constexpr double kLookTime = 0.1;       // Time between two looks of a walker [s].
constexpr double kTurnGain = 0.02;      // Share of its speed by which a walker must get on better to turn.
constexpr double kArrivingShare = 0.5;  // Share of its top speed below which a walker is arriving.
constexpr double kBehindCosineSquared = 0.25;  // Squared cosine backwards above which an agent is behind.
constexpr double kWallShare = 0.98;            // Share of its radius that must be clear of walls.
constexpr std::size_t kNearEach = 32;          // Reserved number of agents near a walker.

Vec2 turned(Vec2 ahead, std::int8_t turn) {
    return turn < 0 ? kTurn[-turn].applyInverse(ahead) : kTurn[turn].apply(ahead);
}

}  // namespace

// Lists agents that are not behind a walker, and no farther than it walks in the time of its headway.
void Overtaking::list(const CrowdBodies& bodies, const Characters& now, std::span<const std::int32_t> near,
                      std::size_t self, const Walker& walker) {
    others_.clear();
    for (const std::int32_t other : near) {
        const Vec2 between = bodies.between(walker.position, now.position[other]);
        const double touching = bodies.touching(self, other),
                     reach = touching + walker.headway * walker.speed;
        const double apart2 = lengthSquared(between), along = dot(between, walker.ahead);
        if (apart2 < reach * reach && (along > 0.0 || along * along < kBehindCosineSquared * apart2))
            others_.push_back({between, now.velocity[other], touching});
    }
}

// The speed that a walker will have along a heading after the time of foresight, and the distance until it is
// past the agent ahead. The search stops where the speed is at most `least`.
Overtaking::Prospect Overtaking::prospect(Vec2 heading, const Walker& walker, double least) const {
    Prospect found{walker.speed, 0.0};
    for (const Other& other : others_) {
        const double way = wayAhead(other.between, heading, other.touching);
        if (way == std::numeric_limits<double>::infinity()) continue;
        const double ahead = std::max(0.0, dot(other.velocity, heading));
        const double speed = ahead + (std::max(0.0, way) - walker.headway * ahead) / walker.foresight;
        if (speed < found.speed) found = {speed, dot(other.between, heading) + other.touching};
        if (found.speed <= least) return found;
    }
    return found;
}

std::int8_t Overtaking::turnOf(const Walker& walker, const Environment& environment) const {
    const Prospect straight = prospect(walker.ahead, walker, -std::numeric_limits<double>::infinity());
    double best = straight.speed + kTurnGain * walker.speed;
    std::int8_t found = 0;
    for (std::int8_t turn = 1; turn <= kOvertakingTurns; ++turn) {
        const double cosine = kTurn[turn].c;
        if (cosine * walker.speed <= best) return found;
        for (const std::int8_t side : {static_cast<std::int8_t>(-turn), turn}) {
            const Vec2 heading = turned(walker.ahead, side);
            const double progress = cosine * prospect(heading, walker, best / cosine).speed;
            if (progress <= best) continue;
            const Vec2 past = walker.position + heading * straight.past;
            if (!environment.clearStaticLine(walker.position, past, kWallShare * walker.radius)) continue;
            best = progress;
            found = side;
        }
    }
    return found;
}

void Overtaking::run(const CrowdBodies& bodies, const Environment& environment, const NearRows& rows,
                     std::span<const double> topSpeed, std::uint32_t step, double dt, Characters& now,
                     std::span<Vec2> wanted) {
    others_.reserve(kNearEach);
    const auto steps = std::max(1u, static_cast<std::uint32_t>(kLookTime / dt));
    for (std::size_t i = 0; i < now.size(); ++i) {
        std::int8_t& turn = now.claim[i].turn;
        const double speed = length(wanted[i]);
        if (speed <= kArrivingShare * topSpeed[i] || bodies.isFixed(i) ||
            now.phase[i] == MotionPhase::Locked) {
            turn = 0;
            continue;
        }
        if ((step + now.id[i]) % steps == 0) {
            const Walker walker{now.position[i],  wanted[i] / speed, speed,
                                bodies.radius(i), bodies.headway(i), bodies.usual().foresight};
            list(bodies, now, rows.of(static_cast<std::int32_t>(i)), i, walker);
            turn = turnOf(walker, environment);
        }
        if (turn != 0) wanted[i] = turned(wanted[i], turn);
    }
}

}  // namespace muster
