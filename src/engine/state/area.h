// Exits, sources and waiting areas of a world, as its state holds them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "muster/ground.h"

namespace muster {

/// What an exit lets through.
struct ExitFlow {
    double served = 0.0;              ///< People who left while others queued, of late.
    double queued = 0.0;              ///< Time for which others queued, of late [s].
    bool isQueued = false;            ///< Others queue now.
    double credit = 1.0;              ///< People whom its rate lets out now.
    std::vector<std::uint32_t> line;  ///< Ids of those who wait in the order in which they came.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(served, queued, isQueued, credit, line);
    }
};

/// How far a source is.
struct SourceFlow {
    Random random;            ///< For times and positions.
    double next = -1.0;       ///< When the next one comes by its rate [s]; below 0 where it is not drawn yet.
    double rate = 0.0;        ///< For which that was drawn [1/s].
    std::int32_t sent = 0;    ///< How many have come by its rate.
    std::uint32_t entry = 0;  ///< Entries of its timetable that are over.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(random, next, rate, sent, entry);
    }
};

/// An area and what it has seen.
struct Area {
    AreaId id;          ///< Never used again.
    AreaDef def;        ///< Its `group` is not read.
    GroupId group;      ///< Of a source: whom its people join.
    AreaCount count;    ///< What it has seen.
    ExitFlow exit;      ///< Of an exit.
    SourceFlow source;  ///< Of a source.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, def, group, count, exit, source);
    }
};

/// True while a source may still send people, now or once it is open.
inline bool maySend(const Area& area) {
    const AreaDef& def = area.def;
    const bool byRate = def.rate > 0.0 && (def.most == 0 || area.source.sent < def.most) &&
                        !(area.source.rate == def.rate && area.source.next > def.until);
    return area.count.waiting > 0 || byRate || area.source.entry < def.timetable.size();
}

/// True where people leave by an exit at this time. A source has its own times.
inline bool isOpen(const AreaDef& area, double time) {
    return area.open && (area.kind != AreaKind::Exit || (time >= area.from && time < area.until));
}

}  // namespace muster
