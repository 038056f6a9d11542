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

/// True for the kinds whose events are about so many characters of a group as `value` says.
constexpr bool isAboutMany(EventKind kind) {
    return kind == EventKind::Arrived || kind == EventKind::Blocked || kind == EventKind::Free ||
           kind == EventKind::NoPath;
}

/// Figures of a run. Times count from the last command, those of departures from the beginning.
struct RunFigures {
    std::int32_t characters = 0;  ///< At the end.
    std::uint32_t steps = 0;      ///< Done.
    std::uint64_t hash = 0;       ///< Of the state at the end.
    /// When 95 % had arrived of all who are there or have left by an exit, which is arriving [s]; -1 where
    /// not reached, and while a source may still send more.
    double arrived95 = -1.0;
    double arrived100 = -1.0;  ///< When all had arrived [s], as arrived95.
    std::int32_t stuck = 0;    ///< Not arrived, and within 0.25 m for the last 5 s.
    /// Length walked over the least-sum geodesic assignment; -1 where it has no meaning.
    double pathRatio = -1.0;
    std::int32_t overlapPairsMax = 0;  ///< Most pairs at once deeper than 10 % of the mean diameter.
    double worstPenetration = 0.0;     ///< Share of the mean diameter.
    double
        topSpeedRatio = 0.0;  ///< Largest displacement of a step, in steps at own top speed on that ground.
    double swapsPerCharacterPerSecond = 0.0;  ///< Changes of place without a command.
    WalkTotals planned;                       ///< Paths to the places by the last plan, all groups.
    WalkTotals walked;                        ///< Paths walked by those still there.
    double lagP95 = 0.0;                      ///< Distance to the place at the end, p95 [m].
    std::int32_t unmatched = 0;               ///< At the end.
    std::int32_t collected = 0;               ///< Items.
    EventCounts events{};                     ///< Of the whole run, by kind.
    /// For the kinds that isAboutMany(): the sum over groups of the most characters that an event was about.
    EventCounts eventPersons{};
    DepartureFigures departures;                  ///< Who left by exits and came by sources.
    double stepP50 = 0.0;                         ///< [ms]
    double stepP95 = 0.0;                         ///< [ms]
    double stepMax = 0.0;                         ///< [ms]
    std::array<double, kStageCount> stageMean{};  ///< [ms] by Stage.
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

    /// True where nothing is left to do: no control still moves, places stand, all have arrived or left, no
    /// group has further orders, and no source may still send anybody.
    bool settled(const World& world) const;
    /// Characters that are not arrived.
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
    std::vector<std::uint32_t> reachedAt_;  // Step at which it got within reach; kNever outside.
    std::vector<Vec2> start_;
    std::vector<Vec2> last_;
    std::vector<double> walked_;
    std::vector<std::array<Vec2, 6>> trail_;  // Positions by second, the newest first.
    std::uint32_t trailSamples_ = 0;
    std::uint32_t samplePeriod_ = 60;  // Steps in a second.
    bool still_ = true;                // Nothing moved on a path and no command was given.
    std::vector<float> stepTimes_;
    std::array<double, kStageCount> stageSum_{};
    EventCounts events_{};
    std::map<std::pair<EventKind, std::uint32_t>, std::uint32_t> persons_;  // By kind and group, the most.
    DepartureWatch departures_;
    double characterSeconds_ = 0.0;
    std::int32_t overlapPairsMax_ = 0;
    double worstPenetration_ = 0.0;
    double topSpeedRatio_ = 0.0;
};

/// Least sum of geodesic lengths that takes every start to a place of its own [m], round obstacles and
/// regardless of patches; -1 where somebody cannot get there.
double leastWalk(const Environment& environment, double radius, std::span<const Vec2> starts,
                 std::span<const Vec2> places);

}  // namespace muster
