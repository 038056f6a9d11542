#include "engine/steering/overtaking.h"

#include <algorithm>
#include <limits>

#include "engine/steering/lane.h"
#include "muster/vec2.h"

namespace muster {
namespace {

// By 20, 40 and 60 degrees to either side.
constexpr Rotation kTurns[] = {{0.93969262078590838405, 0.34202014332566873304},
                               {0.76604444311897803520, 0.64278760968653932632},
                               {0.5, 0.86602540378443864676}};
constexpr double kGain = 0.02;            // Share of its speed by which it must get on better to turn.
constexpr double kSlowed = 0.5;           // Who wants to walk at a smaller share of its top speed is arriving.
constexpr double kTight = 0.98;           // Share of its radius that must be clear of walls.
constexpr std::size_t kNearEach = 32;     // Room that is kept for those near it.

}  // namespace

Overtaking::Other Overtaking::other(const CrowdBodies& bodies, const Characters& now, std::int32_t self,
                                    std::int32_t other) {
    return {bodies.between(now.position[self], now.position[other]), now.velocity[other],
            bodies.touching(self, other)};
}

// What there is to be expected along a heading behind somebody: the speed after the time of foresight.
void Overtaking::keepBehind(const Other& other, Vec2 heading, const Walker& walker, Prospect& found) {
    const double way = wayAhead(other.between, heading, other.touching);
    if (way == std::numeric_limits<double>::infinity()) return;
    const double ahead = std::max(0.0, dot(other.velocity, heading));
    const double speed = ahead + (std::max(0.0, way) - walker.headway * ahead) / walker.foresight;
    if (speed < found.speed) found = {speed, dot(other.between, heading) + other.touching};
}

void Overtaking::turn(const Walker& walker, const Environment& environment, const Prospect& straight,
                      Vec2& wanted) const {
    const Vec2 ahead = wanted / walker.speed;
    double best = straight.speed + kGain * walker.speed;
    for (const Rotation turn : kTurns) {
        if (turn.c * walker.speed <= best) return;
        for (const Vec2 heading : {turn.applyInverse(ahead), turn.apply(ahead)}) {
            Prospect found{walker.speed, 0.0};
            for (const Other& other : others_) keepBehind(other, heading, walker, found);
            const double progress = turn.c * found.speed;
            if (progress <= best) continue;
            const Vec2 past = walker.position + heading * straight.past;
            if (!environment.clearStaticLine(walker.position, past, kTight * walker.radius)) continue;
            best = progress;
            wanted = heading * walker.speed;
        }
    }
}

void Overtaking::run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
                     const NearRows& rows, std::span<const double> topSpeed, std::span<Vec2> wanted) {
    others_.reserve(kNearEach);
    for (std::size_t i = 0; i < now.size(); ++i) {
        const double speed = length(wanted[i]);
        if (speed <= kSlowed * topSpeed[i] || bodies.isFixed(i) || now.phase[i] == MotionPhase::Locked)
            continue;
        const auto self = static_cast<std::int32_t>(i);
        const Walker walker{now.position[i], speed, bodies.radius(i), bodies.headway(i),
                            bodies.usual().foresight};
        const Vec2 ahead = wanted[i] / speed;
        Prospect straight{speed, 0.0};
        for (const std::int32_t near : rows.of(self))
            keepBehind(other(bodies, now, self, near), ahead, walker, straight);
        if (straight.speed + kGain * speed >= kTurns[0].c * speed) continue;
        others_.clear();
        for (const std::int32_t near : rows.of(self)) others_.push_back(other(bodies, now, self, near));
        turn(walker, environment, straight, wanted[i]);
    }
}

}  // namespace muster
