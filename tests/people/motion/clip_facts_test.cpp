// What simulation knows of Muster's own clips, against the clips themselves.
#include <doctest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "muster/ground.h"
#include "muster/own_clips.h"
#include "people/clips/clip_files.h"
#include "people/clips/clip_samples.h"
#include "people/clips/motion_facts.h"

using namespace muster;

TEST_CASE("the default facts are those of Muster's own clips within 2 %") {
    const Clip* run = ownClips().find("run");
    REQUIRE(run != nullptr);
    for (const ClipFacts& fact : defaultClipFacts()) {
        const Clip* clip = ownClips().find(fact.name);
        REQUIRE_MESSAGE(clip != nullptr, fact.name);
        const MotionFacts own = factsOf(*clip);
        CHECK_MESSAGE(std::fabs(fact.speed / speedRatio(own.speed, run->speed()) - 1.0) < 0.02, fact.name);
        CHECK_MESSAGE(std::fabs(fact.length - own.length) <= 0.02 * own.length, fact.name);
        CHECK_MESSAGE(std::fabs(fact.duration / own.duration - 1.0) < 0.02, fact.name);
        CHECK_MESSAGE(fact.cyclic == own.cyclic, fact.name);
        if (fact.transitionTime == 0.0) continue;
        for (const char* way : {"-enter", "-exit"}) {
            const Clip* transition = ownClips().find(fact.name + way);
            REQUIRE_MESSAGE(transition != nullptr, fact.name, way);
            CHECK_MESSAGE(std::fabs(transition->duration() / fact.transitionTime - 1.0) < 0.02, fact.name,
                          way);
        }
    }
}

TEST_CASE("Muster's own clips come back from their folder within 1e-4") {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("muster_own_clips_" + std::to_string(::getpid()));
    REQUIRE(writeClips(ownClips(), folder.string()).ok());
    const auto read = loadClips(folder.string());
    REQUIRE_MESSAGE(read.ok(), read.status().message());
    REQUIRE(read->clips.size() == ownClips().clips.size());
    for (std::size_t c = 0; c < read->clips.size(); ++c) {
        const Clip &own = ownClips().clips[c], &again = read->clips[c];
        CHECK(own.name == again.name);
        CHECK(own.contacts.size() == again.contacts.size());
        CHECK(muster::testing::differenceOf(own, again).place < 1e-4);
        for (std::size_t f = 0; f < own.poses.size(); ++f)
            for (std::size_t j = 0; j < kJointCount; ++j)
                REQUIRE(std::fabs(dot(own.poses[f].rotation[j], again.poses[f].rotation[j])) > 1.0f - 1e-6f);
        // A file by itself tells the same way and time.
        const auto file = readBvh((folder / (own.name + ".bvh")).string());
        REQUIRE(file.ok());
        CHECK_MESSAGE(std::fabs(factsOf(own).length - factsOf(*file).length) < 1e-4, own.name);
        CHECK_MESSAGE(std::fabs(own.duration() - file->duration()) < 1e-9, own.name);
    }
    std::filesystem::remove_all(folder);
}
