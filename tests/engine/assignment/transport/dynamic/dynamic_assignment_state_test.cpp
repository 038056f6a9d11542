// State of a dynamic assignment: saved and restored at any step, the same bits for any number of threads.
#include <doctest.h>

#include "base/archive.h"
#include "engine/assignment/transport/dynamic/assignment_scene.h"

namespace {

using muster::DynamicAssignment;
using muster_test::AssignmentScene;
using muster_test::lowThresholds;

std::uint64_t hashOf(DynamicAssignment& assignment) {
    muster::Hasher hasher;
    assignment.visit(hasher);
    return hasher.value();
}

AssignmentScene makeScene() {
    AssignmentScene scene(180, 180, 21);
    scene.costs.wall = true;
    scene.usable.assign(180, 1);
    return scene;
}

void advance(AssignmentScene& scene, DynamicAssignment& assignment, muster::ThreadPool& pool) {
    scene.usable[scene.random.below(180)] ^= 1;
    scene.step({1.2, 0.1}, 0.05, assignment.placeOf());
    assignment.update(lowThresholds(), scene.input(), scene.costs, pool);
}

std::vector<std::uint8_t> bytesOf(DynamicAssignment& assignment) {
    muster::Writer writer;
    assignment.visit(writer);
    return {writer.bytes().begin(), writer.bytes().end()};
}

DynamicAssignment restoredFrom(const std::vector<std::uint8_t>& bytes) {
    DynamicAssignment restored;
    muster::Reader reader(bytes);
    restored.visit(reader);
    REQUIRE(reader.ok());
    REQUIRE(reader.remaining() == 0);
    return restored;
}

}  // namespace

TEST_CASE("a dynamic assignment that was saved and restored goes on bit for bit") {
    for (const int saved : {0, 1, 7, 50}) {
        AssignmentScene scene = makeScene();
        muster::ThreadPool pool(1);
        DynamicAssignment assignment;
        assignment.coldStart(lowThresholds(), scene.input(), scene.costs, pool);
        for (int k = 0; k < saved; ++k) advance(scene, assignment, pool);
        DynamicAssignment restored = restoredFrom(bytesOf(assignment));
        CHECK(hashOf(restored) == hashOf(assignment));
        AssignmentScene twin = scene;
        for (int k = 0; k < 80; ++k) {
            advance(scene, assignment, pool);
            advance(twin, restored, pool);
            REQUIRE(hashOf(restored) == hashOf(assignment));
        }
    }
}

TEST_CASE("a dynamic assignment is the same for 1, 2, 3 and 8 threads") {
    std::uint64_t expected = 0;
    for (const int threads : {1, 2, 3, 8}) {
        AssignmentScene scene = makeScene();
        muster::ThreadPool pool(threads);
        DynamicAssignment assignment;
        assignment.coldStart(lowThresholds(), scene.input(), scene.costs, pool);
        for (int k = 0; k < 120; ++k) advance(scene, assignment, pool);
        if (threads == 1) expected = hashOf(assignment);
        CHECK(hashOf(assignment) == expected);
    }
}

TEST_CASE("a start that was saved half way goes on bit for bit, and one that cannot be is refused") {
    AssignmentScene scene = makeScene();
    muster::ThreadPool pool(1);
    muster::DynamicAssignmentDef def = lowThresholds();
    def.startNodes = 50;
    std::vector<std::int32_t> held(180);
    for (std::size_t i = 0; i < held.size(); ++i) held[i] = static_cast<std::int32_t>(i);
    DynamicAssignment assignment;
    assignment.beginFrom(def, scene.input(), held, scene.costs, pool);
    assignment.update(def, scene.input(), scene.costs, pool);
    REQUIRE(assignment.starting());
    std::vector<std::uint8_t> bytes = bytesOf(assignment);
    DynamicAssignment restored = restoredFrom(bytes);
    CHECK(restored.starting());
    AssignmentScene twin = scene;
    for (int k = 0; k < 40; ++k) {
        advance(scene, assignment, pool);
        advance(twin, restored, pool);
        REQUIRE(hashOf(restored) == hashOf(assignment));
    }
    // The fifth number: nodes that are still to be started.
    bytes[16] = bytes[17] = 0xff;
    DynamicAssignment wrong;
    muster::Reader refused(bytes);
    wrong.visit(refused);
    CHECK_FALSE(refused.ok());
}

TEST_CASE("a dynamic assignment that was saved in the middle of a round goes on bit for bit") {
    muster::DynamicAssignmentDef def = lowThresholds();
    def.stepsPerRound = 6;
    AssignmentScene scene(150, 150, 20);
    muster::ThreadPool pool(1);
    DynamicAssignment assignment;
    assignment.coldStart(def, scene.input(), scene.costs, pool);
    for (int k = 0; k < 9; ++k) {
        scene.step({1.0, 0.2}, 0.03, assignment.placeOf());
        scene.usable.assign(150, 1);
        if (k % 2 == 1) scene.usable[15 * k] = 0;
        assignment.update(def, scene.input(), scene.costs, pool);
        muster::Writer writer;
        assignment.visit(writer);
        DynamicAssignment copy;
        muster::Reader reader(writer.bytes());
        copy.visit(reader);
        REQUIRE(reader.ok());
        AssignmentScene twin = scene;
        DynamicAssignment original = assignment;
        for (int n = 0; n < 14; ++n) {
            // Places that close and open change which arcs are evaluated next.
            twin.usable.assign(150, 1);
            if (n % 3 == 1) twin.usable[10 * n] = 0;
            twin.step({1.0, 0.2}, 0.03, original.placeOf());
            original.update(def, twin.input(), twin.costs, pool);
            copy.update(def, twin.input(), twin.costs, pool);
            REQUIRE(std::equal(copy.placeOf().begin(), copy.placeOf().end(), original.placeOf().begin()));
            REQUIRE(copy.dualityGap() == original.dualityGap());
        }
    }
}

TEST_CASE("a broken archive is refused") {
    AssignmentScene scene = makeScene();
    muster::ThreadPool pool(1);
    DynamicAssignment assignment;
    assignment.coldStart(lowThresholds(), scene.input(), scene.costs, pool);
    muster::Writer writer;
    assignment.visit(writer);
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
        other.update(lowThresholds(), scene.input(), scene.costs, pool);
        CHECK(scene.valid(other.placeOf()));
    }
    CHECK(refused > 150);
}
