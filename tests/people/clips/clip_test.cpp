// Clips, poses and the skeleton: sampling, travelling, contacts, validation.
#include "muster/clip.h"
#include "base/maths.h"

#include <doctest.h>

#include <cmath>
#include <limits>

using namespace muster;

namespace {

/// A cycle of 1 s at 4 poses a second: hips rise and fall, the head turns left and back, 2 m forward, turning
/// by `yaw`.
Clip cycle(float yaw = 0.0f) {
    Clip clip{.name = "cycle", .motion = "run", .rate = 4.0};
    for (int k = 0; k < 4; ++k) {
        BodyPose pose = restPose();
        pose.hips.z = 0.9f + 0.1f * static_cast<float>(k % 2);
        pose.rotation[index(JointRole::Head)] = yawTurn(k < 2 ? 0.2 * k : 0.2 * (4 - k));
        clip.poses.push_back(pose);
    }
    for (int k = 0; k <= 4; ++k)
        clip.travel.push_back({0.5f * static_cast<float>(k), 0.0f, yaw * static_cast<float>(k) / 4.0f});
    clip.contacts = {{Limb::LeftFoot, 0.75, 1.25, {0.1f, 0.09f, 0.08f}}, {Limb::RightFoot, 0.25, 0.5, {}}};
    return clip;
}

/// One play of 1 s at 4 poses a second.
Clip single() {
    Clip clip = cycle();
    clip.cyclic = false;
    clip.poses.push_back(clip.poses.front());
    clip.contacts.pop_back();
    clip.contacts[0].end = 1.0;
    return clip;
}

}  // namespace

TEST_CASE("The skeleton stands on the ground, 1.75 m tall, left and right alike") {
    JointTransforms joints;
    jointTransforms(restPose(), {}, joints);
    const auto& bones = skeleton();
    const Vec3 top = joints[index(JointRole::Head)].apply(bones[index(JointRole::Head)].tip);
    CHECK(top.z == doctest::Approx(kBodyHeight));
    CHECK(joints[index(JointRole::LeftFoot)].translation.z == doctest::Approx(0.08));
    CHECK(joints[index(JointRole::LeftHand)].translation.z ==
          doctest::Approx(joints[index(JointRole::LeftArm)].translation.z));
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const std::string name = bones[j].name;
        CHECK(bones[j].parent < static_cast<std::int32_t>(j));
        if (name.rfind("Left", 0) != 0) continue;
        for (std::size_t k = 0; k < kJointCount; ++k) {
            if (bones[k].name != "Right" + name.substr(4)) continue;
            CHECK(joints[k].translation.x == joints[j].translation.x);
            CHECK(joints[k].translation.y == doctest::Approx(-joints[j].translation.y));
            CHECK(joints[k].translation.z == joints[j].translation.z);
        }
    }
}

TEST_CASE("Forward kinematics: a raised arm, in a turned character") {
    BodyPose pose = restPose();
    pose.rotation[index(JointRole::LeftArm)] = axisAngle({1, 0, 0}, kPi / 2);  // From the side up.
    JointTransforms joints;
    jointTransforms(pose, {yawTurn(kPi / 2), {10.0f, 20.0f, 0.0f}}, joints);
    const Vec3 shoulder = joints[index(JointRole::LeftArm)].translation,
               hand = joints[index(JointRole::LeftHand)].translation;
    CHECK(shoulder.x == doctest::Approx(10.0 - 0.18));  // Its left is now -x.
    CHECK(shoulder.y == doctest::Approx(20.0));
    CHECK(distance(hand, shoulder + Vec3{0.0f, 0.0f, 0.53f}) < 1e-5f);
}

TEST_CASE("Sizes lie between 0.96 and 1.04, spread evenly over ids") {
    double sum = 0.0;
    int small = 0;
    for (std::uint32_t id = 0; id < 4000; ++id) {
        const float size = characterSize(id);
        CHECK(size >= 0.96f);
        CHECK(size <= 1.04f);
        sum += size;
        small += size < 0.98f ? 1 : 0;
    }
    CHECK(sum / 4000 == doctest::Approx(1.0).epsilon(0.002));
    CHECK(small == doctest::Approx(1000).epsilon(0.1));
}

TEST_CASE("A cycle is sampled between its poses and wraps in both directions") {
    const Clip clip = cycle();
    CHECK(clip.duration() == 1.0);
    CHECK(clip.length() == 2.0);
    CHECK(clip.speed() == 2.0);
    BodyPose pose;
    for (const double time : {0.125, 1.125, -0.875, 1000.125}) {
        clip.sample(time, pose);
        CHECK(pose.hips.z == doctest::Approx(0.95));
        CHECK(angleBetween({}, pose.rotation[index(JointRole::Head)]) == doctest::Approx(0.1).epsilon(1e-3));
    }
    clip.sample(0.875, pose);  // Between the last pose and the first.
    CHECK(angleBetween({}, pose.rotation[index(JointRole::Head)]) == doctest::Approx(0.1).epsilon(1e-3));
    clip.sample(0.25, pose);
    CHECK(pose.hips.z == 1.0f);
}

TEST_CASE("One play is held at its ends") {
    const Clip clip = single();
    CHECK(clip.duration() == 1.0);
    BodyPose pose;
    clip.sample(-3.0, pose);
    CHECK(pose.hips.z == clip.poses.front().hips.z);
    clip.sample(7.0, pose);
    CHECK(pose.hips.z == clip.poses.back().hips.z);
    CHECK(clip.travelAt(7.0).x == 2.0f);
    CHECK(clip.travelAt(-1.0).x == 0.0f);
}

TEST_CASE("Travel goes on cycle after cycle, straight or on a circle") {
    const Clip straight = cycle();
    CHECK(straight.travelAt(3.125).x == doctest::Approx(6.25));
    CHECK(straight.travelAt(-0.5).x == doctest::Approx(-1.0));
    // Four quarter turns end where they began.
    const Clip turning = cycle(static_cast<float>(kPi / 2));
    const Travel round = turning.travelAt(4.0);
    CHECK(round.x == doctest::Approx(0.0).epsilon(1e-5));
    CHECK(round.y == doctest::Approx(0.0).epsilon(1e-5));
    CHECK(round.yaw == doctest::Approx(2 * kPi));
    const Travel one = turning.travelAt(2.0);
    CHECK(one.x == doctest::Approx(2.0));
    CHECK(one.y == doctest::Approx(2.0));
    // Back by as much as forward.
    const Travel there = turning.travelAt(-3.0) * turning.travelAt(3.0);
    CHECK(std::hypot(there.x, there.y) < 1e-5);
    CHECK(there.yaw == doctest::Approx(0.0).epsilon(1e-5));
}

TEST_CASE("Contacts may go on in the next cycle") {
    const Clip clip = cycle();
    CHECK(clip.touches(Limb::LeftFoot, 0.8));
    CHECK(clip.touches(Limb::LeftFoot, 0.2));
    CHECK(clip.touches(Limb::LeftFoot, 5.2));
    CHECK_FALSE(clip.touches(Limb::LeftFoot, 0.3));
    CHECK(clip.touches(Limb::RightFoot, 0.3));
    CHECK_FALSE(clip.touches(Limb::RightFoot, 0.5));
    CHECK_FALSE(clip.touches(Limb::LeftHand, 0.3));
    REQUIRE(clip.contactAt(Limb::LeftFoot, 0.0) != nullptr);
    CHECK(clip.contactAt(Limb::LeftFoot, 0.0)->anchor.x == 0.1f);
    CHECK_FALSE(single().touches(Limb::LeftFoot, 0.1));
}

TEST_CASE("Clips are found by name") {
    ClipLibrary library{.clips = {cycle(), single()}};
    library.clips[1].name = "single";
    CHECK(library.indexOf("single") == 1);
    CHECK(library.find("single") == &library.clips[1]);
    CHECK(library.find("hop") == nullptr);
    CHECK(library.indexOf("hop") == -1);
}

TEST_CASE("A clip that cannot be played says why") {
    CHECK(validate(cycle()).ok());
    CHECK(validate(single()).ok());
    const auto refused = [](const char* why, auto spoil) {
        Clip clip = cycle();
        spoil(clip);
        const Status status = validate(clip);
        CHECK_FALSE(status.ok());
        CHECK_MESSAGE(status.message().find("cycle") != std::string::npos, status.message());
        CHECK_MESSAGE(status.message().find(why) != std::string::npos, status.message());
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    refused("rate", [](Clip& c) { c.rate = 0.0; });
    refused("fewer than two", [](Clip& c) { c.poses.resize(1); });
    refused("travel does not fit", [](Clip& c) { c.travel.pop_back(); });
    refused("no rotation", [](Clip& c) { c.poses[1].rotation[3] = {0.0f, 0.0f, 0.0f, 0.5f}; });
    refused("no place", [&](Clip& c) { c.poses[2].hips.y = nan; });
    refused("not finite", [&](Clip& c) { c.travel[1].yaw = nan; });
    refused("left foot", [](Clip& c) { c.contacts[0].begin = 1.5; });
    refused("right foot", [](Clip& c) { c.contacts[1].end = 0.2; });
}
