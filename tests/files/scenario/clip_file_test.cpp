// Facts of clips that come from their files.
#include <doctest.h>

#include <unistd.h>

#include "base/text_file.h"
#include "muster/scenario.h"
#include "people/clips/clip_samples.h"
#include "temporary_folder.h"

using namespace muster;
using muster::testing::HandMade;

namespace {

/// A folder with walk.bvh (1 m per frame, 20 frames per second: at first 2 m in 0.1 s) and the files that a
/// test adds.
struct Folder : muster::testing::TemporaryFolder {
    Folder() : TemporaryFolder("clip_file") {}
};

std::string scenario(const std::string& clips) {
    return R"({"format": "muster-scenario", "version": 1, "clips": [)" + clips + "]}";
}

/// Three frames, a second and a metre apart.
std::string walking(const char* frameTime) {
    HandMade made{.motion = std::string("Frames: 3\nFrame Time: ") + frameTime + "\n"};
    return made.text();
}

}  // namespace

TEST_CASE("a clip takes from its file the facts that it does not give itself") {
    const Folder folder;
    folder.put("run.bvh", walking("0.5"));          // 2 m in 1 s.
    folder.put("clips/crawl.bvh", walking("2.5"));  // 2 m in 5 s.
    const auto def = parseScenario(
        scenario(R"({"name": "run", "file": "run.bvh"}, {"name": "crawl", "file": "clips/crawl.bvh"},
        {"name": "slow", "file": "clips/crawl.bvh", "speed": 0.1, "cyclic": true}, {"name": "own", "speed": 0.7})"),
        "x.json", folder.base.string());
    REQUIRE_MESSAGE(def.ok(), def.status().message());
    REQUIRE(def->clips.size() == 4);
    CHECK(def->clips[0].speed == 1.0);
    CHECK(def->clips[0].length == doctest::Approx(2.0));
    CHECK(def->clips[0].duration == doctest::Approx(1.0));
    CHECK_FALSE(def->clips[0].cyclic);
    CHECK(def->clips[1].speed == doctest::Approx(0.2));
    CHECK(def->clips[1].length == doctest::Approx(2.0));
    CHECK(def->clips[1].duration == doctest::Approx(5.0));
    CHECK(def->clips[2].speed == 0.1);
    CHECK(def->clips[2].cyclic);
    CHECK(def->clips[2].duration == doctest::Approx(5.0));
    CHECK(def->clips[3].speed == 0.7);
    // A written scenario contains the facts, so that a take can be read without the files.
    const auto again = parseScenario(writeScenario(*def), "take", {});
    REQUIRE_MESSAGE(again.ok(), again.status().message());
    CHECK(again->clips[1].file == "clips/crawl.bvh");
    CHECK(again->clips[1].speed == def->clips[1].speed);
    CHECK(again->clips[1].length == def->clips[1].length);
}

TEST_CASE("a file of standing gives the least speed; running is Muster's own where no file gives it") {
    const Folder folder;
    folder.put("walk.bvh", walking("1"));  // 1 m/s.
    HandMade standing;
    folder.put("idle.bvh", standing.text().substr(0, standing.text().find("Frames")) +
                               "Frames: 2\nFrame Time: 1\n" +
                               "0 0.95 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n0 0.95 0 0 0 "
                               "0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n");
    const auto def = parseScenario(
        scenario(
            R"({"name": "run"}, {"name": "walk", "file": "walk.bvh"}, {"name": "idle", "file": "idle.bvh"})"),
        "x.json", folder.base.string());
    REQUIRE_MESSAGE(def.ok(), def.status().message());
    CHECK(def->clips[1].speed == doctest::Approx(1.0 / 2.6));
    CHECK(def->clips[2].speed == doctest::Approx(0.02));
    CHECK(def->clips[2].length == 0.0);
}

TEST_CASE("clip files that cannot be read are reported by path") {
    const Folder folder;
    folder.put("bad.bvh", "HIERARCHY\nROOT x\n{\nOFFSET 0 0\n");
    const auto failure = [&](const std::string& clip, const std::string& where) {
        const auto def = parseScenario(scenario(clip), "x.json", where);
        REQUIRE_FALSE(def.ok());
        return def.status().message();
    };
    const std::string here = folder.base.string();
    const auto has = [](const std::string& message, const char* part) {
        CHECK_MESSAGE(message.find(part) != std::string::npos, message);
    };
    has(failure(R"({"name": "a", "file": "bad.bvh"})", here), "x.json: $.clips[0].file: found ");
    has(failure(R"({"name": "a", "file": "bad.bvh"})", here),
        "bad.bvh:5: found the end of the file, expected a coordinate");
    has(failure(R"({"name": "a", "file": "none.bvh"})", here), "none.bvh: cannot be opened");
    has(failure(R"({"name": "a", "file": "../bad.bvh"})", here), "in the scenario's folder");
    has(failure(R"({"name": "a", "file": "/etc/passwd"})", here), "in the scenario's folder");
    has(failure(R"({"name": "a", "file": "bad.bvh"})", ""), "files are not read here");
    // A scenario or take that gives all facts itself may not name a file elsewhere either.
    const std::string figures = R"(, "speed": 1, "length": 0, "duration": 0, "cyclic": true})";
    has(failure(R"({"name": "a", "file": "/etc/passwd")" + figures, ""), "in the scenario's folder");
    has(failure(R"({"name": "a", "file": "clips/../../bad.bvh")" + figures, here),
        "in the scenario's folder");
    CHECK(
        parseScenario(
            scenario(
                R"({"name": "a", "file": "none.bvh", "speed": 1, "length": 0, "duration": 0, "cyclic": true})"),
            "x.json", here)
            .ok());
}

TEST_CASE("a clip with the name of one of Muster's own has its facts, except for those that are given") {
    const auto def = parseScenario(
        scenario(R"({"name": "run"}, {"name": "climb"}, {"name": "swim", "speed": 0.5},
        {"name": "hop"})"),
        "own.json", "");
    REQUIRE_MESSAGE(def.ok(), def.status().message());
    const auto own = defaultClipFacts();
    CHECK(def->clips[0].speed == 1.0);
    CHECK(def->clips[0].length == own[0].length);
    CHECK_FALSE(def->clips[1].cyclic);
    CHECK(def->clips[1].speed == 0.15);
    CHECK(def->clips[2].speed == 0.5);
    CHECK(def->clips[2].transitionTime == own[4].transitionTime);
    CHECK(def->clips[3].length == 0.0);
    CHECK(def->clips[3].cyclic);
}

TEST_CASE("facts that contradict Muster's own survive writing and reading") {
    WorldDef def;
    ClipFacts climb;
    climb.name = "climb";  // It has only the defaults of a bare clip: cyclic, as fast as running.
    def.clips = {defaultClipFacts()[0], climb};
    const auto again = parseScenario(writeScenario(def), "again.json", "");
    REQUIRE_MESSAGE(again.ok(), again.status().message());
    CHECK(again->clips[1].cyclic);
    CHECK(again->clips[1].speed == 1.0);
    CHECK(again->clips[1].duration == 0.0);
    CHECK(again->clips[1].transitionTime == 0.0);
}
