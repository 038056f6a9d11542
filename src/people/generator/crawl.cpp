#include "people/generator/crawl.h"

#include <cmath>

#include "base/maths.h"

namespace muster::generator {
namespace {

constexpr double kKneeHeight = 0.065;  // Height of the joint of a knee on the ground [m].
constexpr double kWristHeight = 0.05;  // Height of the wrist of a hand that lies flat [m].
constexpr double kKneeX = -0.36;       // Position of a knee in the middle of its contact [m].
constexpr double kKneeY = 0.10;
constexpr double kHandX = 0.20;
constexpr double kHandY = 0.17;
constexpr double kHandLate = 0.04;  // Share of the cycle by which a hand lands after the opposite knee.

/// Motion of a limb over one cycle: forward distance from the middle of the contact, and swing height.
struct Stroke {
    double along = 0.0;  // Forward distance from the middle of the contact [m].
    double lift = 0.0;   // Swing height, 0 to 1.
};

Stroke crawlStroke(double phase) {
    phase -= std::floor(phase);
    const double cycle = CrawlTrack::kCycle, half = 0.5 * CrawlTrack::kContact * cycle * CrawlTrack::kSpeed;
    if (phase < CrawlTrack::kContact) return {half - CrawlTrack::kSpeed * phase * cycle, 0.0};
    const double length = (1.0 - CrawlTrack::kContact) * cycle,
                 since = (phase - CrawlTrack::kContact) * cycle;
    const Curve along = Curve::spline({{0.0, -half}, {length, half}}, -CrawlTrack::kSpeed,
                                      -CrawlTrack::kSpeed);
    return {along.at(since), hump(0.0, length, since)};
}

ChannelValues crawlBody(double phase) {
    ChannelValues body;
    body[Channel::HipsX] = -0.26;
    body[Channel::HipsY] = 0.022 * cycleWave(phase - 0.3);
    body[Channel::PelvisPitch] = degrees(86);
    body[Channel::PelvisYaw] = -degrees(5) * cycleWave(phase);
    body[Channel::ChestPitch] = degrees(90);
    body[Channel::ChestYaw] = degrees(6) * cycleWave(phase);
    body[Channel::ChestRoll] = -degrees(3) * cycleWave(phase - 0.3);
    body[Channel::HeadPitch] = degrees(44);
    body[Channel::HeadYaw] = degrees(2) * cycleWave(phase);
    // The arms contact near the hands' contacts, so that clips can blend the hands in and out.
    for (std::size_t side = 0; side < 2; ++side) {
        body.arm(side, Channel::LeftArmForward) = degrees(68);
        body.arm(side, Channel::LeftArmOut) = degrees(10);
        body.arm(side, Channel::LeftElbow) = degrees(62);
        body.arm(side, Channel::LeftWrist) = -degrees(60);
    }
    return body;
}

/// Sets height and roll of the pelvis so that both knees reach their targets.
void rest(ChannelValues& body, const Vec3 knees[2]) {
    body[Channel::HipsZ] = 0.45;
    for (int round = 0; round < 12; ++round) {
        double lift[2];
        for (std::size_t side = 0; side < 2; ++side) {
            const Vec3 hip = hipJoint(body, side);
            const double dx = knees[side].x - hip.x, dy = knees[side].y - hip.y;
            lift[side] = knees[side].z + std::sqrt(kThigh * kThigh - dx * dx - dy * dy) - hip.z;
        }
        body[Channel::HipsZ] += 0.5 * (lift[0] + lift[1]);
        body[Channel::PelvisRoll] += (lift[0] - lift[1]) / 0.18;
    }
}

/// A kneeling leg: the knee points to `target`, the shin lies backwards and is raised by `rise` [rad].
Leg kneelingLeg(const ChannelValues& body, std::size_t side, Vec3 target, double rise) {
    const Vec3 hip = hipJoint(body, side), thigh = normalized(target - hip) * static_cast<float>(kThigh);
    const Vec3 knee = hip + thigh;
    const double turn = side == 0 ? 0.06 : -0.06;
    Leg leg;
    leg.ankle = knee + rotate(turned(rise, 0.0, -turn), {static_cast<float>(-kShin), 0.0f, 0.0f});
    leg.foot = turned(degrees(166) + rise, 0.0, -turn);
    leg.knee = normalized(knee - lerp(hip, leg.ankle, 0.5f));
    return leg;
}

}  // namespace

CrawlTrack::CrawlTrack(double start) : start_(start) {}

double CrawlTrack::kneeLanding(std::size_t side, int cycle) const {
    return start_ + (cycle + (side == 0 ? 0.0 : 0.5)) * kCycle;
}

double CrawlTrack::handLanding(std::size_t side, int cycle) const {
    return start_ + (cycle + kHandLate + (side == 0 ? 0.5 : 0.0)) * kCycle;
}

Vec3 CrawlTrack::kneeAnchor(std::size_t side, int cycle) const {
    const double middle = kneeLanding(side, cycle) + 0.5 * kContact * kCycle;
    return {static_cast<float>(kKneeX + travel(middle).x), static_cast<float>(side == 0 ? kKneeY : -kKneeY),
            static_cast<float>(kKneeHeight)};
}

Vec3 CrawlTrack::handAnchor(std::size_t side, int cycle) const {
    const double middle = handLanding(side, cycle) + 0.5 * kContact * kCycle;
    return {static_cast<float>(kHandX + travel(middle).x), static_cast<float>(side == 0 ? kHandY : -kHandY),
            static_cast<float>(kWristHeight)};
}

Figure CrawlTrack::figure(double time) const {
    const double phase = (time - start_) / kCycle;
    Figure figure;
    figure.body = crawlBody(phase);
    Vec3 knees[2];
    Stroke stroke[2];
    for (std::size_t side = 0; side < 2; ++side) {
        stroke[side] = crawlStroke(phase - (side == 0 ? 0.0 : 0.5));
        knees[side] = {static_cast<float>(kKneeX + stroke[side].along),
                       static_cast<float>(side == 0 ? kKneeY : -kKneeY),
                       static_cast<float>(kKneeHeight + 0.03 * stroke[side].lift)};
    }
    rest(figure.body, knees);
    for (std::size_t side = 0; side < 2; ++side) {
        knees[side].z += static_cast<float>(0.03 * stroke[side].lift);
        figure.legs[side] = kneelingLeg(figure.body, side, knees[side],
                                        -degrees(1) + degrees(3) * stroke[side].lift);
        const Stroke hand = crawlStroke(phase - kHandLate - (side == 0 ? 0.5 : 0.0));
        const float out = side == 0 ? 1.0f : -1.0f;
        Reach& reach = figure.reach[side];
        reach.weight = 1.0;
        reach.wrist = {static_cast<float>(kHandX + hand.along), out * static_cast<float>(kHandY),
                       static_cast<float>(kWristHeight + 0.07 * hand.lift)};
        reach.hand = flatHand(side, -0.15 * out, -degrees(35) * hand.lift);
        reach.elbow = {-0.7f, 0.6f * out, 0.15f};
    }
    return figure;
}

Clip crawlClip() {
    const CrawlTrack track;
    ClipDef plan;
    plan.name = "crawl";
    plan.motion = "crawl";
    plan.cyclic = true;
    plan.frames = static_cast<int>(CrawlTrack::kCycle * kFrameRate + 0.5);
    plan.figure = [&](double time) { return track.figure(time); };
    plan.travel = [&](double time) { return track.travel(time); };
    const double contact = CrawlTrack::kContact * CrawlTrack::kCycle;
    for (std::size_t side = 0; side < 2; ++side) {
        const double knee = track.kneeLanding(side, 0), hand = track.handLanding(side, 0);
        plan.contacts.push_back(
            {side == 0 ? Limb::LeftKnee : Limb::RightKnee, knee, knee + contact, track.kneeAnchor(side, 0)});
        plan.contacts.push_back(
            {side == 0 ? Limb::LeftHand : Limb::RightHand, hand, hand + contact, track.handAnchor(side, 0)});
    }
    return makeClip(std::move(plan));
}

}  // namespace muster::generator
