// Made by schema/generate.mjs from schema/api/figures.txt: change these, not this file.
// Figures of runs, in the words of the specification's section 8.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/generated/walk_totals.h"
#include "muster/id.h"
#include "muster/views.h"

namespace muster {

/// What an exit let through in a run.
struct ExitFigures {
    AreaId id;               ///< Of the exit, which may be no more.
    std::string name;        ///< Its name; may be empty.
    std::uint32_t left = 0;  ///< Persons who left by it.
    double first = -1.0;     ///< When the first one did [s]; -1 where nobody did.
    double last = -1.0;      ///< When the last one did [s]; -1 where nobody did.
    double flow = -1.0;      ///< (left - 1) / (last - first) [1/s]; -1 where that is no number.
};

/// What a source let in in a run.
struct SourceFigures {
    AreaId id;                  ///< Of the source, which may be no more.
    std::string name;           ///< Its name; may be empty.
    std::uint32_t entered = 0;  ///< Persons who came by it.
    std::uint32_t waiting = 0;  ///< Persons who wait for room in it at the end.
};

/// Figures of those who leave and come. Times count from the beginning of the world; -1 where not reached.
struct DepartureFigures {
    std::uint32_t left = 0;  ///< Persons who left by an exit.
    double first = -1.0;     ///< When the first one of them left [s].
    double last = -1.0;      ///< When the last one of them left [s].
    /// When half of all had left: of those who left, who are still there and who wait at a source [s]; -1
    /// also while a source may still send more.
    double left50 = -1.0;
    double left95 = -1.0;                ///< When 95 % of all had left, as left50 [s].
    std::vector<ExitFigures> exits;      ///< In ascending order of ids.
    std::vector<SourceFigures> sources;  ///< In ascending order of ids.
};

/// Figures of a run. Times count from the last command, those of departures from the beginning.
struct RunFigures {
    std::int32_t characters = 0;  ///< At the end.
    std::uint32_t steps = 0;      ///< Done.
    std::uint64_t hash = 0;       ///< Of the state at the end.
    /// When 95 % had arrived of all who are there or have left by an exit, which is arriving [s]; -1 where
    /// not reached, and while a source may still send more.
    double arrived95 = -1.0;
    double arrived100 = -1.0;  ///< When all had arrived, as arrived95 [s].
    /// Not arrived, and within 0.25 m for the last 5 s.
    std::int32_t stuck = 0;
    /// Length walked over the least-sum geodesic assignment; -1 where it has no meaning.
    double pathRatio = -1.0;
    /// Most pairs at once deeper than 10 % of the mean diameter.
    std::int32_t overlapPairsMax = 0;
    double worstPenetration = 0.0;  ///< Share of the mean diameter.
    /// Largest displacement of a step, in steps at own top speed on that ground.
    double topSpeedRatio = 0.0;
    double swapsPerCharacterPerSecond = 0.0;  ///< Changes of place without a command.
    /// Paths to the places by the last plan, all groups.
    WalkTotals planned;
    WalkTotals walked;                                        ///< Paths walked by those still there.
    double lagP95 = 0.0;                                      ///< Distance to the place at the end, p95 [m].
    std::int32_t unmatched = 0;                               ///< At the end.
    std::int32_t collected = 0;                               ///< Items.
    std::array<std::uint64_t, kCountOf<EventKind>> events{};  ///< Of the whole run, by kind.
    /// For the kinds that isAboutMany(): the sum over groups of the most characters that an event was about.
    std::array<std::uint64_t, kCountOf<EventKind>> eventPersons{};
    DepartureFigures departures;                  ///< Who left by exits and came by sources.
    double stepP50 = 0.0;                         ///< Median time of a step [ms].
    double stepP95 = 0.0;                         ///< 95th percentile [ms].
    double stepMax = 0.0;                         ///< Longest step [ms].
    std::array<double, kStageCount> stageMean{};  ///< Mean time by stage [ms].
};

}  // namespace muster
