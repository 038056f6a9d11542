// Over a wall, over a low thing: nothing goes through.
#include "people/generator/measure.h"

using namespace muster;
using namespace muster::test;

namespace {

/// How deep a point lies in the clip's obstacle [m]; negative outside.
double depthIn(const Clip& clip, Vec3 p) {
    const double middle = 0.5 * clip.length(), half = 0.5 * clip.obstacle.thickness;
    return std::min({half - std::fabs(p.x - middle), static_cast<double>(clip.obstacle.height) - p.z});
}

/// The deepest of soles, fingers and joints over the clip, and what that is.
struct Deepest {
    double depth = -10.0;  // [m]
    std::string what;

    void add(double depthHere, const std::string& whatHere, double time) {
        if (depthHere <= depth) return;
        depth = depthHere;
        what = whatHere + " at " + std::to_string(time) + " s";
    }
};

Deepest deepest(const Clip& clip, double margin, double from = 0.0) {
    Deepest most;
    for (double time = from; time <= clip.duration(); time += 1.0 / 120.0) {
        const JointTransforms joints = jointsOnGround(clip, time);
        for (std::size_t side = 0; side < 2; ++side) {
            const std::string which = side == 0 ? "left " : "right ";
            for (Vec3 p : soleOf(joints, side)) most.add(depthIn(clip, p), which + "sole", time);
            const float out = side == 0 ? 1.0f : -1.0f;
            most.add(depthIn(clip, joints[sided(JointRole::LeftHand, side)].apply({0.0f, 0.15f * out, 0.0f})),
                     which + "fingers", time);
            for (JointRole role :
                 {JointRole::LeftFoot, JointRole::LeftLeg, JointRole::LeftHand, JointRole::LeftForeArm})
                most.add(depthIn(clip, joints[sided(role, side)].translation) + margin,
                         skeleton()[sided(role, side)].name, time);
        }
        for (JointRole role : {JointRole::Hips, JointRole::Chest, JointRole::Head})
            most.add(depthIn(clip, joints[index(role)].translation) + margin, skeleton()[index(role)].name,
                     time);
    }
    return most;
}

}  // namespace

TEST_CASE(
    "the climber's limbs stay out of the wall, once the runner's hands that come ahead of him are drawn in") {
    const Deepest most = deepest(clipNamed("climb"), 0.02, 0.12);
    CHECK_MESSAGE(most.depth < 0.012, most.what);
}

TEST_CASE("the jumper clears the low thing") {
    const Deepest most = deepest(clipNamed("jump-over"), 0.03);
    CHECK_MESSAGE(most.depth < 0.0, most.what);
}

TEST_CASE("a wall a hand higher would be pierced") {
    Clip clip = clipNamed("climb");
    clip.obstacle.height += 0.1f;
    CHECK(deepest(clip, 0.0).depth > 0.05);
}

TEST_CASE("the climber holds the wall's top with both hands and steps on its face and top") {
    const Clip& climb = clipNamed("climb");
    const double face = 0.5 * climb.length() - 0.5 * climb.obstacle.thickness;
    int hands[2] = {0, 0}, faces = 0, tops = 0;
    for (const Contact& contact : climb.contacts) {
        const bool over = contact.anchor.x > face && contact.anchor.x < face + climb.obstacle.thickness;
        if (contact.limb == Limb::LeftHand || contact.limb == Limb::RightHand) {
            CHECK(over);
            CHECK(contact.anchor.z == doctest::Approx(climb.obstacle.height + 0.045).epsilon(0.02));
            ++hands[contact.limb == Limb::RightHand ? 1 : 0];
        } else if (contact.anchor.z > 1.0f) {
            CHECK(over);
            CHECK(contact.anchor.z == doctest::Approx(climb.obstacle.height + 0.08).epsilon(0.01));
            ++tops;
        } else if (contact.anchor.z > 0.2f) {
            CHECK(contact.anchor.x < face);
            ++faces;
        }
    }
    CHECK(hands[0] >= 1);
    CHECK(hands[1] >= 1);
    CHECK(faces == 1);
    CHECK(tops == 1);
}

TEST_CASE("hands or feet carry the climber until the drop") {
    const Clip& climb = clipNamed("climb");
    double held = 0.0;
    for (double time = 0.0; time < climb.duration(); time += 0.01) {
        bool any = false;
        for (std::size_t limb = 0; limb < kLimbCount; ++limb)
            any = any || climb.touches(static_cast<Limb>(limb), time);
        held += any ? 0.01 : 0.0;
    }
    CHECK(climb.duration() - held < 0.40);
}

TEST_CASE("the tucked jump clears 0.45 m") {
    const Clip& jump = clipNamed("jump");
    double most = 0.0;
    for (int frame = 0; frame < static_cast<int>(jump.poses.size()); ++frame) {
        const JointTransforms joints = jointsAt(jump, frame);
        double low = 10.0;
        for (std::size_t side = 0; side < 2; ++side)
            for (Vec3 p : soleOf(joints, side)) low = std::min(low, static_cast<double>(p.z));
        most = std::max(most, low);
    }
    CHECK(most > 0.45);
}
