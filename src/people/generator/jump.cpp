#include "people/generator/other_clips.h"

#include <algorithm>

#include "people/generator/transitions.h"

namespace muster::generator {
namespace {

constexpr int kJumpFrames = 61;
constexpr double kJumpEnd = kJumpFrames / kFrameRate;  // Duration of the clip [s].
constexpr double kSpeed = 2.08;                        // Mean speed [m/s].
constexpr double kJumpMoment = 1e-3;                   // Time step of finite differences [s].

/// Parameters of a jump. Times [s], heights of the hips [m].
struct JumpShape {
    const char* name;
    /// Times at which the left foot lands and leaves, and at which the right foot lands [s].
    double plant, off, land;
    double offHeight, landHeight;
    Swing lead, trail;  ///< Swings of the leading right leg and the trailing left leg.
    ClipObstacle obstacle;
};

/// Height of the hips: free fall between `off` and `land`, the height of running before and after.
class Arc {
public:
    Arc(const JumpShape& shape, const GaitTrack& before, const GaitTrack& after)
        : shape_(shape), before_(before), after_(after) {
        const double fall = shape.land - shape.off;
        up_ = (shape.landHeight - shape.offHeight) / fall + 0.5 * kGravity * fall;
        const auto z = [](const GaitTrack& track, double t) { return track.body(t)[Channel::HipsZ]; };
        const auto rate = [&](const GaitTrack& track, double t) {
            return (z(track, t + kJumpMoment) - z(track, t - kJumpMoment)) / (2.0 * kJumpMoment);
        };
        spring_[0] = {shape.plant, z(before, shape.plant), rate(before, shape.plant - kJumpMoment),
                      -kGravity};
        spring_[1] = {shape.off, shape.offHeight, up_, -kGravity};
        leave_ = after.landing(1, 0) + after.gait().contact * after.gait().cycle;
        absorb_[0] = {shape.land, shape.landHeight, up_ - kGravity * fall, -kGravity};
        absorb_[1] = {leave_, z(after, leave_), rate(after, leave_ + kJumpMoment), -kGravity};
    }

    double at(double time) const {
        if (time < shape_.plant) return before_.body(time)[Channel::HipsZ];
        if (time < shape_.off) return between(spring_[0], spring_[1], time);
        if (time >= leave_) return after_.body(time)[Channel::HipsZ];
        if (time > shape_.land) return between(absorb_[0], absorb_[1], time);
        const double t = time - shape_.off;
        return shape_.offHeight + up_ * t - 0.5 * kGravity * t * t;
    }

private:
    JumpShape shape_;
    GaitTrack before_, after_;
    double up_ = 0.0, leave_ = 0.0;
    State spring_[2], absorb_[2];
};

ChannelValues heldInJump(const JumpShape& shape, ChannelValues body, double time) {
    const double air = hump(shape.off - 0.14, shape.land + 0.14, time),
                 crouch = hump(shape.land - 0.05, kJumpEnd, time);
    const double spring = hump(std::max(0.0, shape.plant - 0.05), shape.off + 0.05, time);
    body[Channel::ChestPitch] += degrees(11) * air + degrees(12) * crouch - degrees(6) * spring;
    body[Channel::PelvisPitch] += degrees(2) * air + degrees(6) * crouch - degrees(4) * spring;
    body[Channel::HeadPitch] += degrees(6) * air;
    for (std::size_t side = 0; side < 2; ++side) {
        // Both arms swing up and forwards and come down on landing. The arm opposite to the leading leg rises
        // highest.
        const double most = side == 0 ? 60.0 : 12.0;
        body.arm(side, Channel::LeftArmForward) += degrees(most) * air;
        body.arm(side, Channel::LeftArmOut) += degrees(side == 0 ? 14 : 30) * air + degrees(14) * crouch;
        body.arm(side, Channel::LeftElbow) -= degrees(side == 0 ? 30 : 45) * air + degrees(20) * crouch;
    }
    return body;
}

Transition jumpOf(const JumpShape& shape) {
    const Gait jog = gaitOf(GaitKind::Jog);
    const GaitTrack before(jog, shape.plant), after(jog, shape.land - 0.5 * jog.cycle);
    Transition transition;
    transition.name = shape.name;
    transition.motion = "jump";
    transition.frames = kJumpFrames;
    const double extra = 0.5 * (kSpeed - jog.speed) * kJumpEnd;
    transition.course.travel = straight([=](double time) {
        return jog.speed * time + extra * (rise(0.0, shape.off, time) + rise(shape.land, kJumpEnd, time));
    });
    const Arc arc(shape, before, after);
    transition.course.body = [=](double time) {
        ChannelValues body = blend(before.body(time), after.body(time),
                                   rise(shape.off - 0.05, shape.land, time));
        if (time > 0.0 && time < kJumpEnd) body[Channel::HipsZ] = arc.at(time);
        return time > 0.0 && time < kJumpEnd ? heldInJump(shape, body, time) : body;
    };
    Step plant = before.step(0, 0, before.course());
    plant.end = shape.off;
    plant.push = degrees(66);
    plant.swing = shape.trail;
    Step last = before.step(1, -1, before.course());
    last.swing = shape.lead;
    Step landing = after.step(1, 0, transition.course);
    landing.begin = shape.land;
    transition.steps[0] = {before.step(0, -1, before.course()), plant, after.step(0, 1, transition.course)};
    transition.steps[1] = {last, landing, after.step(1, 1, transition.course)};
    for (Step* step : {&transition.steps[0][0], &transition.steps[0][1], &transition.steps[1][0]})
        step->anchor.x += static_cast<float>(jog.speed * shape.plant);
    for (std::size_t side = 0; side < 2; ++side) {
        transition.before[side] = before.leg(side).join(0.0);
        transition.after[side] = after.leg(side).join(kJumpEnd);
    }
    transition.exitPhase = 1.0 - shape.plant / jog.cycle;
    transition.entryPhase = (kJumpEnd - after.landing(0, 0)) / jog.cycle;
    transition.obstacle = shape.obstacle;
    return transition;
}

}  // namespace

void addJumps(std::vector<Clip>& clips) {
    JumpShape tucked{"jump", 0.08, 0.30, 0.72, 0.945, 0.89, {}, {}, {}};
    tucked.lead = {{swingKey(0.3, 50), swingKey(0.62, 84), swingKey(0.74, 78), swingKey(0.88, 42)},
                   {swingKey(0.3, 92), swingKey(0.62, 112), swingKey(0.74, 98), swingKey(0.88, 46)},
                   {swingKey(0.5, 8), swingKey(0.9, 6)}};
    tucked.trail = {
        {swingKey(0.06, -12), swingKey(0.24, 50), swingKey(0.36, 60), swingKey(0.60, 38), swingKey(0.82, 34)},
        {swingKey(0.22, 116), swingKey(0.36, 118), swingKey(0.60, 98), swingKey(0.82, 60)},
        {swingKey(0.25, 0), swingKey(0.8, 0)}};
    clips.push_back(transitionClip(jumpOf(tucked)));
    JumpShape over{"jump-over", 0.03, 0.25, 0.67, 0.945, 0.89, {}, {}, {0.5f, 0.2f}};
    over.lead = {
        {swingKey(0.28, 46), swingKey(0.48, 80), swingKey(0.63, 95), swingKey(0.76, 76), swingKey(0.87, 42)},
        {swingKey(0.28, 106), swingKey(0.52, 128), swingKey(0.68, 78), swingKey(0.85, 28)},
        {swingKey(0.5, 12), swingKey(0.9, 6)}};
    over.trail = {
        {swingKey(0.06, -18), swingKey(0.22, 34), swingKey(0.38, 65), swingKey(0.60, 46), swingKey(0.82, 36)},
        {swingKey(0.20, 116), swingKey(0.36, 122), swingKey(0.60, 100), swingKey(0.82, 60)},
        {swingKey(0.25, 4), swingKey(0.8, 0)}};
    clips.push_back(transitionClip(jumpOf(over)));
}

}  // namespace muster::generator
