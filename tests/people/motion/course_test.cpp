// Muster's own clips over a small course: wall, hurdle, branches, net, pool, and what the measures say of it.
#include <doctest.h>

#include "muster/own_clips.h"
#include "people/motion/crowd_scene.h"
#include "people/motion/swinging_clips.h"

using namespace muster;
using namespace muster::testing;

namespace {

PatchDef strip(double from, double to, MotionId motion) {
    return {.polygon = {{from, -8}, {to, -8}, {to, 8}, {from, 8}}, .motion = motion};
}

/// The lowest that any wrist gets above a wall's top while it is held there [m], and how often one is held.
struct Hands {
    double lowest = 1.0;
    double highest = -1.0;
    int locked = 0;
};

void watchHands(const CrowdMotion& motion, Hands& hands) {
    for (std::size_t k = 0; k < motion.near().size(); ++k) {
        const MotionState& state = motion.states()[motion.near()[k]];
        if (motion.library().clips[state.clip].motion != "climb") continue;
        JointTransforms joints;
        worldJoints(state, motion.pose(k), joints);
        for (const Limb limb : {Limb::LeftHand, Limb::RightHand}) {
            if (!motion.locked(k, limb)) continue;
            const double above = static_cast<double>(joints[index(limbJoint(limb))].translation.z) - 1.3;
            hands.lowest = std::min(hands.lowest, above);
            hands.highest = std::max(hands.highest, above);
            ++hands.locked;
        }
    }
}

}  // namespace

TEST_CASE("a course with Muster's own clips: feet stand, knees bend smoothly, hands are on the wall") {
    WorldDef def = field(9);
    def.box = {{-12, -10}, {40, 10}};
    def.patches = {strip(4, 5.2, 6), strip(9, 11.1, 5), strip(14, 16, 2), strip(18, 20, 3), strip(23, 26, 4)};
    World world = World::create(def).value();
    CrowdMotion motion(ownClips());
    MotionReport report;
    Hands hands;
    carry(world, {0, 0}, {31, 0});
    run(world, motion, report, 45.0, [&] { watchHands(motion, hands); });
    const MotionFigures f = report.figures();
    CHECK(world.characters().position[4].x > 28.0);  // They have come through.
    CHECK(f.contacts > 300);
    checkFeet(f);
    CHECK(f.rateLeast >= 0.699);
    CHECK(f.rateMost <= 1.301);
    CHECK(f.singleSteps == 18);
    CHECK(f.actions == f.singleSteps);
    CHECK(hands.locked > 100);
    CHECK(hands.lowest > -0.02);
    CHECK(hands.highest < 0.12);
    MESSAGE("measured: wrists ", hands.lowest, " to ", hands.highest, " m above the wall");
}
