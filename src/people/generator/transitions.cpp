#include "people/generator/transitions.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "people/generator/other_clips.h"

namespace muster::generator {
namespace {

constexpr double kStandingSince = -1000.0;  // Time from which a foot stands that never lands [s].
constexpr double kStandingUntil = 1000.0;   // Time until which a foot stands that never leaves [s].

double shareOfCycle(const GaitTrack& track, double time) {
    const double phase = (time - track.landing(0, 0)) / track.gait().cycle;
    return phase - std::floor(phase);
}

/// A standing foot that leaves over its ball, with the heel raised by `push` [rad].
Step leaving(std::size_t side, double end, double push) {
    Step step = idleStep(side, {});
    step.begin = kStandingSince;
    step.end = end;
    step.rise = std::min(0.28, 0.8 * end);
    step.push = push;
    step.swing = {{}, {{0.45, degrees(52)}}, {{0.4, degrees(-4)}}};
    return step;
}

/// A foot that lands at `begin` [s] and stays, with the character at `place`.
Step arriving(std::size_t side, double begin, const Placement& place, double strike) {
    Step step = idleStep(side, place);
    step.begin = begin;
    step.end = kStandingUntil;
    step.strike = strike;
    step.flat = 0.12;
    return step;
}

/// From standing to a gait. The left foot lands first, at `landing`; the right foot leaves at `leave` [s].
Transition startOf(const char* name, const Gait& gait, int frames, double landing, double leave,
                   double fullSpeed) {
    const GaitTrack track(gait, landing);
    const double end = frames / kFrameRate;
    Transition transition;
    transition.name = name;
    transition.frames = frames;
    transition.course.travel = straight(changingSpeed(0.0, gait.speed, 0.08, fullSpeed));
    transition.course.body = [=](double time) {
        ChannelValues body = blend(idleBody(time), track.body(time), rise(0.05, landing + 0.25, time));
        const double lean = hump(0.0, fullSpeed, time) * gait.speed;
        body[Channel::ChestPitch] += degrees(4) * lean;
        body[Channel::PelvisPitch] += degrees(2) * lean;
        body[Channel::HipsX] += 0.015 * lean;
        body[Channel::HipsY] -= 0.035 * hump(0.0, landing + 0.05, time);
        body[Channel::HipsZ] -= 0.012 * lean;
        return body;
    };
    transition.steps[0] = {leaving(0, 0.4 * landing, degrees(28)), track.step(0, 0, transition.course),
                           track.step(0, 1, transition.course)};
    transition.steps[1] = {leaving(1, leave, degrees(55)), track.step(1, 0, transition.course),
                           track.step(1, 1, transition.course)};
    for (std::size_t side = 0; side < 2; ++side) transition.after[side] = track.leg(side).join(end);
    transition.entryPhase = shareOfCycle(track, end);
    return transition;
}

/// From a gait to standing. The right foot lands at half a cycle and stays; the left foot lands next to it at
/// `landing` [s].
Transition stopOf(const char* name, const Gait& gait, int frames, double leave, double landing,
                  double still) {
    const GaitTrack track(gait);
    Transition transition;
    transition.name = name;
    transition.frames = frames;
    transition.course.travel = straight(changingSpeed(gait.speed, 0.0, 0.0, still));
    const double end = frames / kFrameRate;
    transition.course.body = [=](double time) {
        ChannelValues body = blend(track.body(time), idleBody(time, end), rise(0.1, 0.85 * end, time));
        const double brake = hump(0.0, still, time) * gait.speed;
        body[Channel::ChestPitch] -= degrees(3) * brake;
        body[Channel::PelvisPitch] -= degrees(2) * brake;
        body[Channel::HipsX] -= 0.03 * brake;
        body[Channel::HipsZ] -= 0.035 * hump(0.05 * end, 0.85 * end, time) * gait.speed;
        return body;
    };
    const Placement last = transition.course.travel(end);
    Step first = track.step(0, 0, track.course());
    first.end = leave;
    first.swing = {{}, {{0.4, degrees(62)}}, {{0.4, degrees(-4)}}};
    transition.steps[0] = {track.step(0, -1, track.course()), first, arriving(0, landing, last, degrees(6))};
    transition.steps[1] = {track.step(1, -1, track.course()),
                           arriving(1, track.landing(1, 0), last, degrees(16))};
    for (std::size_t side = 0; side < 2; ++side) transition.before[side] = track.leg(side).join(0.0);
    return transition;
}

/// A quarter turn on the spot to the left (`sign` = 1) or right (-1); the foot of that side moves first.
Transition turnOf(const char* name, double sign) {
    constexpr int kFrames = 60;
    constexpr double kEnd = kFrames / kFrameRate;
    Transition transition;
    transition.name = name;
    transition.frames = kFrames;
    transition.course.travel = [sign](double time) {
        return Placement{0.0, 0.0, 0.5 * kPi * sign * rise(0.05, 0.95, time)};
    };
    transition.course.body = [sign](double time) {
        ChannelValues body = blend(idleBody(time), idleBody(time, kEnd), rise(0.0, kEnd, time));
        const double ahead = sign * hump(0.0, 0.75, time);
        body[Channel::HeadYaw] += degrees(24) * ahead;
        body[Channel::ChestYaw] += degrees(12) * ahead;
        body[Channel::HipsY] -= sign * 0.05 * (hump(0.0, 0.5, time) - hump(0.45, 0.95, time));
        body[Channel::HipsZ] -= 0.02 * (hump(0.0, 0.5, time) + hump(0.45, 1.0, time));
        return body;
    };
    const Placement last{0.0, 0.0, 0.5 * kPi * sign};
    const std::size_t inner = sign > 0.0 ? 0 : 1, outer = 1 - inner;
    transition.steps[inner] = {leaving(inner, 0.16, degrees(18)), arriving(inner, 0.48, last, 0.0)};
    transition.steps[outer] = {leaving(outer, 0.52, degrees(22)), arriving(outer, 0.88, last, 0.0)};
    return transition;
}

/// A change between two gaits within 0.4 s: the left foot stands and leaves, then the right foot lands.
struct Change {
    const char* name;
    Gait from, to;
    double phase;    ///< Phase of `from` at the beginning.
    double leave;    ///< Time at which the left foot leaves [s].
    double landing;  ///< Time at which the right foot lands [s].
};

Transition changeOf(const Change& change, int frames) {
    const double end = frames / kFrameRate;
    const GaitTrack from(change.from, -change.phase * change.from.cycle);
    const GaitTrack to(change.to, change.landing - 0.5 * change.to.cycle);
    Transition transition;
    transition.name = change.name;
    transition.motion = "duck";
    transition.frames = frames;
    transition.course.travel = straight(changingSpeed(change.from.speed, change.to.speed, 0.0, end));
    transition.course.body = [=](double time) {
        return blend(from.body(time), to.body(time), rise(0.0, end, time));
    };
    const Placement origin = from.travel(0.0);
    Course before = from.course();
    before.travel = [from, origin](double time) {
        return Placement{from.travel(time).x - origin.x, 0.0, 0.0};
    };
    Step left = from.step(0, 0, before);
    left.end = change.leave;
    left.push = degrees(34);
    left.swing.thigh.clear();
    left.swing.knee.clear();
    left.swing.ankle.clear();
    transition.steps[0] = {left, to.step(0, 1, transition.course)};
    transition.steps[1] = {from.step(1, -1, before), to.step(1, 0, transition.course)};
    for (std::size_t side = 0; side < 2; ++side) {
        transition.before[side] = from.leg(side).join(0.0);
        transition.after[side] = to.leg(side).join(end);
    }
    transition.exitPhase = change.phase;
    transition.entryPhase = shareOfCycle(to, end);
    return transition;
}

}  // namespace

void addTransitions(std::vector<Clip>& clips) {
    clips.push_back(transitionClip(startOf("start", gaitOf(GaitKind::Jog), 66, 0.50, 0.60, 0.95)));
    clips.push_back(transitionClip(startOf("start-walk", gaitOf(GaitKind::Walk), 72, 0.55, 0.657, 0.85)));
    clips.push_back(transitionClip(stopOf("stop", gaitOf(GaitKind::Jog), 72, 0.34, 0.78, 0.9)));
    clips.push_back(transitionClip(stopOf("stop-walk", gaitOf(GaitKind::Walk), 78, 0.66, 1.08, 1.2)));
    clips.push_back(transitionClip(turnOf("turn-left", 1.0)));
    clips.push_back(transitionClip(turnOf("turn-right", -1.0)));
    clips.push_back(transitionClip(
        changeOf({"duck-enter", gaitOf(GaitKind::Jog), gaitOf(GaitKind::Duck), 0.12, 0.25, 0.285}, 24)));
    clips.push_back(transitionClip(
        changeOf({"duck-exit", gaitOf(GaitKind::Duck), gaitOf(GaitKind::Jog), 0.358, 0.22, 0.20}, 24)));
}

}  // namespace muster::generator
