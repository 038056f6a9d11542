// Drawn bodies do not lie in each other in the scenes X4 to X6, where people duck, jump, climb, crawl and
// swim.
#include <doctest.h>

#include "muster/own_clips.h"
#include "muster/scenario.h"
#include "people/motion/body_overlap.h"
#include "test_folders.h"

using namespace muster;

namespace {

double deepestIn(const char* name, bool lengths, std::int32_t count = 0) {
    const std::string path = sourceFolder() + "/scenarios/paper/" + name + ".json";
    WorldDef def = loadScenario(path).value();
    if (count > 0) def.groups[0].count = count;
    if (!lengths)
        for (ClipFacts& clip : def.clips) clip.reachAhead = clip.reachBehind = 0.0;
    const std::vector<Command> touches = loadScenarioGestures(path, def).value();
    World world = World::create(def).value();
    for (const Command& command : touches) REQUIRE(world.submit(command).ok());
    CrowdMotion motion(ownClips());
    BodyOverlapReport report;
    const std::uint32_t end = touches.back().step + 600;
    while (world.stepCount() < end) {
        world.step();
        motion.update(world);
        report.observe(world, motion);
    }
    return report.deepest();
}

}  // namespace

TEST_CASE("in X4 to X6 no two bodies overlap by more than 11 cm at torso and head") {
    for (const char* name : {"x04-woodland", "x05-traffic", "x06-course"}) {
        CAPTURE(name);
        CHECK(deepestIn(name, true) <= 1.1 * kDeepOverlap);
    }
    CHECK(deepestIn("x06-course", true, 60) <= 1.1 * kDeepOverlap);
}

TEST_CASE("without lengths of bodies they would") {
    CHECK(deepestIn("x06-course", false) > 0.15);
}
