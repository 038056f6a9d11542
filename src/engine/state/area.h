// Exits, sources and waiting areas of a world, as its state holds them.
#pragma once

#include <cstdint>

#include "muster/area.h"

namespace muster {

/// An area and what it has seen.
struct Area {
    AreaId id;        ///< Never used again.
    AreaDef def;      ///< Its `group` is not read.
    GroupId group;    ///< Of a source: whom its people join.
    AreaCount count;  ///< What it has seen.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, def, group, count);
    }
};

}  // namespace muster
