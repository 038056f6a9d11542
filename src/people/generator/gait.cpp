#include "people/generator/gait.h"

#include <cmath>

#include "base/maths.h"
#include "people/generator/clip_maker.h"

namespace muster::generator {
GaitTrack::GaitTrack(const Gait& gait, double start) : gait_(gait), start_(start) {}

Placement GaitTrack::travel(double time) const {
    const double distance = gait_.speed * (time - start_);
    if (gait_.bend == 0.0) return {distance, 0.0, 0.0};
    const double yaw = distance * gait_.bend;
    return {sine(yaw) / gait_.bend, (1.0 - cosine(yaw)) / gait_.bend, yaw};
}

double GaitTrack::height(double phase) const {
    const double middle = 0.5 * gait_.contact;
    if (!gait_.flies()) return gait_.height + 0.5 * gait_.bob * cycleWave(2.0 * (phase - middle));
    // Half a cycle is a contact, in which the hips fall and rise, followed by free flight.
    const double half = 2.0 * phase, since = (half - std::floor(half)) * 0.5 * gait_.cycle;
    const double contact = gait_.contact * gait_.cycle, flight = 0.5 * gait_.cycle - contact;
    const double up = 0.5 * kGravity * flight - gait_.lift / flight, high = gait_.height + gait_.lift,
                 t = since - contact;
    if (t > 0.0) return high + up * t - 0.5 * kGravity * t * t;
    return between({0.0, gait_.height, up - kGravity * flight, -kGravity}, {contact, high, up, -kGravity},
                   since);
}

void GaitTrack::addTrunk(double phase, ChannelValues& body) const {
    const double middle = 0.5 * gait_.contact;
    body[Channel::HipsX] = gait_.forward - gait_.surge * cycleWave(2.0 * (phase - middle) - 0.25);
    body[Channel::HipsY] = gait_.sway * cycleWave(phase - middle);
    body[Channel::HipsZ] = height(phase);
    body[Channel::PelvisPitch] = gait_.pelvisPitch;
    body[Channel::PelvisRoll] = gait_.pelvisRoll * cycleWave(phase - 0.75 * middle);
    body[Channel::PelvisYaw] = -gait_.pelvisYaw * cycleWave(phase + 0.02);
    body[Channel::ChestPitch] = gait_.lean + gait_.nod * cycleWave(2.0 * (phase - 0.8 * middle));
    body[Channel::ChestRoll] = -gait_.chestRoll * cycleWave(phase - middle);
    body[Channel::ChestYaw] = gait_.chestYaw * cycleWave(phase - 0.02);
    body[Channel::HeadPitch] = gait_.headPitch;
    body[Channel::HeadYaw] = 0.15 * body[Channel::ChestYaw];
}

void GaitTrack::addArms(double phase, ChannelValues& body) const {
    for (std::size_t side = 0; side < 2; ++side) {
        // Each arm swings in phase with the opposite leg.
        const double half = side == 0 ? 0.0 : 0.5;
        const double forward = -cycleWave(phase + half - gait_.arm.late);
        body.arm(side, Channel::LeftArmForward) = gait_.arm.middle + gait_.arm.swing * forward;
        body.arm(side, Channel::LeftArmOut) = gait_.armOut;
        body.arm(side, Channel::LeftArmTurn) = gait_.armTurn + gait_.armAcross * forward;
        body.arm(side, Channel::LeftElbow) = gait_.elbow.middle -
                                             gait_.elbow.swing * cycleWave(phase + half - gait_.elbow.late);
        body.arm(side, Channel::LeftWrist) = gait_.wrist;
    }
}

void GaitTrack::addBend(ChannelValues& body) const {
    const double bank = 0.8 * arcTangent2(gait_.speed * gait_.speed * gait_.bend, kGravity);
    body[Channel::HipsY] += 0.6 * gait_.height * sine(bank);
    body[Channel::HipsZ] -= 0.5 * gait_.height * sine(bank) * sine(bank) + 0.08 * std::fabs(bank);
    body[Channel::PelvisRoll] -= bank;
    body[Channel::ChestRoll] -= 1.1 * bank;
    body[Channel::HeadRoll] -= 0.3 * bank;
    body[Channel::ChestYaw] += 0.5 * bank;
    body[Channel::HeadYaw] += bank;
}

ChannelValues GaitTrack::body(double time) const {
    const double phase = (time - start_) / gait_.cycle;
    ChannelValues body;
    addTrunk(phase, body);
    addArms(phase, body);
    if (gait_.bend != 0.0) addBend(body);
    return body;
}

Course GaitTrack::course() const {
    const GaitTrack copy = *this;
    return {[copy](double time) { return copy.travel(time); },
            [copy](double time) { return copy.body(time); }};
}

double GaitTrack::landing(std::size_t side, int cycle) const {
    return start_ + (cycle + (side == 0 ? 0.0 : 0.5)) * gait_.cycle;
}

Step GaitTrack::step(std::size_t side, int cycle, const Course& course) const {
    Step step;
    step.begin = landing(side, cycle);
    step.end = step.begin + gait_.contact * gait_.cycle;
    const Placement middle = course.travel(0.5 * (step.begin + step.end));
    const double sign = side == 0 ? 1.0 : -1.0;
    const double bank = 0.8 * arcTangent2(gait_.speed * gait_.speed * gait_.bend, kGravity);
    step.anchor = toGround(middle,
                           {static_cast<float>(gait_.footForward),
                            static_cast<float>(sign * gait_.footOut - 0.4 * gait_.height * sine(bank)),
                            static_cast<float>(kAnkleHeight)});
    step.yaw = middle.yaw + sign * gait_.toeOut;
    step.strike = gait_.strike;
    step.flat = gait_.flat * gait_.cycle;
    step.rise = gait_.heelRise * gait_.cycle;
    step.push = gait_.push;
    step.swing = gait_.swing;
    return step;
}

std::vector<Step> GaitTrack::steps(std::size_t side, int first, int last) const {
    const Course along = course();
    std::vector<Step> steps;
    for (int cycle = first; cycle <= last; ++cycle) steps.push_back(step(side, cycle, along));
    return steps;
}

LegTrack GaitTrack::leg(std::size_t side) const {
    return {side, steps(side, -3, 3), course()};
}

Clip gaitClip(const std::string& name, const std::string& motion, const Gait& gait) {
    const GaitTrack track(gait);
    const LegTrack left = track.leg(0), right = track.leg(1);
    ClipDef plan;
    plan.name = name;
    plan.motion = motion;
    plan.cyclic = true;
    plan.frames = static_cast<int>(gait.cycle * kFrameRate + 0.5);
    plan.figure = [&](double time) {
        Figure figure;
        figure.body = track.body(time);
        figure.legs = {left.at(time), right.at(time)};
        return figure;
    };
    plan.travel = [&](double time) { return track.travel(time); };
    addContacts(plan.contacts, 0, left.steps(), gait.cycle, true);
    addContacts(plan.contacts, 1, right.steps(), gait.cycle, true);
    return makeClip(std::move(plan));
}

Gait bent(Gait gait, double radius) {
    gait.bend = 1.0 / radius;
    return gait;
}

}  // namespace muster::generator
