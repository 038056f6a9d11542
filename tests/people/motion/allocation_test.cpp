// After warm-up a step of motion allocates nothing.
#include <doctest.h>

#include "counting_new.h"
#include "people/motion/parade.h"
#include "people/motion/swinging_clips.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("a warm step of motion allocates nothing, nor does a change of who is near") {
    const ClipLibrary clips = swingingClips();
    Parade parade(200);
    CrowdMotion motion(clips);
    std::vector<std::uint32_t> some, others;
    for (std::uint32_t id = 1; id <= 50; ++id) {
        some.push_back(id);
        others.push_back(3 * id);
    }
    const auto steps = [&](int count) {
        for (int k = 0; k < count; ++k) {
            parade.step();
            motion.update(parade.view());
            if (k % 20 == 10) motion.setNear(k % 40 == 10 ? some : others);
        }
    };
    steps(120);
    const long before = allocations;
    CHECK(before > 0);
    steps(300);
    CHECK(allocations == before);
}
