#include "generator/keyed.h"
#include "generator/low_passages.h"
#include "generator/passages.h"
#include "generator/swim.h"

namespace muster::generator {
namespace {

constexpr int kFrames = 48;
constexpr double kEnd = kFrames / kFrameRate;  // [s]

/// Off the rim and flat into the water: the left foot pushes off.
Clip enterClip() {
    constexpr double kOff = 0.27, kPhase = 0.10;
    const GaitTrack jog(jogGait());
    const double start = kEnd - kPhase * kSwimCycle;
    const auto swimming = [start](double time) { return swimFigure(time, start); };
    const double low = swimming(kEnd).body[Channel::HipsZ];
    Course course;
    course.travel = straight(changingSpeed(jog.gait().speed, kSwimSpeed, kOff, kEnd));
    const Curve height = Curve::spline({{0.0, jog.body(0.0)[Channel::HipsZ]}, {0.11, 0.83}, {kOff, 0.90}, {0.36, 0.905}, {0.55, 0.50}, {0.72, -0.16}, {kEnd, low}}, -0.6, 0.0);
    course.body = [=](double time) {
        Body body = blend(jog.body(time), swimming(time).body, rise(0.06, 0.62, time));
        body[Channel::HipsZ] = height.at(time);
        body[Channel::PelvisPitch] += degrees(10) * hump(0.3, kEnd, time);
        body[Channel::ChestPitch] += degrees(14) * hump(0.3, kEnd, time);
        body[Channel::HeadPitch] += degrees(14) * hump(0.3, kEnd, time);
        const double arms = hump(0.0, 0.95, time);
        for (std::size_t side = 0; side < 2; ++side) {
            body.arm(side, Channel::LeftArmForward) += (degrees(165) - body.arm(side, Channel::LeftArmForward)) * arms;
            body.arm(side, Channel::LeftElbow) += (degrees(12) - body.arm(side, Channel::LeftElbow)) * arms;
            body.arm(side, Channel::LeftArmOut) += (degrees(6) - body.arm(side, Channel::LeftArmOut)) * arms;
        }
        return body;
    };
    Step push = jog.step(0, 0, jog.course()), never = push, before = jog.step(1, -1, jog.course());
    push.end = kOff;
    push.push = degrees(70);
    push.rise = 0.18;
    push.swing = {};
    before.swing = {};
    never.begin = kEnd + 0.5;
    never.end = kEnd + 1.0;
    const LegTrack legs[2] = {
        LegTrack(0, {jog.step(0, -1, jog.course()), push, never}, course, {}, joinOf(swimming, 0, kEnd)),
        LegTrack(1, {before, never}, course, jog.leg(1).join(0.0), joinOf(swimming, 1, kEnd))};
    ClipPlan plan;
    plan.name = "swim-enter";
    plan.motion = "swim";
    plan.frames = kFrames;
    plan.travel = course.travel;
    plan.figure = [&](double time) {
        const Figure swim = swimming(time);
        Figure figure{course.body(time), {legs[0].inAir(time), legs[1].inAir(time)}, swim.reach};
        for (Reach& reach : figure.reach) reach.weight = rise(0.55, kEnd, time);
        if (time >= kEnd) figure.legs = swim.legs;
        return figure;
    };
    addContacts(plan.contacts, 0, {push}, kEnd, false);
    plan.entryPhase = kPhase;
    plan.exitPhase = 0.0;
    return makeClip(std::move(plan));
}

/// Hands on the rim, up, the left foot steps out.
Clip exitClip() {
    constexpr double kPhase = 0.95, kStep = 0.44, kGrip = 0.20;
    const Gait gait = jogGait();
    const GaitTrack jog(gait, kEnd - 0.30 * gait.cycle);
    const double start = -kPhase * kSwimCycle;
    const auto swimming = [start](double time) { return swimFigure(time, start); };
    const auto way = changingSpeed(kSwimSpeed, gait.speed, 0.1, kEnd);
    Course course;
    course.travel = straight(way);
    using enum Channel;
    const Body wet = swimming(0.0).body, dry = jog.body(kEnd);
    const double deg = 1.0 / degrees(1.0);
    const BodyKeys keys({{HipsZ, {{0.0, wet[HipsZ]}, {0.10, -0.22}, {0.24, 0.06}, {0.38, 0.42}, {0.52, 0.68}, {kEnd, dry[HipsZ]}}},
                         {PelvisPitch, {{0.0, wet[PelvisPitch] * deg}, {0.18, 66}, {0.34, 62}, {0.50, 44}, {kEnd, dry[PelvisPitch] * deg}}},
                         {ChestPitch, {{0.0, wet[ChestPitch] * deg}, {0.16, 52}, {0.34, 72}, {0.50, 58}, {kEnd, dry[ChestPitch] * deg}}},
                         {HeadPitch, {{0.0, wet[HeadPitch] * deg}, {0.2, 18}, {0.45, 22}, {kEnd, dry[HeadPitch] * deg}}}});
    course.body = [=](double time) {
        const Body body = blend(swimming(time).body, jog.body(time), rise(0.0, kEnd, time));
        return keys.at(time, body);
    };
    Step never = jog.step(1, -2, course), foot = jog.step(0, 0, course), next = jog.step(1, 0, course);
    never.begin = -1.0;
    never.end = -0.5;
    never.swing = {};
    foot.begin = kStep;
    foot.strike = 0.0;
    const LegTrack legs[2] = {LegTrack(0, {never, foot}, course, joinOf(swimming, 0, 0.0)),
                              LegTrack(1, {never, next}, course, joinOf(swimming, 1, 0.0), jog.leg(1).join(kEnd))};
    std::vector<HandHold> holds[2];
    for (std::size_t side = 0; side < 2; ++side) {
        const float out = side == 0 ? 1.0f : -1.0f;
        holds[side] = {{kGrip, 0.35, {0.52f, 0.20f * out, 0.045f}, kGrip, 0.22}};
    }
    ClipPlan plan;
    plan.name = "swim-exit";
    plan.motion = "swim";
    plan.frames = kFrames;
    plan.travel = course.travel;
    plan.figure = [&](double time) {
        const Figure swim = swimming(time);
        Figure figure{course.body(time), {legs[0].inAir(time), legs[1].inAir(time)}, {}};
        for (std::size_t side = 0; side < 2; ++side) {
            const Reach rim = fromGround(course.travel(time), reachAt(holds[side], side, time)), stroke = swim.reach[side];
            const double grip = rise(0.0, kGrip, time);
            Figure a, b;
            a.reach[side] = stroke;
            b.reach[side] = rim;
            if (time < kGrip) b.reach[side].weight = 1.0;
            figure.reach[side] = blend(a, b, grip).reach[side];
        }
        return figure;
    };
    addContacts(plan.contacts, 0, {foot}, kEnd, false);
    for (std::size_t side = 0; side < 2; ++side) addContacts(plan.contacts, side, holds[side]);
    plan.entryPhase = 0.30;
    plan.exitPhase = kPhase;
    return makeClip(std::move(plan));
}

}  // namespace

void addSwimPassages(std::vector<Clip>& clips) {
    clips.push_back(enterClip());
    clips.push_back(exitClip());
}

}  // namespace muster::generator
