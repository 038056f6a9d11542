#include "people/generator/key_poses.h"
#include "people/generator/other_clips.h"
#include "people/generator/transitions.h"

namespace muster::generator {
namespace {

constexpr int kSwimFrames = 48;
constexpr double kSwimEnd = kSwimFrames / kFrameRate;  // Duration of the clip [s].

/// A shallow dive from the rim into the water; the left foot pushes off.
namespace in {

constexpr double kOff = 0.27;    // Time at which the left foot leaves the rim [s].
constexpr double kPhase = 0.10;  // Phase of swimming at the end of the clip.

Figure swimming(double time) {
    return swimFigure(time, kSwimEnd - kPhase * kSwimCycle);
}

/// Stretches both arms forwards, straight and close together, for the dive.
void stretchArms(ChannelValues& body, double share) {
    for (std::size_t side = 0; side < 2; ++side) {
        const auto towards = [&](Channel channel, double angle) {
            double& value = body.arm(side, channel);
            value += (degrees(angle) - value) * share;
        };
        towards(Channel::LeftArmForward, 165);
        towards(Channel::LeftElbow, 12);
        towards(Channel::LeftArmOut, 6);
    }
}

Course courseOf(const GaitTrack& jog) {
    const double low = swimming(kSwimEnd).body[Channel::HipsZ];
    const Curve height = Curve::spline({{0.0, jog.body(0.0)[Channel::HipsZ]},
                                        {0.11, 0.83},
                                        {kOff, 0.90},
                                        {0.36, 0.905},
                                        {0.55, 0.50},
                                        {0.72, -0.16},
                                        {kSwimEnd, low}},
                                       -0.6, 0.0);
    Course course;
    course.travel = straight(changingSpeed(jog.gait().speed, kSwimSpeed, kOff, kSwimEnd));
    course.body = [=](double time) {
        ChannelValues body = blend(jog.body(time), swimming(time).body, rise(0.06, 0.62, time));
        const double dive = hump(0.3, kSwimEnd, time);
        body[Channel::HipsZ] = height.at(time);
        body[Channel::PelvisPitch] += degrees(10) * dive;
        body[Channel::ChestPitch] += degrees(14) * dive;
        body[Channel::HeadPitch] += degrees(14) * dive;
        stretchArms(body, hump(0.0, 0.95, time));
        return body;
    };
    return course;
}

Clip clip() {
    const GaitTrack jog(gaitOf(GaitKind::Jog));
    const Course course = courseOf(jog);
    Step push = jog.step(0, 0, jog.course()), before = jog.step(1, -1, jog.course());
    push.end = kOff;
    push.push = degrees(70);
    push.rise = 0.18;
    push.swing = {};
    before.swing = {};
    const Step last = stepOutside(push, kSwimEnd + 0.5);
    const LegTrack left(0, {jog.step(0, -1, jog.course()), push, last}, course, {},
                        joinOf(swimming, 0, kSwimEnd));
    const LegTrack right(1, {before, last}, course, jog.leg(1).join(0.0), joinOf(swimming, 1, kSwimEnd));
    ClipDef plan;
    plan.name = "swim-enter";
    plan.motion = "swim";
    plan.frames = kSwimFrames;
    plan.travel = course.travel;
    plan.figure = [&](double time) {
        Figure figure = swimming(time);
        figure.body = course.body(time);
        if (time < kSwimEnd) figure.legs = {left.inAir(time), right.inAir(time)};
        for (Reach& reach : figure.reach) reach.weight = rise(0.38, kSwimEnd, time);
        return figure;
    };
    addContacts(plan.contacts, 0, {push}, kSwimEnd, false);
    plan.entryPhase = kPhase;
    return makeClip(std::move(plan));
}

}  // namespace in

/// Out of the water: the hands press on the rim, then the left foot steps out.
namespace out {

constexpr double kPhase = 0.95;    // Phase of swimming at the beginning of the clip.
constexpr double kEntry = 0.30;    // Phase of jogging at the end of the clip.
constexpr double kGrip = 0.20;     // Time at which both hands lie on the rim [s].
constexpr double kRelease = 0.32;  // Time at which both hands leave the rim [s].
constexpr double kStep = 0.44;     // Time at which the left foot stands on the ground [s].

Figure swimming(double time) {
    return swimFigure(time, -kPhase * kSwimCycle);
}

/// Keys of the body that rises out of the water, from swimming to jogging.
BodyKeys riseOf(const ChannelValues& wet, const ChannelValues& dry) {
    using enum Channel;
    const auto angle = [](const ChannelValues& body, Channel channel) {
        return body[channel] / degrees(1.0);
    };
    return BodyKeys({
        {HipsZ,
         {{0.0, wet[HipsZ]},
          {0.10, -0.19},
          {0.24, 0.09},
          {0.38, 0.38},
          {0.52, 0.66},
          {kSwimEnd, dry[HipsZ]}}},
        {PelvisPitch,
         {{0.0, angle(wet, PelvisPitch)},
          {0.18, 66},
          {0.34, 62},
          {0.50, 44},
          {kSwimEnd, angle(dry, PelvisPitch)}}},
        {ChestPitch,
         {{0.0, angle(wet, ChestPitch)},
          {0.16, 52},
          {0.34, 72},
          {0.50, 58},
          {kSwimEnd, angle(dry, ChestPitch)}}},
        {HeadPitch, {{0.0, angle(wet, HeadPitch)}, {0.2, 18}, {0.45, 22}, {kSwimEnd, angle(dry, HeadPitch)}}},
    });
}

Course courseOf(const GaitTrack& jog) {
    Course course;
    course.travel = straight(changingSpeed(kSwimSpeed, jog.gait().speed, 0.1, kSwimEnd));
    const BodyKeys keys = riseOf(swimming(0.0).body, jog.body(kSwimEnd));
    course.body = [=](double time) {
        return keys.at(time, blend(swimming(time).body, jog.body(time), rise(0.0, kSwimEnd, time)));
    };
    return course;
}

/// The target of an arm from the swimming stroke to the rim, and off the rim.
Reach reachOf(const Course& course, std::size_t side, double time) {
    const std::vector<HandContact> hold{
        {kGrip, kRelease, {0.64f, side == 0 ? 0.20f : -0.20f, 0.045f}, kGrip, 0.42}};
    Figure stroke = swimming(time), rim;
    rim.reach[side] = fromGround(course.travel(time), reachAt(hold, side, time));
    if (time >= kGrip) return rim.reach[side];
    rim.reach[side].weight = 1.0;
    return blend(stroke, rim, rise(0.0, kGrip, time)).reach[side];
}

Clip clip() {
    const Gait gait = gaitOf(GaitKind::Jog);
    const GaitTrack jog(gait, kSwimEnd - kEntry * gait.cycle);
    const Course course = courseOf(jog);
    Step foot = jog.step(0, 0, course);
    foot.begin = kStep;
    foot.strike = 0.0;
    const Step first = stepOutside(jog.step(1, -2, course), -1.0);
    const LegTrack left(0, {first, foot}, course, joinOf(swimming, 0, 0.0));
    const LegTrack right(1, {first, jog.step(1, 0, course)}, course, joinOf(swimming, 1, 0.0),
                         jog.leg(1).join(kSwimEnd));
    ClipDef plan;
    plan.name = "swim-exit";
    plan.motion = "swim";
    plan.frames = kSwimFrames;
    plan.travel = course.travel;
    plan.figure = [&](double time) {
        return Figure{course.body(time),
                      {left.inAir(time), right.inAir(time)},
                      {reachOf(course, 0, time), reachOf(course, 1, time)}};
    };
    addContacts(plan.contacts, 0, {foot}, kSwimEnd, false);
    for (std::size_t side = 0; side < 2; ++side)
        addContacts(plan.contacts, side,
                    {HandContact{kGrip, kRelease, {0.64f, side == 0 ? 0.20f : -0.20f, 0.045f}}});
    plan.entryPhase = kEntry;
    plan.exitPhase = kPhase;
    return makeClip(std::move(plan));
}

}  // namespace out
}  // namespace

void addSwimTransitions(std::vector<Clip>& clips) {
    clips.push_back(in::clip());
    clips.push_back(out::clip());
}

}  // namespace muster::generator
