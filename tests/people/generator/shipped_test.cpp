// The shipped folder is what the generator makes.
#include "people/clips/clip_files.h"
#include "people/generator/measure.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("motions/ holds our own clips as they are made now") {
    const auto shipped = loadClips(sourceFolder() + "/motions");
    REQUIRE_MESSAGE(shipped.ok(), shipped.status().message());
    CHECK(shipped->clips.size() == ownClips().clips.size());
    for (const Clip& clip : ownClips().clips) {
        const Clip* other = shipped->find(clip.name);
        REQUIRE_MESSAGE(other != nullptr, clip.name);
        REQUIRE(other->poses.size() == clip.poses.size());
        CHECK(other->contacts.size() == clip.contacts.size());
        CHECK(other->entryPhase == doctest::Approx(clip.entryPhase));
        double far = 0.0;
        for (double time = 0.0; time < clip.duration(); time += 0.05) {
            const JointTransforms a = jointsOnGround(clip, time), b = jointsOnGround(*other, time);
            for (std::size_t j = 0; j < kJointCount; ++j)
                far = std::max(far, static_cast<double>(distance(a[j].translation, b[j].translation)));
        }
        CHECK_MESSAGE(far < 1e-3, clip.name << " differs by " << far << " m: write the folder anew");
    }
}
