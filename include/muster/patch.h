// Patches: ground that asks for another motion (SPEC C1), and the facts of motion clips.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "muster/id.h"
#include "muster/timed_path.h"

namespace muster {

/// Number of a motion clip in the table of clip facts; 0 is running in the open.
using MotionId = std::int32_t;

/// What simulation needs to know of a motion clip (the paper's table 1).
struct ClipFacts {
    std::string name;             ///< "run", "crawl", "climb"...
    std::string file;             ///< The clip's file; may be empty.
    double speed = 1.0;           ///< Relative to running > 0 (running is 1).
    double length = 0.0;          ///< Ground covered by one play [m] >= 0; 0 where unknown.
    double duration = 0.0;        ///< Of one play [s] >= 0.
    bool cyclic = true;           ///< False for single-step motions (jump, climb).
    double transitionTime = 0.0;  ///< Played on entering and on leaving [s] >= 0; 0 for none.

    /// Lets an archive read or write the facts.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, file, speed, length, duration, cyclic, transitionTime);
    }
};

/// The clips every world knows: run, walk, duck, crawl, swim, jump, climb, idle, in this order.
std::vector<ClipFacts> defaultClipFacts();

/// Describes a patch.
struct PatchDef {
    std::string name;     ///< "Net", "Pool"...; shown on its tag.
    Polygon polygon;      ///< Simple, convex or not.
    TimedPath path;       ///< Moves it; empty for one that stands still.
    MotionId motion = 0;  ///< Clip played on it.
    double speed = -1.0;  ///< Travel speed > 0 relative to running; negative: the clip's.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, polygon, path, motion, speed);
    }
};

}  // namespace muster
