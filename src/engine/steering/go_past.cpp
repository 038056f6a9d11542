#include "engine/steering/go_past.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kPastDistance = 0.02;    // Distance to a standing character [m].
constexpr double kFarthestTurn = -0.2;    // Cosine of the largest turn.
constexpr double kAngleRounding = 1e-9;   // Rounding of cosines and distances.
constexpr std::size_t kStandersEach = 8;  // Reserved number of standing characters near a walker.

}  // namespace

// Lists standing characters before the place of a walker, not on it.
void GoPast::list(const CrowdBodies& bodies, const Characters& now, std::int32_t walker, std::size_t first,
                  std::size_t end, Vec2 toPlace) {
    standers_.clear();
    for (std::size_t k = first; k < end; ++k) {
        const std::int32_t other = near_[k].second;
        const Vec2 to = bodies.between(now.position[walker], now.position[other]);
        const double keep = bodies.touching(walker, other) + kPastDistance;
        const bool onPlace = lengthSquared(toPlace - to) < keep * keep;
        if (!onPlace && lengthSquared(to) < lengthSquared(toPlace)) standers_.push_back({to, keep});
    }
}

// Turns a direction to one side until no standing character is in it; false where it would lead back.
bool GoPast::turn(double side, Vec2& unit) const {
    const Vec2 straight = unit;
    for (std::size_t round = 0; round <= standers_.size(); ++round) {
        bool blocked = false;
        for (const Stander& stander : standers_) {
            if (dot(stander.to, unit) <= kAngleRounding ||
                std::fabs(cross(unit, stander.to)) >= stander.keep - kAngleRounding)
                continue;
            const double away = length(stander.to), sine = std::min(1.0, stander.keep / away);
            unit = Rotation{std::sqrt(1.0 - sine * sine), side * sine}.apply(stander.to / away);
            blocked = true;
        }
        if (dot(unit, straight) < kFarthestTurn) return false;
        if (!blocked) return true;
    }
    return false;
}

void GoPast::run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
                 const NeighbourList& neighbours, std::span<const std::uint8_t> standing,
                 std::span<const Vec2> places, std::span<Vec2> wanted) {
    near_.reserve(kStandersEach * standing.size());
    near_.clear();
    for (const NeighbourPair pair : neighbours.pairs()) {
        if (standing[pair.low] == standing[pair.high]) continue;
        const bool lowStands = standing[pair.low] != 0;
        near_.emplace_back(lowStands ? pair.high : pair.low, lowStands ? pair.low : pair.high);
    }
    std::sort(near_.begin(), near_.end());
    for (std::size_t first = 0, end = 0; first < near_.size(); first = end) {
        const std::int32_t i = near_[first].first;
        while (end < near_.size() && near_[end].first == i) ++end;
        const double speed = length(wanted[i]);
        if (speed == 0.0 || bodies.isFixed(i) || now.phase[i] == MotionPhase::Locked) continue;
        const Vec2 here = now.position[i], straight = wanted[i] / speed;
        list(bodies, now, i, first, end, places[i] - here);
        Vec2 left = straight, right = straight;
        const double reach = 2.0 * bodies.radius(i);
        const auto open = [&](double side, Vec2& unit) {
            return turn(side, unit) && (unit == straight || environment.clearStaticLine(
                                                                here, here + unit * reach, bodies.radius(i)));
        };
        const bool byLeft = open(1.0, left), byRight = open(-1.0, right);
        if (byRight && (!byLeft || dot(right, straight) >= dot(left, straight) - kAngleRounding))
            wanted[i] = right * speed;
        else if (byLeft)
            wanted[i] = left * speed;
    }
}

}  // namespace muster
