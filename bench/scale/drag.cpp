#include "scale/drag.h"

#include "base/maths.h"

namespace muster::scale {
namespace {

constexpr std::uint32_t kFirstStep = 6;  // Step of the touch down.
constexpr std::uint32_t kEvery = 3;      // Steps between touch moves.

}  // namespace

Status Drag::give(World& world, CommandBody body) {
    return world.submit({world.stepCount(), 1, sequence_++, std::move(body)});
}

Status Drag::before(World& world) {
    const std::uint32_t step = world.stepCount();
    if (step < kFirstStep || (step - kFirstStep) % kEvery != 0) return {};
    const double time = world.time();
    const CoursePose pose = poseAt(course_, time - kFirstStep * world.parameters().stepTime);
    const Vec2 flank = Rotation{cosine(pose.angle), sine(pose.angle)}.apply({0.0, 0.5 * side_});
    const GroupId group = world.group(0).id;
    for (std::uint32_t touch = 1; touch <= 2; ++touch) {
        const Vec2 finger = touch == 1 ? pose.position + flank : pose.position - flank;
        const bool down = step == kFirstStep;
        const Status status = down ? give(world, Touch{TouchPhase::Down, touch, finger, time, group})
                                   : give(world, Touch{TouchPhase::Move, touch, finger, time, {}});
        if (!status.ok()) return status.within("drag");
    }
    return {};
}

}  // namespace muster::scale
