// Counts encounters with single-step patches twice: from positions, and from the world's events.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/world.h"

namespace muster {

/// One encounter is one stay of a character in one patch; a character that comes back within `rearm`
/// continues the same stay. The patches watched must not overlap, and the number of characters must not
/// change.
class EncounterWatch {
public:
    /// Observes all patches of `motion`. A character that stands in one at the start has met it already.
    EncounterWatch(const World& world, MotionId motion, double rearm = 0.5);
    /// Call after every step.
    void observe(const World& world);

    /// Number of encounters by positions and polygons.
    std::int32_t encounters() const { return encounters_; }
    std::int32_t events() const { return events_; }  ///< Number of SingleStep events of that motion.
    /// Encounters without an event of the same character in the same step, and events without an encounter.
    std::int32_t mismatches() const { return mismatches_; }
    /// Encounters of each character.
    const std::vector<std::int32_t>& byCharacter() const { return byCharacter_; }

private:
    void look(const World& world, bool first);

    MotionId motion_;
    std::int64_t rearmSteps_;
    std::vector<PatchId> patches_;
    std::vector<std::int64_t> outside_;  // By patch and character: steps since the character was last inside.
    std::vector<std::uint8_t> begins_;   // By character: whether an encounter begins in this step.
    std::vector<std::int32_t> byCharacter_;
    std::int32_t encounters_ = 0;
    std::int32_t events_ = 0;
    std::int32_t mismatches_ = 0;
};

/// True where `p` is inside a simple polygon, by the number of edges that a ray to the right crosses.
bool rayCastInside(const Polygon& polygon, Vec2 p);

}  // namespace muster
