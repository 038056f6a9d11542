#include "people/clips/retarget.h"
#include "base/maths.h"

#include <doctest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "base/text_file.h"
#include "people/clips/bvh_axes.h"
#include "people/clips/clip_samples.h"
#include "people/clips/forward.h"

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
    const auto place = [&](JointRole role) { return theirs[roles[index(role)]].translation; };
    const Vec3 a = place(JointRole::LeftLeg) - place(JointRole::LeftUpLeg);
    const Vec3 b = ours[index(JointRole::LeftLeg)].translation -
                   ours[index(JointRole::LeftUpLeg)].translation;
    return yawTurn(arcTangent2(b.y, b.x) - arcTangent2(a.y, a.x));
}

/// The same motion with another frame for every joint, turned by `turns` against its own.
BvhMotion reframed(const BvhMotion& motion, const std::vector<Quat>& turns) {
    BvhMotion other = motion;
    for (std::size_t j = 0; j < motion.joints.size(); ++j) {
        const std::int32_t parent = motion.joints[j].parent;
        const Quat above = parent < 0 ? Quat{} : conjugate(turns[parent]);
        if (parent >= 0) other.joints[j].offset = rotate(above, motion.joints[j].offset);
        for (Vec3& end : other.joints[j].ends) end = rotate(conjugate(turns[j]), end);
        for (std::size_t f = 0; f < motion.frames; ++f) {
            Transform& value = other.values[f * motion.joints.size() + j];
            value = {normalized(above * value.rotation * turns[j]),
                     parent < 0 ? value.translation : rotate(above, value.translation)};
        }
    }
    return other;
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
                const auto place = [&](JointRole role) { return theirs[roles[index(role)]].translation; };
                const Vec3 their = rotate(turn, normalized(place(to) - place(from)));
                const Vec3 our = normalized(ours[index(to)].translation - ours[index(from)].translation);
                REQUIRE_MESSAGE(distance(their, our) < 0.02f, name, " frame ", f, " ",
                                skeleton()[index(from)].name);
            }
        }
    }
}

TEST_CASE("files whose rest pose is none give the same motion") {
    // Every joint gets another frame of its own at random: the same motion, with a rest pose that nobody can
    // take.
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    for (const char* name : {"walk_cmu02_01_loop", "run_dm", "climb_stepladder_cmu01_02"}) {
        if (mocapNames().empty()) return;
        const BvhMotion motion = recording(name);
        std::vector<Quat> turns;
        for (std::size_t j = 0; j < motion.joints.size(); ++j)
            turns.push_back(normalized(Quat{any(random), any(random), any(random), any(random)}));
        const BvhMotion scrambled = reframed(motion, turns);
        const auto plain = retarget(motion), other = retarget(scrambled);
        REQUIRE(plain.ok());
        REQUIRE(other.ok());
        CHECK(plain->cyclic == other->cyclic);
        CHECK(plain->length() == doctest::Approx(other->length()).epsilon(0.02));
        for (std::size_t f = 0; f < plain->poses.size(); f += 11) {
            JointTransforms a, b;
            jointTransforms(plain->poses[f], {}, a);
            jointTransforms(other->poses[f], {}, b);
            for (std::size_t j = 0; j < kJointCount; ++j)
                REQUIRE_MESSAGE(distance(a[j].translation, b[j].translation) < 0.15f, name, " frame ", f, " ",
                                skeleton()[j].name);
            // Nobody's chest, hips, knees or elbows face another way.
            for (const JointRole role :
                 {JointRole::Hips, JointRole::Chest, JointRole::LeftLeg, JointRole::RightForeArm})
                REQUIRE_MESSAGE(angleBetween(a[index(role)].rotation, b[index(role)].rotation) < 0.9, name,
                                " frame ", f, " ", skeleton()[index(role)].name);
        }
    }
}

TEST_CASE("axes are found where all bones lie along one axis in the rest pose") {
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        if (mocapNames().empty()) return;
        const BvhMotion motion = recording("walk_cmu02_01_loop");
        std::vector<Quat> turns(motion.joints.size());
        for (std::size_t j = motion.joints.size(); j-- > 1;) {
            const Vec3 along = normalized(motion.joints[j].offset);
            if (lengthSquared(along) > 0.0f) turns[motion.joints[j].parent] = shortestArc(axis, along);
        }
        const BvhMotion other = reframed(motion, turns);
        const AxisMap axes = guessAxes(other.joints, other.frame(0));
        CHECK(axes.up == Vec3{0, 0, 1});
        CHECK(axes.left == Vec3{0, 1, 0});
        CHECK(axes.forward == Vec3{1, 0, 0});
        CHECK(guessUnit(other.joints).value() == 1.0);
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
            seam = std::max(seam,
                            angleBetween(clip.poses.front().rotation[j], clip.poses.back().rotation[j]));
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
