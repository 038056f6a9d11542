#include "people/generator/figure.h"

#include <doctest.h>
#include <rapidcheck.h>

#include "people/generator/leg_track.h"

using namespace muster;
using namespace muster::generator;

namespace {

double between(double low, double high) {
    return low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0;
}

Figure standing() {
    Figure figure;
    figure.body[Channel::HipsZ] = 0.9;
    for (std::size_t side = 0; side < 2; ++side)
        figure.legs[side] = standingLeg({0.0f, side == 0 ? 0.1f : -0.1f, 0.08f}, 0.0, 0.0);
    return figure;
}

JointTransforms jointsOf(const Figure& figure) {
    JointTransforms joints;
    jointTransforms(poseOf(figure), {}, joints);
    return joints;
}

}  // namespace

TEST_CASE("ankles within reach are where they should be, feet held as they should, knees ahead") {
    CHECK(rc::check("legs", [] {
        Figure figure = standing();
        figure.body[Channel::PelvisPitch] = between(-0.5, 1.2);
        figure.body[Channel::PelvisYaw] = between(-0.3, 0.3);
        figure.body[Channel::PelvisRoll] = between(-0.2, 0.2);
        Leg& leg = figure.legs[*rc::gen::inRange<std::size_t>(0, 2)];
        leg.ankle.x = static_cast<float>(between(-0.3, 0.3));
        leg.ankle.z = static_cast<float>(between(0.12, 0.5));
        leg.foot = turned(between(-1.0, 1.0), 0.0, between(-0.3, 0.3));
        const JointTransforms joints = jointsOf(figure);
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t up = index(JointRole::LeftUpLeg) + 4 * side;
            RC_ASSERT(distance(joints[up + 2].translation, figure.legs[side].ankle) < 1e-4f);
            RC_ASSERT(angleBetween(joints[up + 2].rotation, figure.legs[side].foot) < 1e-3);
            const Vec3 middle = lerp(joints[up].translation, joints[up + 2].translation, 0.5f);
            RC_ASSERT(joints[up + 1].translation.x > middle.x - 1e-4f);
            RC_ASSERT(std::fabs(distance(joints[up].translation, joints[up + 1].translation) - 0.42f) <
                      1e-4f);
            RC_ASSERT(std::fabs(distance(joints[up + 1].translation, joints[up + 2].translation) - 0.41f) <
                      1e-4f);
        }
    }));
}

TEST_CASE("an ankle out of reach leaves the leg straight towards it") {
    Figure figure = standing();
    figure.legs[0].ankle = {0.9f, 0.1f, 0.1f};
    const JointTransforms joints = jointsOf(figure);
    const Vec3 hip = joints[index(JointRole::LeftUpLeg)].translation,
               ankle = joints[index(JointRole::LeftFoot)].translation;
    CHECK(distance(hip, ankle) == doctest::Approx(0.83).epsilon(0.001));
    CHECK(dot(normalized(ankle - hip), normalized(figure.legs[0].ankle - hip)) > 0.9999f);
}

TEST_CASE("wrists reach what is within reach; hands lie flat") {
    CHECK(rc::check("arms", [] {
        Figure figure = standing();
        figure.body[Channel::ChestPitch] = between(0.0, 1.4);
        const JointTransforms before = jointsOf(figure);
        for (std::size_t side = 0; side < 2; ++side) {
            const float out = side == 0 ? 1.0f : -1.0f;
            const Vec3 shoulder = before[index(JointRole::LeftArm) + 4 * side].translation;
            const Vec3 way = normalized(Vec3{static_cast<float>(between(0.2, 1.0)),
                                             out * static_cast<float>(between(-0.2, 0.5)),
                                             static_cast<float>(between(-1.0, 0.3))});
            figure.reach[side] = {1.0,
                                  shoulder + way * static_cast<float>(between(0.2, 0.45)),
                                  flatHand(side, 0.0),
                                  {-0.6f, 0.6f * out, 0.0f}};
        }
        const JointTransforms joints = jointsOf(figure);
        for (std::size_t side = 0; side < 2; ++side) {
            const std::size_t hand = index(JointRole::LeftHand) + 4 * side;
            RC_ASSERT(distance(joints[hand].translation, figure.reach[side].wrist) < 1e-3f);
            // Fingers ahead, palm down.
            const float out = side == 0 ? 1.0f : -1.0f;
            RC_ASSERT(rotate(joints[hand].rotation, {0.0f, out, 0.0f}).x > 0.999f);
            RC_ASSERT(rotate(joints[hand].rotation, {0.0f, 0.0f, 1.0f}).z > 0.999f);
        }
    }));
}

TEST_CASE("a mirrored figure makes the mirrored pose") {
    Figure figure = standing();
    figure.body[Channel::LeftArmForward] = 0.5;
    figure.body[Channel::LeftArmOut] = 0.3;
    figure.body[Channel::LeftElbow] = 1.2;
    Figure other = standing();
    for (Channel channel : {Channel::LeftArmForward, Channel::LeftArmOut, Channel::LeftElbow})
        other.body.arm(1, channel) = figure.body[channel];
    const JointTransforms a = jointsOf(figure), b = jointsOf(other);
    for (JointRole role : {JointRole::LeftArm, JointRole::LeftForeArm, JointRole::LeftHand}) {
        Vec3 mirrored = b[index(role) + 4].translation;
        mirrored.y = -mirrored.y;
        CHECK(distance(a[index(role)].translation, mirrored) < 1e-5f);
    }
    CHECK(a[index(JointRole::LeftHand)].translation.x > 0.2f);
    CHECK(a[index(JointRole::LeftForeArm)].translation.y > a[index(JointRole::LeftArm)].translation.y);
}

TEST_CASE("a rolled foot keeps its heel or its toes' joint on the ground") {
    const Vec3 anchor{0.4f, 0.1f, 0.08f};
    for (double pitch : {0.1, 0.35, 0.6}) {
        const Leg heel = standingLeg(anchor, 0.2, pitch), toes = standingLeg(anchor, 0.2, -pitch);
        CHECK(distance(heel.ankle + rotate(heel.foot, kHeel), anchor + rotate(yawTurn(0.2), kHeel)) < 1e-6f);
        CHECK(distance(toes.ankle + rotate(toes.foot, kBall), anchor + rotate(yawTurn(0.2), kBall)) < 1e-6f);
        CHECK(toes.toe == doctest::Approx(-pitch));
        // Toes lie flat against the risen heel.
        const Quat lying = toes.foot * axisAngle({0.0f, 1.0f, 0.0f}, toes.toe);
        CHECK(rotate(lying, {1.0f, 0.0f, 0.0f}).z == doctest::Approx(0.0).epsilon(1e-5));
    }
}

TEST_CASE("a blend of figures is either at its ends") {
    Figure a = standing(), b = standing();
    b.body[Channel::HipsZ] = 0.7;
    b.legs[0].ankle.x = 0.2f;
    b.reach[0].weight = 1.0;
    b.reach[0].wrist = {0.5f, 0.2f, 1.0f};
    CHECK(jointsOf(blend(a, b, 0.0))[index(JointRole::LeftFoot)].translation ==
          jointsOf(a)[index(JointRole::LeftFoot)].translation);
    CHECK(distance(jointsOf(blend(a, b, 1.0))[index(JointRole::LeftHand)].translation,
                   jointsOf(b)[index(JointRole::LeftHand)].translation) < 1e-5f);
    CHECK(blend(a, b, 0.5).body[Channel::HipsZ] == doctest::Approx(0.8));
}
