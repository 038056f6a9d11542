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
#include "muster/world.h"

namespace muster {

class Environment;

/// Number of events by kind.
using EventCounts = std::array<std::uint64_t, static_cast<std::size_t>(EventKind::Count)>;

/// True for kinds whose events are about several characters of a group; `value` is their number.
constexpr bool isAboutMany(EventKind kind) {
    return kind == EventKind::Arrived || kind == EventKind::Blocked || kind == EventKind::Free ||
           kind == EventKind::NoPath;
}

/// Figures of a run. Times count from the last command, times of departures from the beginning.
struct RunFigures {
    std::int32_t characters = 0;  ///< Number of characters at the end.
    std::uint32_t steps = 0;      ///< Number of steps done.
    std::uint64_t hash = 0;       ///< Hash of the state at the end.
    /// Time when 95 % had arrived, of all people that are there or have left by an exit, which is arriving
    /// [s]; -1 where not reached, and while a source may still send more.
    double arrived95 = -1.0;
    double arrived100 = -1.0;  ///< Time when all had arrived [s], as arrived95.
    std::int32_t stuck = 0;  ///< Characters that have not arrived, and stayed within 0.25 m for the last 5 s.
    /// Length walked over the least-sum geodesic assignment; -1 where it has no meaning.
    double pathRatio = -1.0;
    std::int32_t overlapPairsMax = 0;  ///< Most pairs at once deeper than 10 % of the mean diameter.
    double worstPenetration = 0.0;     ///< Greatest depth as a share of the mean diameter.
    /// Largest displacement of a step, in steps at own top speed on that ground.
    double topSpeedRatio = 0.0;
    double swapsPerCharacterPerSecond = 0.0;  ///< Changes of place without a command.
    WalkTotals planned;                       ///< Paths to the places by the last plan, all groups.
    WalkTotals walked;                        ///< Paths walked by characters that are still there.
    double lagP95 = 0.0;                      ///< Distance to the place at the end, p95 [m].
    std::int32_t unmatched = 0;               ///< Number of unmatched characters at the end.
    std::int32_t collected = 0;               ///< Number of collected items.
    EventCounts events{};                     ///< Number of events of the whole run, by kind.
    /// For the kinds of isAboutMany(): the sum over groups of the most characters that an event was about.
    EventCounts eventPersons{};
    DepartureFigures departures;                  ///< People that left by exits and came by sources.
    double stepP50 = 0.0;                         ///< Median time of a step [ms].
    double stepP95 = 0.0;                         ///< 95th percentile of the time of a step [ms].
    double stepMax = 0.0;                         ///< Greatest time of a step [ms].
    std::array<double, kStageCount> stageMean{};  ///< Mean time of each Stage [ms].
};

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
