// Figures of a run, in the words of the specification's section 8.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "engine/steering/walk_progress.h"
#include "engine/world/departures.h"
#include "engine/world/generated/figures.h"
#include "muster/world.h"

namespace muster {

class Environment;

/// Number of events by kind.
using EventCounts = decltype(RunFigures::events);

/// True for kinds whose events are about several characters of a group; `value` is their number.
constexpr bool isAboutMany(EventKind kind) {
    return kind == EventKind::Arrived || kind == EventKind::Blocked || kind == EventKind::Free ||
           kind == EventKind::NoPath;
}

/// Watches a world and never changes it.
class RunMetrics {
public:
    /// Starts watching; call before the first step.
    explicit RunMetrics(const World& world);
    /// Call after every step.
    void observe(const World& world);
    /// The figures so far. The path ratio needs one cost field per place, so it can be left out (-1).
    RunFigures figures(const World& world, bool withPathRatio = true) const;

    /// True where nothing is left to do: no control still moves, places stand, all characters have arrived or
    /// left, no group has further orders, and no source may still send anybody.
    bool settled(const World& world) const;
    /// Number of characters that have not arrived.
    std::int32_t notArrived(const World& world) const;

private:
    void follow(const CharactersView& characters);
    void watchArrivals(const World& world);
    void watchSpeeds(const World& world);
    void watchEvents(const World& world);
    bool hasArrived(const World& world, std::size_t character) const;
    void arrivals(const World& world, RunFigures& figures) const;
    double pathRatio(const World& world) const;

    std::vector<std::uint32_t> ids_;
    std::vector<std::uint32_t> reachedAt_;  // Step at which each character got within reach; kNever outside.
    std::vector<Vec2> start_;
    std::vector<Vec2> last_;
    std::vector<double> walked_;
    std::vector<std::array<Vec2, 6>> trail_;  // Positions by second, the newest first.
    std::uint32_t trailSamples_ = 0;
    std::uint32_t samplePeriod_ = 60;  // Number of steps in a second.
    bool still_ = true;                // True while nothing moved on a path and no command was given.
    std::vector<float> stepTimes_;
    std::array<double, kStageCount> stageSum_{};
    EventCounts events_{};
    // Greatest number of characters, by kind and group.
    std::map<std::pair<EventKind, std::uint32_t>, std::uint32_t> persons_;
    DepartureWatch departures_;
    double characterSeconds_ = 0.0;
    std::int32_t overlapPairsMax_ = 0;
    double worstPenetration_ = 0.0;
    double topSpeedRatio_ = 0.0;
};

/// Least sum of geodesic lengths that takes every start to a place of its own [m], round obstacles and
/// regardless of patches; -1 where a start has no path there.
double leastWalk(const Environment& environment, double radius, std::span<const Vec2> starts,
                 std::span<const Vec2> places);

}  // namespace muster
