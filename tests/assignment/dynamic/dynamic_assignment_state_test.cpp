// What a sparse matching keeps: saved and restored at any step, the same bits for any number of threads.
#include <doctest.h>

#include "assignment/dynamic/assignment_scene.h"
#include "base/archive.h"

namespace {

using muster::DynamicAssignment;
using muster_test::AssignmentScene;

std::uint64_t hashOf(DynamicAssignment& matching) {
    muster::Hasher hasher;
    matching.visit(hasher);
    return hasher.value();
}

AssignmentScene makeScene() {
    AssignmentScene scene(180, 180, 21);
    scene.costs.wall = true;
    scene.usable.assign(180, 1);
    return scene;
}

void advance(AssignmentScene& scene, DynamicAssignment& matching, muster::ThreadPool& pool) {
    scene.usable[scene.random.below(180)] ^= 1;
    scene.step({1.2, 0.1}, 0.05, matching.placeOf());
    matching.update(muster_test::lowThresholds(), scene.input(), scene.costs, pool);
}

}  // namespace

TEST_CASE("a sparse matching that was saved and restored goes on bit for bit") {
    for (const int saved : {0, 1, 7, 50}) {
        AssignmentScene scene = makeScene();
        muster::ThreadPool pool(1);
        DynamicAssignment matching;
        matching.coldStart(muster_test::lowThresholds(), scene.input(), scene.costs, pool);
        for (int k = 0; k < saved; ++k) advance(scene, matching, pool);
        muster::Writer writer;
        matching.visit(writer);
        DynamicAssignment restored;
        muster::Reader reader(writer.bytes());
        restored.visit(reader);
        REQUIRE(reader.ok());
        REQUIRE(reader.remaining() == 0);
        CHECK(hashOf(restored) == hashOf(matching));
        AssignmentScene twin = scene;
        for (int k = 0; k < 80; ++k) {
            advance(scene, matching, pool);
            advance(twin, restored, pool);
            REQUIRE(hashOf(restored) == hashOf(matching));
        }
    }
}

TEST_CASE("a sparse matching is the same for 1, 2, 3 and 8 threads") {
    std::uint64_t expected = 0;
    for (const int threads : {1, 2, 3, 8}) {
        AssignmentScene scene = makeScene();
        muster::ThreadPool pool(threads);
        DynamicAssignment matching;
        matching.coldStart(muster_test::lowThresholds(), scene.input(), scene.costs, pool);
        for (int k = 0; k < 120; ++k) advance(scene, matching, pool);
        if (threads == 1) expected = hashOf(matching);
        CHECK(hashOf(matching) == expected);
    }
}

TEST_CASE("a broken archive is refused") {
    AssignmentScene scene = makeScene();
    muster::ThreadPool pool(1);
    DynamicAssignment matching;
    matching.coldStart(muster_test::lowThresholds(), scene.input(), scene.costs, pool);
    muster::Writer writer;
    matching.visit(writer);
    muster::Random random(3);
    int refused = 0;
    for (int k = 0; k < 300; ++k) {
        std::vector<std::uint8_t> bytes = writer.bytes();
        if (k % 3 == 0)
            bytes.resize(random.below(static_cast<std::uint32_t>(bytes.size())));
        else
            bytes[random.below(k % 3 == 1 ? 2000 : static_cast<std::uint32_t>(bytes.size()))] ^= static_cast<
                std::uint8_t>(1 + random.below(255));
        DynamicAssignment other;
        muster::Reader reader(bytes);
        other.visit(reader);
        refused += reader.ok() ? 0 : 1;
        if (k % 3 == 0) CHECK(!reader.ok());
        // Whatever was read, going on neither crashes nor breaks the rules.
        other.update(muster_test::lowThresholds(), scene.input(), scene.costs, pool);
        CHECK(scene.valid(other.placeOf()));
    }
    CHECK(refused > 150);
}
