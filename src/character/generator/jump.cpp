#include "character/generator/jump.h"

#include <algorithm>

#include "character/generator/passages.h"

namespace muster::generator {
namespace {

constexpr int kFrames = 61;
constexpr double kEnd = kFrames / kFrameRate;  // [s]
constexpr double kSpeed = 2.08;                // [m/s] on average
constexpr double kGravity = 9.81;              // [m/s^2]
constexpr double kMoment = 1e-3;               // [s]

/// What tells one jump from another. Times [s], heights of the hips [m].
struct JumpShape {
    const char* name;
    double plant, off, land;  ///< The left foot lands, leaves; the right one lands.
    double offHeight, landHeight;
    Swing lead, trail;  ///< Of the right leg, of the left one.
    ClipObstacle obstacle;
};

/// Height of the hips: in free fall between `off` and `land`, that of running before and after.
class Arc {
public:
    Arc(const JumpShape& shape, const GaitTrack& before, const GaitTrack& after)
        : shape_(shape), before_(before), after_(after) {
        const double fall = shape.land - shape.off;
        up_ = (shape.landHeight - shape.offHeight) / fall + 0.5 * kGravity * fall;
        const auto z = [](const GaitTrack& track, double t) { return track.body(t)[Channel::HipsZ]; };
        const auto rate = [&](const GaitTrack& track, double t) {
            return (z(track, t + kMoment) - z(track, t - kMoment)) / (2.0 * kMoment);
        };
        spring_[0] = {shape.plant, z(before, shape.plant), rate(before, shape.plant - kMoment), -kGravity};
        spring_[1] = {shape.off, shape.offHeight, up_, -kGravity};
        leave_ = after.landing(1, 0) + after.gait().contact * after.gait().cycle;
        absorb_[0] = {shape.land, shape.landHeight, up_ - kGravity * fall, -kGravity};
        absorb_[1] = {leave_, z(after, leave_), rate(after, leave_ + kMoment), -kGravity};
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

Body heldInJump(const JumpShape& shape, Body body, double time) {
    const double air = hump(shape.off - 0.14, shape.land + 0.14, time),
                 crouch = hump(shape.land - 0.05, kEnd, time);
    const double spring = hump(std::max(0.0, shape.plant - 0.05), shape.off + 0.05, time);
    body[Channel::ChestPitch] += degrees(11) * air + degrees(12) * crouch - degrees(6) * spring;
    body[Channel::PelvisPitch] += degrees(2) * air + degrees(6) * crouch - degrees(4) * spring;
    body[Channel::HeadPitch] += degrees(6) * air;
    for (std::size_t side = 0; side < 2; ++side) {
        // Arms are thrown up and forwards, the one across from the leading leg highest, and come down on
        // landing.
        const double most = side == 0 ? 60.0 : 12.0;
        body.arm(side, Channel::LeftArmForward) += degrees(most) * air;
        body.arm(side, Channel::LeftArmOut) += degrees(side == 0 ? 14 : 30) * air + degrees(14) * crouch;
        body.arm(side, Channel::LeftElbow) -= degrees(side == 0 ? 30 : 45) * air + degrees(20) * crouch;
    }
    return body;
}

Passage jumpOf(const JumpShape& shape) {
    const Gait jog = jogGait();
    const GaitTrack before(jog, shape.plant), after(jog, shape.land - 0.5 * jog.cycle);
    Passage passage;
    passage.name = shape.name;
    passage.motion = "jump";
    passage.frames = kFrames;
    const double extra = 0.5 * (kSpeed - jog.speed) * kEnd;
    passage.course.travel = straight([=](double time) {
        return jog.speed * time + extra * (rise(0.0, shape.off, time) + rise(shape.land, kEnd, time));
    });
    const Arc arc(shape, before, after);
    passage.course.body = [=](double time) {
        Body body = blend(before.body(time), after.body(time), rise(shape.off - 0.05, shape.land, time));
        if (time > 0.0 && time < kEnd) body[Channel::HipsZ] = arc.at(time);
        return time > 0.0 && time < kEnd ? heldInJump(shape, body, time) : body;
    };
    Step plant = before.step(0, 0, before.course());
    plant.end = shape.off;
    plant.push = degrees(66);
    plant.swing = shape.trail;
    Step last = before.step(1, -1, before.course());
    last.swing = shape.lead;
    Step landing = after.step(1, 0, passage.course);
    landing.begin = shape.land;
    passage.steps[0] = {before.step(0, -1, before.course()), plant, after.step(0, 1, passage.course)};
    passage.steps[1] = {last, landing, after.step(1, 1, passage.course)};
    for (Step* step : {&passage.steps[0][0], &passage.steps[0][1], &passage.steps[1][0]})
        step->anchor.x += static_cast<float>(jog.speed * shape.plant);
    for (std::size_t side = 0; side < 2; ++side) {
        passage.before[side] = before.leg(side).join(0.0);
        passage.after[side] = after.leg(side).join(kEnd);
    }
    passage.exitPhase = 1.0 - shape.plant / jog.cycle;
    passage.entryPhase = (kEnd - after.landing(0, 0)) / jog.cycle;
    passage.obstacle = shape.obstacle;
    return passage;
}

Key key(double share, double angle) {
    return {share, degrees(angle)};
}

}  // namespace

void addJumps(std::vector<Clip>& clips) {
    JumpShape tucked{"jump", 0.08, 0.30, 0.72, 0.945, 0.89, {}, {}, {}};
    tucked.lead = {{key(0.3, 50), key(0.62, 84), key(0.74, 78), key(0.88, 42)},
                   {key(0.3, 92), key(0.62, 112), key(0.74, 98), key(0.88, 46)},
                   {key(0.5, 8), key(0.9, 6)}};
    tucked.trail = {{key(0.06, -12), key(0.24, 50), key(0.36, 60), key(0.60, 38), key(0.82, 34)},
                    {key(0.22, 116), key(0.36, 118), key(0.60, 98), key(0.82, 60)},
                    {key(0.25, 0), key(0.8, 0)}};
    clips.push_back(passageClip(jumpOf(tucked)));
    JumpShape over{"jump-over", 0.03, 0.25, 0.67, 0.945, 0.89, {}, {}, {0.5f, 0.2f}};
    over.lead = {{key(0.28, 46), key(0.48, 80), key(0.63, 95), key(0.76, 76), key(0.87, 42)},
                 {key(0.28, 106), key(0.52, 128), key(0.68, 78), key(0.85, 28)},
                 {key(0.5, 12), key(0.9, 6)}};
    over.trail = {{key(0.06, -18), key(0.22, 34), key(0.38, 65), key(0.60, 46), key(0.82, 36)},
                  {key(0.20, 116), key(0.36, 122), key(0.60, 100), key(0.82, 60)},
                  {key(0.25, 4), key(0.8, 0)}};
    clips.push_back(passageClip(jumpOf(over)));
}

}  // namespace muster::generator
