// How deep drawn bodies lie in each other.
#include "people/motion/body_overlap.h"

#include <doctest.h>

#include "base/random.h"
#include "muster/own_clips.h"

using namespace muster;

namespace {

SolidBody upright(Vec2 at) {
    MotionState state{.position = at};
    JointTransforms joints;
    worldJoints(state, restPose(), joints);
    return solidBody(joints, 1.0f);
}

// The least distance of two torsos and heads by trying many points of their axes.
double overlapBySampling(const SolidBody& a, const SolidBody& b) {
    struct Ball {
        Vec3 at;
        double radius;
    };
    const auto balls = [](const SolidBody& body) {
        std::vector<Ball> all{{body.head, 0.10}};
        for (const auto* half : {&body.left, &body.right})
            for (int k = 0; k <= 200; ++k)
                all.push_back(
                    {(*half)[0] + ((*half)[1] - (*half)[0]) * (static_cast<float>(k) / 200.0f), 0.12});
        return all;
    };
    double deepest = -1e9;
    for (const Ball& p : balls(a))
        for (const Ball& q : balls(b))
            deepest = std::max(deepest, p.radius + q.radius - static_cast<double>(length(p.at - q.at)));
    return deepest;
}

}  // namespace

TEST_CASE("two who stand overlap by the widths of their torsos") {
    // Halves of torsos are 0.12 m thick and 0.05 m from the middle.
    CHECK(overlapOf(upright({0, 0}), upright({0, 0.30})) == doctest::Approx(0.04).epsilon(1e-3));
    CHECK(overlapOf(upright({0, 0}), upright({0.20, 0})) == doctest::Approx(0.04).epsilon(1e-3));
    CHECK(overlapOf(upright({0, 0}), upright({0.5, 0})) < 0.0);
}

TEST_CASE("overlaps of poses of all clips are those found by sampling") {
    Random random(9);
    const ClipLibrary& clips = ownClips();
    for (int k = 0; k < 60; ++k) {
        SolidBody bodies[2];
        for (SolidBody& body : bodies) {
            const Clip& clip = clips.clips[random.below(static_cast<std::uint32_t>(clips.clips.size()))];
            MotionState state{.position = {random.uniform(-0.4, 0.4), random.uniform(-0.4, 0.4)},
                              .yaw = static_cast<float>(random.uniform(-3, 3))};
            JointTransforms joints;
            worldJoints(state, clip.poses[random.below(static_cast<std::uint32_t>(clip.poses.size()))],
                        joints);
            body = solidBody(joints, 1.0f);
        }
        CHECK(overlapOf(bodies[0], bodies[1]) ==
              doctest::Approx(overlapBySampling(bodies[0], bodies[1])).epsilon(0.01));
        CHECK(overlapOf(bodies[0], bodies[1]) ==
              doctest::Approx(overlapOf(bodies[1], bodies[0])).epsilon(1e-4));
    }
}
