#include "people/motion/motion_report.h"

#include <doctest.h>

#include "people/motion/crowd_scene.h"
#include "people/motion/swinging_clips.h"

using namespace muster;
using namespace muster::testing;

namespace {

MotionFigures figuresOf(const ClipLibrary& clips) {
    World world = World::create(field(9)).value();
    CrowdMotion motion(clips);
    MotionReport report;
    carry(world, {0, 0}, {8, 0});
    run(world, motion, report, 8.0);
    return report.figures();
}

}  // namespace

TEST_CASE("clips that skate are found out, with contacts and without") {
    const MotionFigures good = figuresOf(swingingClips());
    ClipLibrary skating = swingingClips();
    for (Clip& clip : skating.clips) clip.contacts.clear();  // Nothing is held any more...
    for (Clip& clip : skating.clips)
        for (Travel& travel : clip.travel) travel.x *= 0.5f;  // ... and steps are too short by half.
    const MotionFigures bad = figuresOf(skating);
    CHECK(bad.contacts == 0);
    CHECK(good.lowFast < 0.1);
    CHECK(bad.lowFast > 3.0 * good.lowFast);
    CHECK(bad.lowSpeed95 > good.lowSpeed95);
}

TEST_CASE("clips that sink are found out") {
    ClipLibrary sinking = swingingClips();
    for (Clip& clip : sinking.clips) {
        clip.contacts.clear();
        for (BodyPose& pose : clip.poses) {
            pose.hips.z -= 0.05f;
            pose.rotation[index(JointRole::LeftArm)] = axisAngle({1.0f, 0.0f, 0.0f}, -1.5);
            pose.hips.z -= 0.75f;
        }
    }
    CHECK(figuresOf(swingingClips()).penetration < 0.01);
    CHECK(figuresOf(sinking).penetration > 0.05);
}

TEST_CASE("nothing seen, nothing said") {
    const MotionFigures f = MotionReport().figures();
    CHECK(f.bodySteps == 0);
    CHECK(f.slide95 == 0.0);
    CHECK(f.kneeMax == 0.0);
}

TEST_CASE("without clips everybody stands in the rest pose") {
    World world = World::create(field(4)).value();
    const ClipLibrary none;
    CrowdMotion motion(none);
    world.step();
    motion.update(world);
    REQUIRE(motion.states().size() == 4);
    REQUIRE(motion.near().size() == 4);
    CHECK(motion.pose(0).hips == restPose().hips);
    CHECK(motion.states()[2].position == world.characters().position[2]);
}

TEST_CASE("who is near is as named, and keeps its state when others come") {
    World world = World::create(field(16)).value();
    const ClipLibrary clips = swingingClips();
    CrowdMotion named(clips), all(clips);
    const std::span<const std::uint32_t> ids = world.characters().id;
    const std::vector<std::uint32_t> few{ids[3], ids[7]}, more{ids[9], ids[7], ids[3], 123456u};
    named.setNear(few);
    for (int k = 0; k < 90; ++k) {
        if (k == 45) named.setNear(more);
        world.step();
        named.update(world);
        all.update(world);
    }
    REQUIRE(named.near().size() == 3);
    CHECK(named.near()[0] == 3);
    CHECK(named.near()[2] == 9);
    CHECK(named.pose(1).hips == all.pose(7).hips);
    CHECK(named.pose(1).rotation == all.pose(7).rotation);
    named.setNear({});
    named.update(world);
    CHECK(named.near().empty());
}
