#include "muster/motion.h"

#include <doctest.h>

#include "people/motion/crowd_scene.h"
#include "people/motion/motion_report.h"
#include "people/motion/swinging_clips.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("the clips of these tests are sound") {
    for (const Clip& clip : swingingClips().clips)
        CHECK_MESSAGE(validate(clip).ok(), clip.name, ": ", validate(clip).message());
}

TEST_CASE("a crowd that walks off and stops keeps its feet where they touch") {
    const ClipLibrary clips = swingingClips();
    World world = World::create(field(25)).value();
    CrowdMotion motion(clips);
    MotionReport report;
    carry(world, {0, 0}, {8, 0});
    run(world, motion, report, 9.0);
    const MotionFigures f = report.figures();
    CHECK(f.contacts > 300);
    checkFeet(f);
    CHECK(f.rateLeast >= 0.69);
    CHECK(f.rateMost <= 1.31);
}

TEST_CASE("watching a world changes nothing in it") {
    const ClipLibrary clips = swingingClips();
    World watched = World::create(field(16)).value(), alone = World::create(field(16)).value();
    CrowdMotion motion(clips);
    carry(watched, {0, 0}, {6, 3});
    carry(alone, {0, 0}, {6, 3});
    for (int s = 0; s < 300; ++s) {
        watched.step();
        alone.step();
        motion.update(watched);
        REQUIRE(watched.hash() == alone.hash());
    }
}
