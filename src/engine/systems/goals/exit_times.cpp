#include "engine/systems/goals/exit_times.h"

#include <algorithm>

#include "engine/passages/specific_flow.h"

namespace muster {
namespace {

constexpr double kLawTime = 1.0;          // Time of measurement for which the law counts [s].
constexpr double kLeastFlow = 1e-3;       // Least flow of an exit or a door [1/s].
constexpr double kShutWait = 1e4;         // Time that a person waits at a door that is shut [s].
constexpr std::int32_t kMostDoors = 8;    // Greatest number of doors one after the other that are looked at.
constexpr double kWidthBeforeDoor = 1.0;  // Distance before a door at which the width of a route is read [m].

}  // namespace

void ExitTimes::begin(const Doors& doors, std::span<Area* const> exits,
                      std::vector<const Doors::ToExit*>& toExit, double metresPerSecond) {
    doors_ = &doors;
    exits_.assign(exits.begin(), exits.end());
    toExit_ = toExit;
    speed_ = metresPerSecond;
    waits_.clear(exits.size(), toExit.empty() ? 0 : doors.ways());
}

ExitTimes::First ExitTimes::first(std::size_t exit, Vec2 p, std::int32_t way, double seconds,
                                  double metresPerSecond) const {
    if (toExit_.empty()) return {-1, seconds};
    const Doors::ToExit& to = *toExit_[exit];
    if (way < 0) way = doors_->nearestWay(to, p);
    if (way < 0) return {-1, seconds};
    return {way, std::max(0.0, seconds - to.onward[way] / metresPerSecond)};
}

void ExitTimes::serveExit(std::size_t e, const Parameters::Character& usual, const GoalField& field) {
    Area& area = *exits_[e];
    const double flow = specificFlow(usual);
    const double most = toExit_.empty() ? kInfiniteCost : std::max(0.0, toExit_[e]->free - kWidthBeforeDoor);
    const auto byWidth = [&](double walk) {
        return flow * (field.width(std::min(most, walk * speed_)) + 2.0 * usual.radius);
    };
    const double measured = (kLawTime * byWidth(0.0) + area.exit.served) / (kLawTime + area.exit.queued);
    const double whole = area.def.rate > 0.0 ? std::min(area.def.rate, measured) : measured;
    area.exit.isQueued = waits_.isQueued(e, whole);
    // Only the rest of a service that has begun counts.
    const double begins = area.def.rate > 0.0 ? (1.0 - area.exit.credit) / area.def.rate : 0.0;
    waits_.serve(e, begins,
                 [&](double walk) { return std::max(kLeastFlow, std::min(whole, byWidth(walk))); });
}

void ExitTimes::serve(const Parameters::Character& usual, std::span<const GoalField* const> fields) {
    const double flow = specificFlow(usual);
    flow_.clear();
    for (std::int32_t way = 0; !toExit_.empty() && std::cmp_less(way, doors_->ways()); ++way)
        flow_.push_back(doors_->isShut(way) ? kLeastFlow
                                            : std::max(kLeastFlow, doors_->door(way).capacity(flow)));
    waits_.serveWays([&](std::int32_t way) { return flow_[way]; },
                     [&](std::int32_t way, std::size_t exit, double now) {
                         const First to = next(way, exit, now, speed_, [&](std::int32_t other, double at) {
                             return waits_.passes(other, now, at) + (doors_->isShut(other) ? kShutWait : 0.0);
                         });
                         return ExitWaits::Hop{nodeOf(exit, to.way), to.walk};
                     });
    for (std::size_t e = 0; e < exits_.size(); ++e) serveExit(e, usual, *fields[e]);
}

double ExitTimes::passes(std::int32_t way, double at, bool isCounted) const {
    return waits_.leaves(waits_.nodeOf(way), at, isCounted) + (doors_->isShut(way) ? kShutWait : 0.0);
}

double ExitTimes::leaves(std::size_t exit, const First& first, double metresPerSecond, bool isCounted) const {
    if (first.ahead >= 0) return waits_.leavesLine(exit, first.ahead, first.walk);
    First at = first;
    double time = at.way < 0 ? waits_.leaves(exit, at.walk, isCounted) : passes(at.way, at.walk, isCounted);
    for (std::int32_t hop = 0; at.way >= 0; ++hop) {
        if (hop == kMostDoors) return time + toExit_[exit]->onward[at.way] / metresPerSecond;
        at = next(at.way, exit, time, metresPerSecond,
                  [&](std::int32_t other, double now) { return passes(other, now); });
        time = at.way < 0 ? waits_.leaves(exit, time + at.walk, false) : passes(at.way, time + at.walk);
    }
    return time;
}

std::int32_t ExitTimes::onwardFrom(std::int32_t way, std::size_t exit, double metresPerSecond) const {
    return next(way, exit, 0.0, metresPerSecond,
                [&](std::int32_t other, double now) { return passes(other, now); })
        .way;
}

}  // namespace muster
