// Who leaves a world by its exits, and who comes into it by its sources: figures of an evacuation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/world.h"

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
    double left95 = -1.0;                ///< When 95 % of all had left [s], as left50.
    std::vector<ExitFigures> exits;      ///< In ascending order of ids.
    std::vector<SourceFigures> sources;  ///< In ascending order of ids.
};

/// Watches who leaves and comes.
class DepartureWatch {
public:
    /// Call before the first step and after every one.
    void observe(const World& world);
    /// The figures so far.
    DepartureFigures figures(const World& world) const;
    /// In which step each of those who left did, ascending.
    const std::vector<std::uint32_t>& leftAt() const { return leftAt_; }
    /// True while an open source may still send people to a group that is there.
    static bool moreMayCome(const World& world);

private:
    void listAreas(const World& world);

    std::vector<ExitFigures> exits_;      // Of all that have been there, by ascending ids.
    std::vector<SourceFigures> sources_;  // The same.
    std::vector<std::uint32_t> leftAt_;
    bool listed_ = false;
};

}  // namespace muster
