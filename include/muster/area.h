// Areas: where people leave the world, come into it, and wait. They are no obstacles.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/geometry.h"
#include "muster/id.h"

namespace muster {

/// How many people a source has let in by a time.
struct Arrivals {
    double time = 0.0;       ///< [s] of the world.
    std::int32_t count = 0;  ///< That come at this time.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(time, count);
    }
    friend bool operator==(const Arrivals&, const Arrivals&) = default;
};

/// Definition of an area.
struct AreaDef {
    std::string name;                ///< Name for display: "Main exit".
    AreaKind kind = AreaKind::Exit;  ///< What it does.
    Polygon polygon;                 ///< Corners of a simple polygon, convex or not [m].
    bool open = true;                ///< False: nobody leaves or comes here for now.
    /// For Exit: the most people who leave in a second, 0 to 1000; 0 for as many as come. For Source: how
    /// many come in a second on average, at random times by the world's seed, 0 to 1000.
    double rate = 0.0;
    /// For Exit: a line in which people queue, from who is next to the last; empty for a crowd.
    std::vector<Vec2> queue;
    std::int32_t group = 0;  ///< For Source in a WorldDef: index of the group whom its people join.
    double from = 0.0;       ///< For Exit: when it opens; for Source with a rate: when it begins [s].
    double until = 1e9;      ///< For Exit: when it closes; for Source with a rate: when it ends [s].
    std::int32_t most = 0;   ///< For Source with a rate: how many come in all; 0 for no end.
    std::vector<Arrivals> timetable;  ///< For Source: further people, by ascending times.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, kind, polygon, open, rate, queue, group, from, until, most, timetable);
    }
    friend bool operator==(const AreaDef&, const AreaDef&) = default;
};

/// What an area has seen.
struct AreaCount {
    std::uint32_t passed = 0;   ///< People who have left by an exit, or come by a source.
    std::uint32_t waiting = 0;  ///< People of a source for whom there is no room yet.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(passed, waiting);
    }
};

}  // namespace muster
