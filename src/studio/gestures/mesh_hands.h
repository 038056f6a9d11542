// Fingers on formations: dragging, spreading, pulling apart (SPEC U1 to U5, B2).
#pragma once

#include <cstdint>
#include <vector>

#include "studio/gestures/control_scheme.h"

namespace muster {

/// Which gestures fingers on formations make.
struct MeshHandsDef {
    std::uint32_t client = 0;  ///< Whose touches these are.
    bool oneFinger = false;    ///< Only the first finger counts.
    bool shapes = true;        ///< Two fingers together make a line, three an area; a line sets the width.
    bool splits = true;        ///< Two fingers of their own pull a formation apart.
};

/// Turns fingers that came down on formations into touches, and what pairs of them do into changes of
/// formation.
class MeshHands {
public:
    explicit MeshHands(const MeshHandsDef& def) : def_(def) {}

    /// A finger comes down on a formation. False where it is ignored.
    bool down(std::uint32_t pointer, GroupId group, Vec2 ground, double time, const World& world,
              std::vector<CommandBody>& commands);
    /// It moves.
    void move(std::uint32_t pointer, Vec2 ground, double time, const World& world,
              std::vector<CommandBody>& commands);
    /// It lifts; what it drew is still followed, unless `cancelled`.
    void up(std::uint32_t pointer, double time, bool cancelled, std::vector<CommandBody>& commands);
    /// Call before every step: learns to which part a finger belongs after its formation was divided, and
    /// takes a formation that was widened by its new ends.
    void beforeStep(const World& world, std::vector<CommandBody>& commands);
    /// True while a finger is down.
    bool any() const { return !fingers_.empty(); }
    /// True for a finger that is on a formation.
    bool has(std::uint32_t pointer) const;
    /// Number of fingers on one formation.
    std::size_t count(GroupId group) const;

private:
    struct Finger {
        std::uint32_t pointer = 0;
        std::uint32_t touch = 0;
        GroupId group;
        Vec2 from;            // Where it came down [m].
        Vec2 at;              // Where it is [m].
        double time = 0.0;    // When it came down [s].
        bool paired = false;  // It came down together with another one on its formation.
        bool held = true;     // Its touch is down in the world.
    };
    void endOldWays(GroupId group, const World& world, std::vector<CommandBody>& commands) const;
    void spread(const Finger& moved, const World& world, std::vector<CommandBody>& commands);
    void takeAgain(const World& world, std::vector<CommandBody>& commands);
    void tear(const Finger& moved, const World& world, std::vector<CommandBody>& commands);
    Finger* find(std::uint32_t pointer);

    MeshHandsDef def_;
    std::vector<Finger> fingers_;  // In the order in which they came down.
    std::uint32_t lastTouch_ = 0;
    std::uint32_t tornStep_ = 0;     // The step before which a formation was last torn, and 1.
    std::uint32_t widenedStep_ = 0;  // The same for one that was widened.
    double widenedTime_ = -1e9;      // When that was [s].
};

}  // namespace muster
