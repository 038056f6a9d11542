// A player that is played by dice: every sort of command, as a person might give them within ten minutes.
#pragma once

#include <muster/world.h>

#include <vector>

#include "lockstep_random.h"

namespace lockstep {

/// Looks at the world as it is for its player and gives commands for its own groups.
class Script {
public:
    /// It keeps about so many people.
    Script(std::uint32_t player, std::int32_t people, std::uint64_t seed)
        : player_(player), people_(static_cast<std::size_t>(people)), random_(seed * 2 + player) {}

    /// The commands of one step.
    std::vector<muster::CommandBody> commands(const muster::World& world);

private:
    using Commands = std::vector<muster::CommandBody>;

    void act(const muster::World& world, Commands& commands);
    void order(const muster::World& world, const muster::GroupView& group, Commands& commands);
    void divide(const muster::World& world, const muster::GroupView& group, Commands& commands);
    void people(const muster::World& world, const muster::GroupView& group, Commands& commands);
    void shape(const muster::GroupView& group, Commands& commands);
    void barricade(const muster::World& world, Commands& commands);
    void beginDrag(const muster::World& world, const muster::GroupView& group, Commands& commands);
    void drag(const muster::World& world, Commands& commands);
    muster::Vec2 spot();

    std::uint32_t player_;
    std::size_t people_;
    Random random_;
    std::uint32_t rest_ = 30;  // Steps until it acts again.
    std::uint32_t touch_ = 0;  // Number of the finger that is down, and of the last one.
    std::uint32_t dragSteps_ = 0;
    muster::Vec2 finger_, fingerVelocity_;
};

}  // namespace lockstep
