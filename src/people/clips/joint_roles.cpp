#include "people/clips/retarget.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "people/clips/bvh_scanner.h"

namespace muster {
namespace {

/// Parts of a body recognised by name, before the hierarchy is considered.
enum class Part { None, Hips, Spine, Neck, Head, Shoulder, Arm, ForeArm, Hand, Hip, UpLeg, Leg, Foot, Toe };

struct PartName {
    std::string_view name;
    Part part;
};

// Names without side, digits and separators.
constexpr PartName kPartNames[] = {
    {"hips", Part::Hips},         {"hip", Part::Hip},
    {"pelvis", Part::Hips},       {"spine", Part::Spine},
    {"lowerback", Part::Spine},   {"upperback", Part::Spine},
    {"thorax", Part::Spine},      {"chest", Part::Spine},
    {"upperchest", Part::Spine},  {"lowerchest", Part::Spine},
    {"abdomen", Part::Spine},     {"torso", Part::Spine},
    {"back", Part::Spine},        {"waist", Part::Spine},
    {"ribs", Part::Spine},        {"spinelower", Part::Spine},
    {"spineupper", Part::Spine},  {"lowerspine", Part::Spine},
    {"upperspine", Part::Spine},  {"spinemid", Part::Spine},
    {"neck", Part::Neck},         {"lowerneck", Part::Neck},
    {"upperneck", Part::Neck},    {"head", Part::Head},
    {"shoulder", Part::Shoulder}, {"clavicle", Part::Shoulder},
    {"collar", Part::Shoulder},   {"collarbone", Part::Shoulder},
    {"arm", Part::Arm},           {"upperarm", Part::Arm},
    {"uparm", Part::Arm},         {"humerus", Part::Arm},
    {"shldr", Part::Arm},         {"forearm", Part::ForeArm},
    {"lowerarm", Part::ForeArm},  {"lowarm", Part::ForeArm},
    {"elbow", Part::ForeArm},     {"radius", Part::ForeArm},
    {"hand", Part::Hand},         {"wrist", Part::Hand},
    {"upleg", Part::UpLeg},       {"thigh", Part::UpLeg},
    {"femur", Part::UpLeg},       {"upperleg", Part::UpLeg},
    {"leg", Part::Leg},           {"lowerleg", Part::Leg},
    {"lowleg", Part::Leg},        {"knee", Part::Leg},
    {"calf", Part::Leg},          {"shin", Part::Leg},
    {"tibia", Part::Leg},         {"foot", Part::Foot},
    {"ankle", Part::Foot},        {"toe", Part::Toe},
    {"toes", Part::Toe},          {"toebase", Part::Toe},
    {"ball", Part::Toe},
};

Part partNamed(std::string_view name) {
    for (const PartName& known : kPartNames)
        if (known.name == name) return known.part;
    return Part::None;
}

bool isSeparator(char c) {
    return c == '_' || c == '.' || c == '-' || c == ' ';
}

/// The letters of a text in lower case.
std::string lettersOf(std::string_view text) {
    std::string letters;
    for (const char c : lowered(text))
        if (c >= 'a' && c <= 'z') letters += c;
    return letters;
}

struct Named {
    Part part = Part::None;
    int side = 0;  ///< Side: 1 for left, -1 for right, 0 for neither.
};

bool takeOut(std::string& text, std::string_view what) {
    const std::size_t at = text.find(what);
    if (at == std::string::npos) return false;
    text.erase(at, what.size());
    return true;
}

/// Removes and returns a side given as a separate letter: "l_thigh", "thigh.L", "Bip01 L Thigh".
int takeSideLetter(std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != 'l' && text[i] != 'r') continue;
        const bool before = i == 0 || isSeparator(text[i - 1]),
                   after = i + 1 == text.size() || isSeparator(text[i + 1]);
        if (!before || !after) continue;
        const int side = text[i] == 'l' ? 1 : -1;
        text.erase(i, 1);
        return side;
    }
    return 0;
}

/// The name without namespace ("mixamorig:LeftLeg") and other usual prefixes.
std::string bareName(std::string_view name) {
    const std::size_t colon = name.find_last_of(":|");
    if (colon != std::string_view::npos && colon + 1 < name.size()) name.remove_prefix(colon + 1);
    std::string bare = lowered(name);
    for (const std::string_view prefix : {"mixamorig", "bip001", "bip01", "bip", "character1", "def-", "def_",
                                          "valvebiped.bip", "j_", "jnt_"}) {
        if (bare.size() > prefix.size() && bare.compare(0, prefix.size(), prefix) == 0)
            bare.erase(0, prefix.size());
    }
    return bare;
}

Named partOf(std::string_view name) {
    std::string bare = bareName(name);
    Named found;
    if (takeOut(bare, "left"))
        found.side = 1;
    else if (takeOut(bare, "right"))
        found.side = -1;
    else
        found.side = takeSideLetter(bare);
    const std::string letters = lettersOf(bare);
    found.part = partNamed(letters);
    if (found.part == Part::None && found.side == 0 && letters.size() > 2 &&
        (letters[0] == 'l' || letters[0] == 'r')) {
        found.part = partNamed(std::string_view(letters).substr(1));
        if (found.part != Part::None) found.side = letters[0] == 'l' ? 1 : -1;
    }
    if (found.part == Part::Hip) found.part = found.side == 0 ? Part::Hips : Part::UpLeg;
    return found;
}

class Finder {
public:
    explicit Finder(std::span<const BvhJoint> joints) : joints_(joints) {
        roles_.fill(-1);
        for (const BvhJoint& joint : joints) named_.push_back(partOf(joint.name));
    }

    RoleJoints find() {
        for (const int side : {1, -1}) findLimbs(side);
        role(JointRole::Hips) = findHips();
        role(JointRole::Head) = first(Part::Head, 0);
        role(JointRole::Neck) = first(Part::Neck, 0);
        findSpine();
        return roles_;
    }

private:
    std::int32_t& role(JointRole r) { return roles_[index(r)]; }

    std::int32_t first(Part part, int side) const {
        for (std::size_t i = 0; i < named_.size(); ++i)
            if (named_[i].part == part && named_[i].side == side) return static_cast<std::int32_t>(i);
        return -1;
    }

    bool isBelow(std::int32_t joint, std::int32_t ancestor) const {
        for (; joint >= 0; joint = joints_[joint].parent)
            if (joint == ancestor) return true;
        return false;
    }

    void findLimbs(int side) {
        const bool left = side > 0;
        std::int32_t arm = first(Part::Arm, side), shoulder = first(Part::Shoulder, side);
        if (arm < 0) {
            // A "LeftShoulder" directly above an elbow is the upper arm; a collar bone may be above it.
            for (std::size_t i = 0; i < named_.size(); ++i)
                if (named_[i].part == Part::Shoulder && named_[i].side == side)
                    arm = static_cast<std::int32_t>(i);
            if (arm == shoulder) shoulder = -1;
        }
        role(left ? JointRole::LeftShoulder : JointRole::RightShoulder) = shoulder;
        role(left ? JointRole::LeftArm : JointRole::RightArm) = arm;
        role(left ? JointRole::LeftForeArm : JointRole::RightForeArm) = first(Part::ForeArm, side);
        role(left ? JointRole::LeftHand : JointRole::RightHand) = first(Part::Hand, side);
        std::int32_t upLeg = first(Part::UpLeg, side), leg = first(Part::Leg, side);
        if (upLeg < 0 && leg >= 0) {
            // If there is a "Knee" or "Shin" too, the "Leg" is the thigh.
            for (std::size_t i = static_cast<std::size_t>(leg) + 1; i < named_.size(); ++i) {
                if (named_[i].part != Part::Leg || named_[i].side != side) continue;
                upLeg = std::exchange(leg, static_cast<std::int32_t>(i));
                break;
            }
        }
        role(left ? JointRole::LeftUpLeg : JointRole::RightUpLeg) = upLeg;
        role(left ? JointRole::LeftLeg : JointRole::RightLeg) = leg;
        role(left ? JointRole::LeftFoot : JointRole::RightFoot) = first(Part::Foot, side);
        role(left ? JointRole::LeftToeBase : JointRole::RightToeBase) = first(Part::Toe, side);
    }

    /// Finds the hips by name, else as the common parent of both legs.
    std::int32_t findHips() {
        const std::int32_t named = first(Part::Hips, 0), left = role(JointRole::LeftUpLeg),
                           right = role(JointRole::RightUpLeg);
        if (left < 0 || right < 0) return named;
        if (named >= 0 && isBelow(left, named) && isBelow(right, named)) return named;
        std::int32_t joint = joints_[left].parent;
        while (joint >= 0 && !isBelow(right, joint)) joint = joints_[joint].parent;
        return joint;
    }

    /// Finds the chain from the hips to the joint where neck and shoulders branch. The last joint is the
    /// chest, one below it the spine.
    void findSpine() {
        std::int32_t end = role(JointRole::Neck) >= 0 ? role(JointRole::Neck) : role(JointRole::Head);
        if (end < 0)
            end = role(JointRole::LeftShoulder) >= 0 ? role(JointRole::LeftShoulder)
                                                     : role(JointRole::LeftArm);
        if (end < 0 || role(JointRole::Hips) < 0) return;
        std::vector<std::int32_t> chain;
        for (std::int32_t joint = joints_[end].parent; joint >= 0 && joint != role(JointRole::Hips);
             joint = joints_[joint].parent)
            chain.push_back(joint);
        if (chain.empty() || !isBelow(chain.back(), role(JointRole::Hips))) return;
        role(JointRole::Chest) = chain.front();
        if (chain.size() > 1) role(JointRole::Spine) = chain.back();
    }

    std::span<const BvhJoint> joints_;
    std::vector<Named> named_;
    RoleJoints roles_{};
};

}  // namespace

RoleJoints findRoles(std::span<const BvhJoint> joints) {
    return Finder(joints).find();
}

Status hasBody(const RoleJoints& roles) {
    for (const JointRole role :
         {JointRole::Hips, JointRole::LeftUpLeg, JointRole::RightUpLeg, JointRole::LeftLeg,
          JointRole::RightLeg, JointRole::LeftFoot, JointRole::RightFoot}) {
        if (roles[index(role)] < 0)
            return {StatusCode::Unsupported,
                    std::string("found no joint that could be ") + skeleton()[index(role)].name};
    }
    return {};
}

}  // namespace muster
