#include "people/clips/retarget.h"

#include <doctest.h>

#include "people/clips/clip_samples.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("names of many programs are understood") {
    const std::array<std::array<std::string, 9>, 8> kSchemes{{
        {"mixamorig:Hips", "mixamorig:Spine", "mixamorig:Head", "mixamorig:LeftUpLeg", "mixamorig:LeftLeg",
         "mixamorig:LeftFoot", "mixamorig:RightUpLeg", "mixamorig:RightLeg", "mixamorig:RightFoot"},
        {"root", "lowerback", "head", "lfemur", "ltibia", "lfoot", "rfemur", "rtibia", "rfoot"},
        {"Hips", "Chest", "Head", "LeftHip", "LeftKnee", "LeftAnkle", "RightHip", "RightKnee", "RightAnkle"},
        {"Bip01 Pelvis", "Bip01 Spine", "Bip01 Head", "Bip01 L Thigh", "Bip01 L Calf", "Bip01 L Foot",
         "Bip01 R Thigh", "Bip01 R Calf", "Bip01 R Foot"},
        {"pelvis", "spine_01", "head", "thigh_l", "calf_l", "foot_l", "thigh_r", "calf_r", "foot_r"},
        {"Hips", "Spine1", "Head", "LeftThigh", "LeftShin", "LeftFoot", "RightThigh", "RightShin",
         "RightFoot"},
        {"DEF-hips", "DEF-spine.001", "DEF-head", "DEF-thigh.L", "DEF-shin.L", "DEF-foot.L", "DEF-thigh.R",
         "DEF-shin.R", "DEF-foot.R"},
        {"hip", "abdomen", "head", "lThigh", "lShin", "lFoot", "rThigh", "rShin", "rFoot"},
    }};
    for (const auto& names : kSchemes) {
        HandMade made{.names = names};
        const auto motion = parseBvh(made.text(), "x.bvh");
        REQUIRE_MESSAGE(motion.ok(), motion.status().message());
        const RoleJoints roles = findRoles(motion->joints);
        using enum JointRole;
        std::size_t joint = 0;
        for (const JointRole role :
             {Hips, Chest, Head, LeftUpLeg, LeftLeg, LeftFoot, RightUpLeg, RightLeg, RightFoot})
            CHECK_MESSAGE(roles[index(role)] == static_cast<std::int32_t>(joint++), names[joint - 1]);
        const auto clip = retarget(*motion);
        REQUIRE(clip.ok());
        CHECK(clip->length() == doctest::Approx(2.0).epsilon(1e-3));
    }
}

TEST_CASE("arms are found with and without collars") {
    const auto joint = [](const char* name, std::int32_t parent) {
        return BvhJoint{name, parent, {}, {}, false};
    };
    using enum JointRole;
    const std::vector<BvhJoint> dm{joint("Hips", -1), joint("Chest", 0), joint("LeftShoulder", 1),
                                   joint("LeftElbow", 2), joint("LeftWrist", 3)};
    RoleJoints roles = findRoles(dm);
    CHECK(roles[index(LeftShoulder)] == -1);
    CHECK(roles[index(LeftArm)] == 2);
    CHECK(roles[index(LeftForeArm)] == 3);
    CHECK(roles[index(LeftHand)] == 4);
    const std::vector<BvhJoint> collar{joint("Hips", -1), joint("Chest", 0), joint("LeftCollar", 1),
                                       joint("LeftShoulder", 2), joint("LeftElbow", 3)};
    roles = findRoles(collar);
    CHECK(roles[index(LeftShoulder)] == 2);
    CHECK(roles[index(LeftArm)] == 3);
    const std::vector<BvhJoint> mixamo{joint("m:Hips", -1),           joint("m:Spine", 0),
                                       joint("m:Spine1", 1),          joint("m:Spine2", 2),
                                       joint("m:RightShoulder", 3),   joint("m:RightArm", 4),
                                       joint("m:RightForeArm", 5),    joint("m:RightHand", 6),
                                       joint("m:RightHandThumb1", 7), joint("m:Neck", 3)};
    roles = findRoles(mixamo);
    CHECK(roles[index(Spine)] == 1);
    CHECK(roles[index(Chest)] == 3);
    CHECK(roles[index(RightShoulder)] == 4);
    CHECK(roles[index(RightArm)] == 5);
    CHECK(roles[index(RightHand)] == 7);
    CHECK(roles[index(Neck)] == 9);
}

TEST_CASE("what is no person is refused by what is missing") {
    HandMade made{.names = {"Hips", "Spine", "Head", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg",
                            "Wheel", "RightFoot"}};
    const auto motion = parseBvh(made.text(), "x.bvh");
    REQUIRE(motion.ok());
    CHECK(retarget(*motion).status().message().find("RightLeg") != std::string::npos);
    BvhMotion brief = *parseBvh(HandMade{}.text(), "x.bvh");
    brief.frames = 2;
    brief.values.resize(2 * brief.joints.size());
    CHECK(retarget(brief).status().message().find("at least 3") != std::string::npos);
}
