#include "people/motion/inertialisation.h"
#include "base/maths.h"

#include <doctest.h>

#include <cmath>

using namespace muster;

namespace {

constexpr float kFrame = 1.0f / 60.0f;

BodyPose bent(double angle) {
    BodyPose pose = restPose();
    pose.rotation[index(JointRole::LeftLeg)] = axisAngle({0.0f, 1.0f, 0.0f}, angle);
    return pose;
}

double kneeOf(const BodyPose& pose) {
    return 2.0 * arcTangent2(static_cast<double>(pose.rotation[index(JointRole::LeftLeg)].y),
                             static_cast<double>(pose.rotation[index(JointRole::LeftLeg)].w));
}

}  // namespace

TEST_CASE("a switch between poses at rest fades as a critically damped spring does") {
    const auto decay = static_cast<float>(exponential(static_cast<double>(-kInertialisationRate * kFrame)));
    Inertialisation inertia;
    inertia.begin(bent(0.4), bent(0.4), bent(0.0), bent(0.0), kFrame);
    for (int k = 1; k <= 30; ++k) {
        BodyPose pose = bent(0.0);
        inertia.apply(kFrame, decay, pose);
        const double t = k / 60.0, y = static_cast<double>(kInertialisationRate);
        const double expected = 2.0 * std::asin(std::sin(0.2) * (1.0 + y * t) * std::exp(-y * t));
        CHECK(kneeOf(pose) == doctest::Approx(expected).epsilon(1e-3));
    }
}

TEST_CASE("a knee that swings on swings on through a switch, without a jump") {
    const auto decay = static_cast<float>(exponential(static_cast<double>(-kInertialisationRate * kFrame)));
    const double speed = 3.0;  // [rad/s]
    Inertialisation inertia;
    inertia.begin(bent(0.4 - speed / 60.0), bent(0.4), bent(0.1), bent(0.1), kFrame);
    double before = 0.4, speedBefore = speed;
    for (int k = 1; k <= 60; ++k) {
        BodyPose pose = bent(0.1);
        inertia.apply(kFrame, decay, pose);
        const double now = kneeOf(pose), speedNow = (now - before) * 60.0;
        CHECK(std::fabs(speedNow - speedBefore) <
              2.2);  // From 3 rad/s at 16 /s: under 2.2 rad/s a step at first.
        before = now;
        speedBefore = speedNow;
    }
    CHECK(before == doctest::Approx(0.1).epsilon(1e-2));
    CHECK(!inertia.active());
}

TEST_CASE("without a difference nothing changes") {
    Inertialisation inertia;
    BodyPose pose = bent(0.7);
    inertia.apply(kFrame, 0.8f, pose);
    CHECK(pose.rotation[index(JointRole::LeftLeg)] == bent(0.7).rotation[index(JointRole::LeftLeg)]);
    inertia.begin(bent(0.7), bent(0.7), bent(0.7), bent(0.7), kFrame);
    inertia.apply(kFrame, 0.8f, pose);
    CHECK(angleBetween(pose.rotation[index(JointRole::LeftLeg)],
                       bent(0.7).rotation[index(JointRole::LeftLeg)]) < 1e-3);
}
