// Groups that walk in manners of their own.
#include <doctest.h>

#include <set>
#include <string>

#include "muster/own_clips.h"
#include "people/motion/crowd_scene.h"
#include "people/motion/motion_report.h"
#include "people/motion/parade.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// The names of the gaits that a parade of forty plays in twenty seconds, with the set changed half-way.
std::set<std::string> gaitsOf(std::optional<MotionSet> first, std::optional<MotionSet> second) {
    Parade parade(40);
    CrowdMotion motion(ownClips());
    std::set<std::string> played;
    for (int s = 0; s < 1200; ++s) {
        parade.step();
        CrowdView view = parade.view();
        const std::optional<MotionSet> set = s < 600 ? first : second;
        view.motionSets = std::span(&set, 1);
        motion.update(view);
        if (s % 600 < 60) continue;  // The first second of a manner is not counted.
        for (const MotionState& state : motion.states()) {
            const Clip& clip = ownClips().clips[state.clip];
            if (clip.cyclic && clip.speed() > 0.0) played.insert(clip.name);
        }
    }
    return played;
}

bool begins(const std::string& name, const char* word) {
    return name.rfind(word, 0) == 0;
}

}  // namespace

TEST_CASE("who marches plays the gaits of marching, and nobody else does") {
    for (const std::string& name : gaitsOf(MotionSet::March, MotionSet::March))
        CHECK_MESSAGE(begins(name, "march-"), name);
    for (const std::string& name : gaitsOf({}, {})) {
        CHECK_MESSAGE(!begins(name, "march-"), name);
        CHECK_MESSAGE(!begins(name, "weary-"), name);
    }
    CHECK(gaitsOf(MotionSet::Weary, MotionSet::Weary).count("weary-jog") == 1);
}

TEST_CASE("a change of the manner shows within a second") {
    const auto both = gaitsOf(MotionSet::March, MotionSet::Weary);
    for (const std::string& name : both)
        CHECK_MESSAGE((begins(name, "march-") || begins(name, "weary-")), name);
    CHECK(both.count("march-jog") == 1);
    CHECK(both.count("weary-jog") == 1);
}

TEST_CASE("plain walking is the same with and without the other manners") {
    ClipLibrary plain;
    for (const Clip& clip : ownClips().clips)
        if (!clip.set) plain.clips.push_back(clip);
    CHECK(plain.clips.size() < ownClips().clips.size());
    Parade parade(24);
    CrowdMotion all(ownClips()), few(plain);
    for (int s = 0; s < 900; ++s) {
        parade.step();
        all.update(parade.view());
        few.update(parade.view());
        for (std::size_t i = 0; i < 24; ++i) {
            REQUIRE(ownClips().clips[all.states()[i].clip].name == plain.clips[few.states()[i].clip].name);
            REQUIRE(all.states()[i].time == few.states()[i].time);
        }
    }
}

TEST_CASE("a library without gaits of a manner plays plain ones") {
    ClipLibrary plain;
    for (const Clip& clip : ownClips().clips)
        if (!clip.set) plain.clips.push_back(clip);
    Parade parade(10);
    CrowdMotion motion(plain), marching(plain);
    const std::optional<MotionSet> set = MotionSet::March;
    for (int s = 0; s < 300; ++s) {
        parade.step();
        motion.update(parade.view());
        CrowdView view = parade.view();
        view.motionSets = std::span(&set, 1);
        marching.update(view);
        for (std::size_t i = 0; i < 10; ++i) REQUIRE(motion.states()[i].clip == marching.states()[i].clip);
    }
}

TEST_CASE("feet of every manner keep where they touch") {
    for (const MotionSet set : {MotionSet::March, MotionSet::Weary}) {
        WorldDef def = field(25);
        def.groups[0].motions = set;
        World world = World::create(def).value();
        CrowdMotion motion(ownClips());
        MotionReport report;
        carry(world, {0, 0}, {8, 0});
        run(world, motion, report, 9.0);
        CHECK(report.figures().contacts > 200);
        checkFeet(report.figures());
    }
}
