#include "people/generator/other_clips.h"

#include "base/maths.h"
#include "people/generator/clip_maker.h"

namespace muster::generator {
namespace {

constexpr double kEver = 1000.0;  // Time before and after the clip at which a step of a foot that stays
                                  // begins and ends [s].

double idleWave(double cycles, double late) {
    return cosine(2.0 * kPi * (cycles - late));
}

}  // namespace

ChannelValues idleBody(double time, double start) {
    const double phase = (time - start) / kIdleCycle;
    const double breath = idleWave(phase, 0.3), shift = idleWave(phase, 0.0),
                 drift = idleWave(2.0 * phase, 0.15);
    ChannelValues body;
    body[Channel::HipsX] = 0.004 * drift;
    body[Channel::HipsY] = 0.022 * shift;
    body[Channel::HipsZ] = 0.945 - 0.002 * shift * shift;
    body[Channel::PelvisPitch] = degrees(3);
    body[Channel::PelvisRoll] = degrees(2.2) * shift;
    body[Channel::PelvisYaw] = degrees(1.5) * shift;
    body[Channel::ChestPitch] = degrees(1) - degrees(1.3) * breath;
    body[Channel::ChestRoll] = -degrees(1.2) * shift;
    body[Channel::ChestYaw] = -degrees(1.5) * shift;
    body[Channel::HeadPitch] = degrees(2) + degrees(0.8) * drift;
    body[Channel::HeadYaw] = degrees(4) * idleWave(phase, 0.2);
    for (std::size_t side = 0; side < 2; ++side) {
        const double sign = side == 0 ? 1.0 : -1.0;
        body.arm(side, Channel::LeftArmForward) = degrees(2) + degrees(1.5) * sign * idleWave(phase, 0.1);
        body.arm(side, Channel::LeftArmOut) = degrees(9) + degrees(0.8) * breath;
        body.arm(side, Channel::LeftArmTurn) = degrees(20);
        body.arm(side, Channel::LeftElbow) = degrees(20) + degrees(2) * sign * drift;
        body.arm(side, Channel::LeftWrist) = degrees(8);
    }
    return body;
}

Step idleStep(std::size_t side, const Placement& place) {
    const float sign = side == 0 ? 1.0f : -1.0f;
    Step step;
    step.begin = -kEver;
    step.end = kEver;
    step.anchor = toGround(place, {0.02f * sign - 0.02f, 0.10f * sign, static_cast<float>(kAnkleHeight)});
    step.yaw = place.yaw + degrees(9) * sign;
    return step;
}

Clip idleClip() {
    const Course course{[](double) { return Placement{}; }, [](double time) { return idleBody(time); }};
    const LegTrack left(0, {idleStep(0, {})}, course), right(1, {idleStep(1, {})}, course);
    ClipDef plan;
    plan.name = "idle";
    plan.motion = "run";
    plan.cyclic = true;
    plan.frames = static_cast<int>(kIdleCycle * kFrameRate);
    plan.figure = [&](double time) { return Figure{idleBody(time), {left.at(time), right.at(time)}, {}}; };
    plan.travel = course.travel;
    for (std::size_t side = 0; side < 2; ++side)
        plan.contacts.push_back(
            {side == 0 ? Limb::LeftFoot : Limb::RightFoot, 0.0, kIdleCycle, idleStep(side, {}).anchor});
    return makeClip(std::move(plan));
}

}  // namespace muster::generator
