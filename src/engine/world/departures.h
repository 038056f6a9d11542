// People that leave a world by its exits or come into it by its sources: figures of an evacuation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/world.h"

namespace muster {

/// Figures of an exit in a run.
struct ExitFigures {
    AreaId id;               ///< Id of the exit, which may be removed by now.
    std::string name;        ///< Its name; may be empty.
    std::uint32_t left = 0;  ///< Persons who left by it.
    double first = -1.0;     ///< Time when the first one left [s]; -1 where nobody did.
    double last = -1.0;      ///< Time when the last one left [s]; -1 where nobody did.
    double flow = -1.0;      ///< Mean flow (left - 1) / (last - first) [1/s]; -1 where that is no number.
};

/// Figures of a source in a run.
struct SourceFigures {
    AreaId id;                  ///< Id of the source, which may be removed by now.
    std::string name;           ///< Its name; may be empty.
    std::uint32_t entered = 0;  ///< Persons who came by it.
    std::uint32_t waiting = 0;  ///< Persons who wait for room in it at the end.
};

/// Figures of people that leave and come. Times count from the beginning of the world; -1 where not reached.
struct DepartureFigures {
    std::uint32_t left = 0;  ///< Persons who left by an exit.
    double first = -1.0;     ///< Time when the first of them left [s].
    double last = -1.0;      ///< Time when the last of them left [s].
    /// Time when half of all had left, among people that left, are still there or wait at a source [s]; -1
    /// also while a source may still send more.
    double left50 = -1.0;
    double left95 = -1.0;                ///< Time when 95 % of all had left [s], as left50.
    std::vector<ExitFigures> exits;      ///< Figures in ascending order of ids.
    std::vector<SourceFigures> sources;  ///< Figures in ascending order of ids.
};

/// Watches people that leave and come.
class DepartureWatch {
public:
    /// Call before the first step and after every one.
    void observe(const World& world);
    /// The figures so far.
    DepartureFigures figures(const World& world) const;
    /// The step in which each person that left did, ascending.
    const std::vector<std::uint32_t>& leftAt() const { return leftAt_; }
    /// True while an open source may still send people to a group that is there.
    static bool moreMayCome(const World& world);

private:
    void listAreas(const World& world);

    std::vector<ExitFigures> exits_;      // Figures of all exits that have been there, by ascending ids.
    std::vector<SourceFigures> sources_;  // Figures of all sources that have been there, by ascending ids.
    std::vector<std::uint32_t> leftAt_;
    bool listed_ = false;
};

}  // namespace muster
