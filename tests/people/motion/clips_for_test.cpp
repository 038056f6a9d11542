#include "people/motion/clips_for.h"
#include "test_folders.h"

#include <doctest.h>

#include <filesystem>

#include "muster/own_clips.h"

using namespace muster;

namespace {

std::vector<ClipFacts> withFile(const char* motion, const char* file) {
    std::vector<ClipFacts> facts = defaultClipFacts();
    for (ClipFacts& fact : facts)
        if (fact.name == motion) fact.file = file;
    return facts;
}

}  // namespace

TEST_CASE("without files a world plays Muster's own clips") {
    const auto library = clipsFor(defaultClipFacts(), "nowhere");
    REQUIRE(library.ok());
    CHECK(library->clips.size() == ownClips().clips.size());
}

TEST_CASE("a file takes the place of the clip of its name, and keeps its number") {
    const std::string folder = sourceFolder() + "/../shared/mocap";
    if (!std::filesystem::exists(folder)) {
        MESSAGE("skipped: the recordings are not here");
        return;
    }
    const auto library = clipsFor(withFile("walk", "walk_cmu02_01_loop.bvh"), folder);
    REQUIRE_MESSAGE(library.ok(), library.status().message());
    CHECK(library->indexOf("walk") == ownClips().indexOf("walk"));
    CHECK(library->clips.size() == ownClips().clips.size());
    const Clip& walk = *library->find("walk");
    CHECK(walk.motion == "run");
    CHECK(walk.cyclic);
    CHECK(walk.duration() == doctest::Approx(1.1).epsilon(0.1));
    CHECK(validate(walk).ok());
    const auto more = clipsFor(
        [&] {
            std::vector<ClipFacts> facts = withFile("walk", "");
            facts.push_back({"sneak", "sneak_walk_dm.bvh", 0.3, 0.0, 0.0, true, 0.0});
            return facts;
        }(),
        folder);
    REQUIRE(more.ok());
    CHECK(more->clips.size() == ownClips().clips.size() + 1);
    CHECK(more->clips.back().motion == "sneak");
}

TEST_CASE("a file that is not there is named") {
    const auto library = clipsFor(withFile("duck", "gone.bvh"), "nowhere");
    REQUIRE(!library.ok());
    CHECK(library.status().message().find("duck") != std::string::npos);
    CHECK(library.status().message().find("gone.bvh") != std::string::npos);
}
