#include "muster/clips/retarget.h"

#include <doctest.h>
#include <rapidcheck.h>

#include <nlohmann/json.hpp>

#include "clips/forward.h"
#include "clips/hips_path.h"
#include "clips/samples.h"

using namespace muster;
using namespace muster::testing;

namespace {

BvhMotion recording(const std::string& name) {
    auto motion = readBvh(mocapFolder() + "/" + name + ".bvh");
    REQUIRE_MESSAGE(motion.ok(), motion.status().message());
    return std::move(motion).value();
}

Clip retargeted(const std::string& name) {
    auto clip = retarget(recording(name), {name});
    REQUIRE_MESSAGE(clip.ok(), name, ": ", clip.status().message());
    return std::move(clip).value();
}

/// Angle in the plane of the ground frame by which a clip's own frame was turned against the file's [rad],
/// and more: the turn that takes the file's world to the clip's.
Quat worldTurn(const Clip& clip, const BvhMotion& motion, const RoleJoints& roles, std::size_t frame) {
    std::vector<Transform> theirs;
    globalTransforms(motion, frame, theirs);
    JointTransforms ours;
    jointTransforms(clip.poses[frame], {yawTurn(clip.travel[frame].yaw), {}}, ours);
    const auto place = [&](JointRole role) {
        return theirs[static_cast<std::size_t>(roles[index(role)])].translation;
    };
    const Vec3 a = place(JointRole::LeftLeg) - place(JointRole::LeftUpLeg);
    const Vec3 b =
        ours[index(JointRole::LeftLeg)].translation - ours[index(JointRole::LeftUpLeg)].translation;
    return yawTurn(arcTangent2(b.y, b.x) - arcTangent2(a.y, a.x));
}

}  // namespace

TEST_CASE("bones of all recordings point where the recording's point") {
    using enum JointRole;
    static constexpr std::pair<JointRole, JointRole> kBones[] = {
        {LeftUpLeg, LeftLeg},  {LeftLeg, LeftFoot},    {RightUpLeg, RightLeg},
        {RightLeg, RightFoot}, {LeftArm, LeftForeArm}, {RightArm, RightForeArm}};
    for (const std::string& name : mocapNames()) {
        const BvhMotion motion = recording(name);
        const RoleJoints roles = findRoles(motion.joints);
        const auto clip = retarget(motion, {name, "run", false});
        REQUIRE(clip.ok());
        REQUIRE(clip->poses.size() == motion.frames);
        const Quat turn = worldTurn(*clip, motion, roles, motion.frames / 2);
        for (std::size_t f = 0; f < motion.frames; f += 7) {
            std::vector<Transform> theirs;
            globalTransforms(motion, f, theirs);
            JointTransforms ours;
            jointTransforms(clip->poses[f], {yawTurn(clip->travel[f].yaw), {}}, ours);
            for (const auto& [from, to] : kBones) {
                const auto place = [&](JointRole role) {
                    return theirs[static_cast<std::size_t>(roles[index(role)])].translation;
                };
                const Vec3 their = rotate(turn, normalized(place(to) - place(from)));
                const Vec3 our = normalized(ours[index(to)].translation - ours[index(from)].translation);
                REQUIRE_MESSAGE(distance(their, our) < 0.02f, name, " frame ", f, " ",
                                skeleton()[index(from)].name);
            }
        }
    }
}

TEST_CASE("recordings stand on the floor at our size") {
    for (const std::string& name : mocapNames()) {
        const Clip clip = retargeted(name);
        CHECK(validate(clip).ok());
        float lowest = 1e9f, highest = 0.0f;
        for (const BodyPose& pose : clip.poses) {
            JointTransforms joints;
            jointTransforms(pose, {}, joints);
            for (const JointRole foot :
                 {JointRole::LeftFoot, JointRole::RightFoot, JointRole::LeftToeBase, JointRole::RightToeBase})
                lowest = std::min(lowest, joints[index(foot)].translation.z);
            highest = std::max(highest, joints[index(JointRole::Head)].translation.z);
        }
        CHECK_MESSAGE(lowest > -0.06f, name);
        CHECK_MESSAGE(lowest < 0.15f, name);
        CHECK_MESSAGE(highest > (name == "crawl_low_dm" ? 0.3f : 1.3f), name);
    }
}

TEST_CASE("which recordings repeat") {
    for (const std::string& name : mocapNames()) {
        const bool expected = name.find("_loop") != std::string::npos || name == "run_dm" ||
                              name == "sneak_walk_dm" || name == "crawl_low_dm";
        CHECK_MESSAGE(isCyclic(recording(name)) == expected, name);
    }
}

TEST_CASE("cyclic recordings go straight ahead and close without a jump") {
    for (const std::string& name : mocapNames()) {
        const Clip clip = retargeted(name);
        if (!clip.cyclic) continue;
        CHECK(clip.travel.front().x == 0.0f);
        CHECK_MESSAGE(std::fabs(clip.travel.back().y) < 1e-3f, name);
        CHECK(clip.travel.back().yaw == 0.0f);
        CHECK(clip.travel.back().x > 0.5f);
        // No joint turns more over the seam than within the clip.
        double most = 0.0, seam = 0.0;
        for (std::size_t j = 0; j < kJointCount; ++j) {
            for (std::size_t f = 1; f < clip.poses.size(); ++f)
                most = std::max(most, angleBetween(clip.poses[f].rotation[j], clip.poses[f - 1].rotation[j]));
            seam =
                std::max(seam, angleBetween(clip.poses.front().rotation[j], clip.poses.back().rotation[j]));
        }
        CHECK_MESSAGE(seam < 1.2 * most + 0.01, name);
    }
}

TEST_CASE("feet touch when the recordings' do") {
    nlohmann::json analysis;
    if (const auto text = readTextFile(mocapFolder() + "/analysis.json"); text.ok())
        analysis = nlohmann::json::parse(*text);
    // Not the fast walk: of its later steps the analysis saw none.
    for (const auto& [name, least] : {std::pair{"walk_cmu02_01", 0.85},
                                      {"run_jog_cmu02_03", 0.85},
                                      {"jump_long_standing_dm", 0.9},
                                      {"jump_hop_forward_cmu01_01", 0.9},
                                      {"jump_up_cmu02_04", 0.9},
                                      {"idle_cmu01_01", 0.99},
                                      {"run_dm", 0.75}}) {
        if (mocapNames().empty()) return;
        const Clip clip = retargeted(name);
        double same = 0.0, all = 0.0;
        for (const auto& [limb, key] : {std::pair{Limb::LeftFoot, "L"}, {Limb::RightFoot, "R"}}) {
            for (std::size_t f = 0; f < clip.poses.size(); ++f) {
                const double time = (static_cast<double>(f) + 0.5) / clip.rate;
                bool expected = false;
                for (const auto& span : analysis[name]["contacts"][key])
                    expected = expected || (time >= span[0] && time <= span[1]);
                same += clip.touches(limb, time) == expected ? 1.0 : 0.0;
                all += 1.0;
            }
        }
        CHECK_MESSAGE(same / all >= least, std::string(name), ": ", same / all);
    }
}

TEST_CASE("a foot in contact is where its anchor is") {
    for (const char* name : {"walk_cmu02_01_loop", "run_jog_cmu02_03_loop", "jump_long_standing_dm"}) {
        if (mocapNames().empty()) return;
        const Clip clip = retargeted(name);
        REQUIRE(clip.contacts.size() >= 2);
        for (const Contact& contact : clip.contacts) {
            const double time = 0.5 * (contact.begin + contact.end);
            BodyPose pose;
            clip.sample(time, pose);
            const Travel at = clip.travelAt(time);
            JointTransforms joints;
            jointTransforms(pose, {yawTurn(at.yaw), {at.x, at.y, 0.0f}}, joints);
            CHECK_MESSAGE(
                distance(joints[index(limbJoint(contact.limb))].translation, contact.anchor) < 0.12f, name);
        }
    }
}

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
        HandMade made;
        made.names = names;
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
    HandMade made;
    made.names = {"Hips",     "Spine",      "Head",  "LeftUpLeg", "LeftLeg",
                  "LeftFoot", "RightUpLeg", "Wheel", "RightFoot"};
    const auto motion = parseBvh(made.text(), "x.bvh");
    REQUIRE(motion.ok());
    CHECK(retarget(*motion).status().message().find("RightLeg") != std::string::npos);
    BvhMotion brief = *parseBvh(HandMade{}.text(), "x.bvh");
    brief.frames = 2;
    brief.values.resize(2 * brief.joints.size());
    CHECK(retarget(brief).status().message().find("at least 3") != std::string::npos);
}

TEST_CASE("an even way round a curve is an arc from end to end") {
    rc::check("arcs", [] {
        const double turn = *rc::gen::inRange(-25, 26) / 10.0, radius = 2.0,
                     begin = *rc::gen::inRange(-30, 31) / 10.0;
        RC_PRE(std::fabs(turn) > 0.4);
        std::vector<HipsAt> hips;
        const double side = turn > 0 ? 1.0 : -1.0;
        for (int i = 0; i <= 40; ++i) {
            const double facing = begin + turn * i / 40.0;
            // On a circle to the left or right.
            hips.push_back({radius * side * sine(facing), -radius * side * cosine(facing), facing});
        }
        std::vector<Travel> travel = evenTravel(hips);
        for (std::size_t i = 0; i < travel.size(); ++i) {
            RC_ASSERT(std::fabs(travel[i].x - hips[i].x) < 1e-4);
            RC_ASSERT(std::fabs(travel[i].y - hips[i].y) < 1e-4);
            RC_ASSERT(std::fabs(travel[i].yaw - hips[i].facing) < 1e-4);
        }
        fromStart(travel);
        RC_ASSERT(std::fabs(travel.back().yaw - turn) < 1e-4);
        RC_ASSERT(std::fabs(travel.back().x - radius * std::fabs(sine(turn))) < 1e-3 ||
                  std::fabs(turn) > kPi / 2);
    });
}

TEST_CASE("a smoothed way keeps its ends and a straight even way as it is") {
    std::vector<HipsAt> hips;
    for (int i = 0; i < 50; ++i) hips.push_back({0.1 * i, 0.0, 0.3});
    const auto straight = smoothTravel(hips, 60.0, 0.5);
    for (int i = 0; i < 50; ++i) CHECK(straight[static_cast<std::size_t>(i)].x == doctest::Approx(0.1 * i));
    for (int i = 0; i < 50; ++i) hips[static_cast<std::size_t>(i)].y = i % 2 ? 0.02 : -0.02;
    const auto calm = smoothTravel(hips, 60.0, 0.5);
    CHECK(calm.front().y == doctest::Approx(-0.02));
    CHECK(calm.back().y == doctest::Approx(0.02));
    for (std::size_t i = 16; i < 34; ++i) CHECK(std::fabs(calm[i].y) < 0.002f);
}
