// From a body to the world.
#include <doctest.h>

#include "base/maths.h"
#include "muster/motion.h"

using namespace muster;

TEST_CASE("joints stand in the world as the body is put there: scaled, turned, moved") {
    MotionState state{.position = {10.0, -4.0}, .yaw = static_cast<float>(kPi / 2), .size = 1.04f};
    JointTransforms joints;
    worldJoints(state, restPose(), joints);
    const Vec3 hips = joints[index(JointRole::Hips)].translation;
    CHECK(hips.x == doctest::Approx(10.0));
    CHECK(hips.y == doctest::Approx(-4.0));
    CHECK(hips.z == doctest::Approx(0.95 * 1.04));
    // Facing +y, its left hand is at -x and its toes ahead.
    const Vec3 hand = joints[index(JointRole::LeftHand)].translation;
    CHECK(hand.x == doctest::Approx(10.0 - 1.04 * (0.03 + 0.15 + 0.28 + 0.25)));
    CHECK(hand.y == doctest::Approx(-4.0).epsilon(1e-5));
    const Vec3 toe = joints[index(JointRole::RightToeBase)].translation;
    CHECK(toe.y == doctest::Approx(-4.0 + 1.04 * 0.13));
    CHECK(toe.x == doctest::Approx(10.0 + 1.04 * 0.09));
    // A joint's frame turns with the body.
    const Vec3 ahead = rotate(joints[index(JointRole::Head)].rotation, {1.0f, 0.0f, 0.0f});
    CHECK(ahead.y == doctest::Approx(1.0));
}

TEST_CASE("near ones are those named, from the next update on") {
    CrowdMotionDef def;
    CHECK(def.allNear);
    const ClipLibrary nothing;
    CrowdMotion motion(nothing, def);
    CHECK(motion.states().empty());
    CHECK(motion.near().empty());
    CHECK(&motion.library() == &nothing);
}
