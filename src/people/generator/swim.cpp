#include "people/generator/other_clips.h"

#include <cmath>

#include "base/maths.h"

namespace muster::generator {
namespace {

/// Position of a wrist relative to its shoulder in one stroke: x forward, y outwards, z up [m].
struct StrokeKey {
    double phase;
    Vec3 wrist;
};
constexpr StrokeKey kStroke[] = {
    {0.00, {0.49f, 0.03f, -0.05f}}, {0.12, {0.515f, 0.00f, -0.10f}}, {0.26, {0.38f, 0.10f, -0.32f}},
    {0.40, {0.06f, 0.07f, -0.42f}}, {0.53, {-0.30f, 0.08f, -0.35f}}, {0.63, {-0.46f, 0.12f, -0.06f}},
    {0.74, {-0.22f, 0.32f, 0.14f}}, {0.86, {0.18f, 0.30f, 0.20f}},
};

Curve around(float Vec3::*part) {
    std::vector<Key> keys;
    for (int turn = -2; turn <= 2; ++turn) {
        for (const StrokeKey& key : kStroke) keys.push_back({turn + key.phase, key.wrist.*part});
    }
    return Curve::spline(std::move(keys), 0.0, 0.0);
}

/// Position of the wrist by phase since its hand entered the water [m].
Vec3 swimStroke(double phase) {
    static const Curve x = around(&Vec3::x), y = around(&Vec3::y), z = around(&Vec3::z);
    phase -= std::floor(phase);
    return {static_cast<float>(x.at(phase)), static_cast<float>(y.at(phase)),
            static_cast<float>(z.at(phase))};
}

/// Progress of an arm's recovery above the water, 0 to 1.
double recovery(double phase) {
    phase -= std::floor(phase);
    return hump(0.58, 1.02, phase) + hump(0.58, 1.02, phase + 1.0);
}

ChannelValues swimBody(double phase) {
    ChannelValues body;
    // The body rolls towards the arm that reaches forward. The head rotates with it to breathe on the right.
    const double roll = cycleWave(phase - 0.14), breath = recovery(phase + 0.5);
    body[Channel::HipsX] = -0.18;
    body[Channel::HipsY] = 0.015 * cycleWave(phase - 0.3);
    body[Channel::HipsZ] = -0.255 + 0.012 * cycleWave(2.0 * phase);
    body[Channel::PelvisPitch] = degrees(88);
    body[Channel::PelvisRoll] = -degrees(16) * roll;
    body[Channel::PelvisYaw] = degrees(2) * roll;
    body[Channel::ChestPitch] = degrees(81);
    body[Channel::ChestRoll] = -degrees(32) * roll;
    body[Channel::ChestYaw] = -degrees(3) * roll;
    body[Channel::HeadPitch] = degrees(58);
    body[Channel::HeadRoll] = -degrees(8) * roll - degrees(38) * breath;
    body[Channel::HeadYaw] = -degrees(14) * breath;
    return body;
}

Leg kickingLeg(const ChannelValues& body, std::size_t side, double phase) {
    const double beat = 3.0 * phase + (side == 0 ? 0.0 : 0.5);
    const double thigh = degrees(8) + degrees(9) * cycleWave(beat),
                 knee = degrees(15) - degrees(11) * cycleWave(beat - 0.18);
    const double shin = thigh - knee;
    Leg leg;
    const Vec3 hip = hipJoint(body, side);
    leg.ankle = hip + Vec3{static_cast<float>(-kThigh * cosine(thigh) - kShin * cosine(shin)), 0.0f,
                           static_cast<float>(-kThigh * sine(thigh) - kShin * sine(shin))};
    leg.foot = turned(degrees(180 - 22) - shin + degrees(8) * cycleWave(beat - 0.3), 0.0,
                      side == 0 ? -0.1 : 0.1);
    leg.knee = {-0.1f, 0.0f, -1.0f};
    return leg;
}

/// Position of one shoulder joint in the travelling frame [m].
Vec3 shoulderOf(const Figure& figure, std::size_t side) {
    JointTransforms joints;
    jointTransforms(poseOf(figure), {}, joints);
    return joints[index(side == 0 ? JointRole::LeftArm : JointRole::RightArm)].translation;
}

}  // namespace

Figure swimFigure(double time, double start) {
    const double phase = (time - start) / kSwimCycle;
    Figure figure;
    figure.body = swimBody(phase);
    for (std::size_t side = 0; side < 2; ++side) figure.legs[side] = kickingLeg(figure.body, side, phase);
    for (std::size_t side = 0; side < 2; ++side) {
        const double own = phase + (side == 0 ? 0.0 : 0.5), over = recovery(own);
        const float out = side == 0 ? 1.0f : -1.0f;
        Vec3 wrist = swimStroke(own);
        wrist.y *= out;
        Reach& reach = figure.reach[side];
        reach.wrist = shoulderOf(figure, side) + wrist;
        reach.weight = 1.0;
        reach.elbow = normalized(
            lerp(Vec3{0.1f, 0.8f * out, 0.5f}, Vec3{-0.1f, 0.5f * out, 1.0f}, static_cast<float>(over)));
        reach.follow = 1.0;
    }
    return figure;
}

Clip swimClip() {
    ClipDef plan;
    plan.name = "swim";
    plan.motion = "swim";
    plan.cyclic = true;
    plan.frames = static_cast<int>(kSwimCycle * kFrameRate + 0.5);
    plan.figure = [](double time) { return swimFigure(time); };
    plan.travel = [](double time) { return Placement{kSwimSpeed * time, 0.0, 0.0}; };
    return makeClip(std::move(plan));
}

}  // namespace muster::generator
