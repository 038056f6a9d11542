#include "people/generator/other_clips.h"

#include "people/generator/clip_maker.h"
#include "people/generator/gait.h"
#include "people/generator/key_poses.h"

namespace muster::generator {
namespace {

constexpr int kClimbFrames = 185;
constexpr double kClimbEnd = kClimbFrames / kFrameRate;  // Duration of the clip [s].
constexpr double kLength = 0.39 * kClimbEnd;             // Distance that the clip travels [m].
constexpr ClipObstacle kWall{1.3f, 0.4f};
constexpr double kTouchDown = 2.50;  // Time at which the right foot lands behind the wall [s].

// Times between which each foot follows keys; it stands otherwise [s].
constexpr double kLeftUp = 0.94, kRightUp = 0.74, kLeftDown = 2.58;
constexpr double kLandingPitch = -24;  // Pitch of the foot at landing [degrees]; negative lands on the toes.

constexpr Vec3 kFaceFoot{0.275f, -0.16f, 0.49f};  // Right ankle while its sole presses against the wall [m].

const std::vector<HandContact> kLeftHand{{0.18, 0.22, {0.20f, 0.26f, 1.32f}, 0.18, 0.2, false},
                                         {0.44, 1.72, {0.50f, 0.21f, 1.345f}, 0.25, 0.28}};
const std::vector<HandContact> kRightHand{{0.14, 0.24, {0.20f, -0.26f, 1.32f}, 0.14, 0.2, false},
                                          {0.48, 1.70, {0.50f, -0.21f, 1.345f}},
                                          {1.92, 2.03, {0.755f, -0.28f, 1.345f}, 0.22, 0.35}};

/// Distance of the travelling frame along x by time; it moves below the hips.
const Curve& travelCurve() {
    static const Curve kWay = Curve::spline({{0.0, 0.0},
                                             {0.38, 0.09},
                                             {0.66, 0.06},
                                             {0.98, 0.14},
                                             {1.30, 0.22},
                                             {1.62, 0.30},
                                             {1.95, 0.52},
                                             {2.15, 0.74},
                                             {2.32, 0.92},
                                             {2.52, 1.02},
                                             {2.75, 1.03},
                                             {kClimbEnd, kLength}},
                                            0.6, 0.9);
    return kWay;
}

const BodyKeys& bodyKeys() {
    using enum Channel;
    static const BodyKeys kHeld({
        {HipsX, {{0.0, 0.0}}},
        {HipsY, {{0.0, 0.0}, {0.9, -0.02}, {1.62, 0.03}, {2.1, 0.02}, {2.6, 0.0}}},
        {HipsZ,
         {{0.0, 0.90},
          {0.38, 0.86},
          {0.64, 0.78},
          {0.98, 1.02},
          {1.30, 1.30},
          {1.62, 1.59},
          {1.95, 1.70},
          {2.12, 1.66},
          {2.30, 1.46},
          {2.50, 0.93},
          {2.68, 0.71},
          {2.78, 0.72},
          {kClimbEnd, 0.92}}},
        {PelvisPitch,
         {{0.0, 6},
          {0.38, 8},
          {0.64, 18},
          {0.98, 10},
          {1.30, 24},
          {1.62, 50},
          {1.95, 64},
          {2.06, 60},
          {2.20, 38},
          {2.35, 18},
          {2.52, 12},
          {2.70, 32},
          {kClimbEnd, 8}}},
        {PelvisRoll, {{0.0, 0}, {1.30, 0}, {1.60, 16}, {1.90, -6}, {2.08, -14}, {2.35, 0}}},
        {PelvisYaw, {{0.0, 0}, {1.25, 0}, {1.60, -14}, {2.05, 20}, {2.40, 0}}},
        {ChestPitch,
         {{0.0, 6},
          {0.38, 6},
          {0.64, 22},
          {0.98, 14},
          {1.30, 38},
          {1.62, 76},
          {1.95, 97},
          {2.06, 94},
          {2.22, 62},
          {2.35, 34},
          {2.52, 22},
          {2.70, 46},
          {kClimbEnd, 8}}},
        {ChestRoll, {{0.0, 0}, {1.70, 0}, {2.00, -12}, {2.35, 0}}},
        {ChestYaw, {{0.0, 0}, {1.60, 0}, {2.00, -10}, {2.40, 0}}},
        {HeadPitch,
         {{0.0, 0},
          {0.38, -12},
          {0.64, -14},
          {0.98, -8},
          {1.30, 8},
          {1.62, 30},
          {1.95, 48},
          {2.15, 48},
          {2.50, 24},
          {2.72, 18},
          {kClimbEnd, 3}}},
        {HeadYaw, {{0.0, 0}}},
        {LeftArmForward, {{0.0, 30}, {1.7, 20}, {2.1, 30}, {2.4, 40}, {2.7, 10}, {kClimbEnd, 0}}},
        {LeftArmOut, {{0.0, 20}, {1.7, 80}, {1.92, 92}, {2.15, 80}, {2.55, 38}, {kClimbEnd, 14}}},
        {LeftElbow, {{0.0, 80}, {1.7, 14}, {2.1, 20}, {2.4, 45}, {2.7, 50}, {kClimbEnd, 90}}},
        {RightArmForward, {{0.0, 30}, {1.7, 60}, {2.3, 30}, {2.7, 10}, {kClimbEnd, 0}}},
        {RightArmOut, {{0.0, 20}, {1.7, 50}, {2.1, 70}, {2.3, 60}, {2.55, 34}, {kClimbEnd, 14}}},
        {RightElbow, {{0.0, 80}, {2.3, 40}, {2.7, 55}, {kClimbEnd, 90}}},
    });
    return kHeld;
}

/// The jog before the wall and the jog after it, in the time of this clip.
struct Jogs {
    GaitTrack before{gaitOf(GaitKind::Jog), 0.0};
    GaitTrack after{gaitOf(GaitKind::Jog), kClimbEnd - 0.70 * gaitOf(GaitKind::Jog).cycle};
};

Course climbCourse() {
    const Jogs jogs;
    Course course;
    course.travel = straight([](double time) { return travelCurve().at(time); });
    course.body = [jogs](double time) {
        const ChannelValues body = blend(jogs.before.body(time), bodyKeys().at(time, {}),
                                         rise(0.0, 0.35, time));
        return blend(body, jogs.after.body(time), rise(kClimbEnd - 0.32, kClimbEnd, time));
    };
    return course;
}

FootCurve leftPath(Leg from, Leg to) {
    const Vec3 out{0.4f, 0.8f, 0.5f}, ahead{1.0f, 0.2f, 0.2f};
    return FootCurve({{kLeftUp, from.ankle, -48, ahead, from.toe / degrees(1)},
                      {1.18, {0.05f, 0.15f, 0.50f}, -60, out},
                      {1.36, {0.08f, 0.36f, 0.98f}, -30, out},
                      {1.50, {0.24f, 0.45f, 1.42f}, -5, out},
                      {1.66, {0.57f, 0.20f, 1.38f}, 0, out},
                      {2.14, {0.57f, 0.20f, 1.38f}, 0, out},
                      {2.26, {0.74f, 0.36f, 1.46f}, -25, out},
                      {2.34, {0.89f, 0.38f, 1.36f}, -25, out},
                      {2.46, {0.99f, 0.22f, 0.80f}, -25, ahead},
                      {kLeftDown, to.ankle, kLandingPitch, ahead, kLandingPitch}});
}

FootCurve rightPath(Leg from, Leg to) {
    const Vec3 out{0.35f, -1.0f, 0.1f}, ahead{1.0f, -0.2f, 0.2f}, high{0.6f, -0.7f, 0.7f};
    return FootCurve({{kRightUp, from.ankle, -40, ahead, from.toe / degrees(1)},
                      {0.86, {0.19f, -0.17f, 0.36f}, 42, out},
                      {0.96, kFaceFoot, 70, out, -20},
                      {1.24, kFaceFoot, 70, out, -20},
                      {1.31, {0.15f, -0.16f, 0.57f}, 45, out},
                      {1.48, {0.10f, -0.20f, 0.80f}, -40, out},
                      {1.74, {0.04f, -0.24f, 1.22f}, -70, out},
                      {1.92, {0.22f, -0.36f, 1.52f}, -40, high},
                      {2.08, {0.62f, -0.38f, 1.56f}, -10, high},
                      {2.24, {0.98f, -0.22f, 1.18f}, -5, ahead},
                      {kTouchDown, to.ankle, kLandingPitch, ahead, kLandingPitch}});
}

/// Steps of both legs before and after the wall.
struct Stands {
    LegTrack before[2], after[2];
};

Stands standsOf(const Course& course) {
    const Jogs jogs;
    Step left = jogs.before.step(0, 0, jogs.before.course());
    left.end = kLeftUp;
    left.rise = 0.25;
    left.push = degrees(48);
    Step swung = jogs.before.step(1, -1, jogs.before.course());
    swung.swing = {{}, {{0.8, degrees(70)}}, {}};
    Step right = left;
    right.strike = 0.0;
    right.begin = 0.30;
    right.end = kRightUp;
    right.push = degrees(40);
    right.anchor = {0.09f, -0.12f, static_cast<float>(kAnkleHeight)};
    right.yaw = -left.yaw;
    Step landed = jogs.after.step(1, 0, course), leaving = landed;
    landed.begin = kTouchDown;
    landed.anchor.x = static_cast<float>(course.travel(kClimbEnd).x +
                                         jogs.after.step(1, 0, jogs.after.course()).anchor.x -
                                         jogs.after.travel(kClimbEnd).x);
    landed.strike = degrees(kLandingPitch);
    landed.flat = 0.12;
    leaving = landed;
    leaving.begin = kLeftDown;
    leaving.end = 2.86;
    leaving.anchor.y = -landed.anchor.y + 0.05f;
    leaving.anchor.x += 0.01f;
    leaving.yaw = -landed.yaw;
    leaving.push = degrees(45);
    leaving.swing = {{}, {}, {}};
    Step next = jogs.after.step(0, 1, course);
    next.begin = jogs.after.landing(0, 1);
    return {{LegTrack(0, {left}, course), LegTrack(1, {swung, right}, course, jogs.before.leg(1).join(0.0))},
            {LegTrack(0, {leaving, next}, course, {}, jogs.after.leg(0).join(kClimbEnd)),
             LegTrack(1, {landed}, course)}};
}

}  // namespace

Clip climbClip() {
    const Course course = climbCourse();
    const Stands stands = standsOf(course);
    const auto ground = [&](const LegTrack& track, double time) {
        Leg leg = track.at(time);
        leg.ankle = toGround(course.travel(time), leg.ankle);
        return leg;
    };
    const FootCurve left = leftPath(ground(stands.before[0], kLeftUp), ground(stands.after[0], kLeftDown));
    const FootCurve right = rightPath(ground(stands.before[1], kRightUp),
                                      ground(stands.after[1], kTouchDown));
    const double up[2] = {kLeftUp, kRightUp}, down[2] = {kLeftDown, kTouchDown};
    ClipDef plan;
    plan.name = "climb";
    plan.motion = "climb";
    plan.frames = kClimbFrames;
    plan.figure = [&](double time) {
        const Placement place = course.travel(time);
        Figure figure;
        figure.body = course.body(time);
        for (std::size_t side = 0; side < 2; ++side) {
            const bool stands0 = time <= up[side], stands1 = time >= down[side];
            figure.legs[side] = stands0   ? stands.before[side].at(time)
                                : stands1 ? stands.after[side].at(time)
                                          : fromGround(place, (side == 0 ? left : right).at(time));
            figure.reach[side] = fromGround(place, reachAt(side == 0 ? kLeftHand : kRightHand, side, time));
        }
        return figure;
    };
    plan.travel = course.travel;
    for (std::size_t side = 0; side < 2; ++side) {
        addContacts(plan.contacts, side, stands.before[side].steps(), kClimbEnd, false);
        addContacts(plan.contacts, side, stands.after[side].steps(), kClimbEnd, false);
        addContacts(plan.contacts, side, side == 0 ? kLeftHand : kRightHand);
    }
    plan.contacts.push_back({Limb::RightFoot, 0.96, 1.24, right.at(1.0).ankle});
    plan.contacts.push_back({Limb::LeftFoot, 1.66, 2.14, left.at(1.7).ankle});
    plan.entryPhase = 0.70;
    plan.exitPhase = 0.0;
    plan.obstacle = kWall;
    return makeClip(std::move(plan));
}

}  // namespace muster::generator
