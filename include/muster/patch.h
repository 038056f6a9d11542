// Patches: ground with a motion clip of its own (SPEC C1), and the facts of clips that simulation needs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/geometry.h"
#include "muster/obstacle.h"

namespace muster {

/// Index of a motion clip in the world's table of clips; 0 is running in the open.
using MotionId = std::int32_t;

/// Facts of a motion clip that simulation needs (the paper's table 1).
struct ClipFacts {
    std::string name;             ///< Name of the motion: "run", "crawl", "climb"...
    std::string file;             ///< File of the clip; empty for one of Muster's own.
    double speed = 1.0;           ///< Travel speed relative to running, above 0 (running is 1).
    double length = 0.0;          ///< Ground covered by one play [m]; 0 where unknown.
    double duration = 0.0;        ///< Duration of one play [s], 0 or more.
    bool cyclic = true;           ///< False for single-step motions (jump, climb).
    double transitionTime = 0.0;  ///< Duration of the transition on entering and on leaving [s]; 0 for none.
    double reachAhead = 0.0;  ///< From the character's position to the head of a body that leans or lies [m].
    double reachBehind = 0.0;  ///< From there back to its hips [m]; both are 0 for upright bodies.

    /// Lets an archive read or write the facts.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, file, speed, length, duration, cyclic, transitionTime, reachAhead, reachBehind);
    }
    /// Equal in all parts.
    friend bool operator==(const ClipFacts&, const ClipFacts&) = default;
};

/// The clips that every world knows: run, walk, duck, crawl, swim, jump, climb, idle, in this order.
std::vector<ClipFacts> defaultClipFacts();

/// Definition of a patch.
struct PatchDef {
    std::string name;     ///< Name for display: "Net", "Pool"...
    Polygon polygon;      ///< Corners of a simple polygon, convex or not [m].
    TimedPath path;       ///< Its motion; empty for a patch that stands still.
    MotionId motion = 0;  ///< Clip played on it; an index into the world's clips.
    double speed = -1.0;  ///< Travel speed relative to running, above 0; negative for the clip's.
    /// For stairs and ramps: heading of the way up [rad]. There `speed` is that of going up.
    std::optional<double> ascent;
    double speedDown = -1.0;  ///< For stairs and ramps: that of going down; negative for `speed`.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, polygon, path, motion, speed);
        archive.since(7, ascent, speedDown);
    }
    /// Equal in all parts.
    friend bool operator==(const PatchDef&, const PatchDef&) = default;
};

}  // namespace muster
