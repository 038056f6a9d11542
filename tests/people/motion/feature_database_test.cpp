#include "people/motion/feature_database.h"

#include <doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "muster/own_clips.h"
#include "people/motion/player.h"
#include "people/motion/swinging_clips.h"

using namespace muster;
using namespace muster::testing;

namespace {

Trajectory straight(float speed) {
    Trajectory trajectory{};
    for (std::size_t h = 0; h < 3; ++h) {
        trajectory[2 * h] = speed * kHorizons[h];
        trajectory[6 + 2 * h] = 1.0f;
    }
    return trajectory;
}

/// True for clips that people play who walk in that manner, by their names: "march-walk"...
bool ofManner(const Clip& clip, std::optional<MotionSet> set) {
    const bool gait = clip.name.find("walk") != std::string::npos ||
                      clip.name.find("jog") != std::string::npos || clip.name.find("run") == 0 ||
                      clip.name == "sprint";
    const bool ends = clip.name.find("st") == 0;  // "start-walk", "stop-walk"
    const bool march = clip.name.find("march-") == 0, weary = clip.name.find("weary-") == 0;
    if (set == MotionSet::March) return march || (!weary && (!gait || ends));
    if (set == MotionSet::Weary) return weary || (!march && (!gait || ends));
    return !march && !weary;
}

bool sought(const ClipTable& table, const FeatureDatabase& base, std::int32_t row, ClipFilter filter) {
    const ClipEntry& entry = table[base.clipOf(row)];
    if (entry.use != ClipUse::Locomotion) return false;
    if (filter != ClipFilter::Any && entry.standing != (filter == ClipFilter::Standing)) return false;
    return entry.cyclic || base.timeOf(row) < entry.duration - 0.25f;
}

/// The nearest row, looked for one by one.
Match slowSearch(const ClipTable& table, const FeatureDatabase& base, std::int32_t rows,
                 const Features& query, ClipFilter filter, std::optional<MotionSet> set) {
    Match best;
    for (std::int32_t row = 0; row < rows; ++row) {
        if (!sought(table, base, row, filter) || !ofManner(*table[base.clipOf(row)].clip, set)) continue;
        const float cost = base.cost(query, row);
        if (best.row < 0 || cost < best.cost) best = {row, cost};
    }
    return best;
}

std::int32_t rowCount(const ClipTable& table, const FeatureDatabase& base) {
    return base.rowOf(table.size() - 1, 1.0e6f) + 1;
}

void compareSearches(const ClipLibrary& library, std::optional<MotionSet> set) {
    const ClipTable table(library);
    const FeatureDatabase base(table);
    const std::int32_t rows = rowCount(table, base);
    CHECK(rc::check("search", [&] {
        const std::int32_t row = *rc::gen::inRange(0, rows);
        Trajectory trajectory = straight(static_cast<float>(*rc::gen::inRange(0, 300)) * 0.01f);
        for (float& number : trajectory) number += static_cast<float>(*rc::gen::inRange(-30, 31)) * 0.01f;
        const Features query = base.query(trajectory, row);
        for (const ClipFilter filter : {ClipFilter::Any, ClipFilter::Going, ClipFilter::Standing}) {
            const Match slow = slowSearch(table, base, rows, query, filter, set);
            const Match fast = base.search(query, filter, set, 1.0e9f);
            RC_ASSERT(fast.row >= 0);
            // Ends of clips are cut a row sooner or later here and there: never a nearer one is missed.
            RC_ASSERT(fast.cost <= slow.cost * 1.0001f + 1.0e-4f);
            RC_ASSERT(std::fabs(base.cost(query, fast.row) - fast.cost) <= 1.0e-3f * (1.0f + fast.cost));
            RC_ASSERT(base.search(query, filter, set, 0.5f * fast.cost).row == -1);
        }
    }));
}

}  // namespace

TEST_CASE("the blockwise search finds what looking at every row finds") {
    compareSearches(swingingClips(), {});
    for (const std::optional<MotionSet> set :
         {std::optional<MotionSet>(), std::optional(MotionSet::March), std::optional(MotionSet::Weary)})
        compareSearches(ownClips(), set);
}

TEST_CASE("a frame is nearest to what it leads to itself") {
    const ClipLibrary library = swingingClips();
    const ClipTable table(library);
    const FeatureDatabase base(table);
    for (const char* name : {"walk", "jog", "run"}) {
        const auto clip = static_cast<std::size_t>(table.find(name));
        for (float time = 0.0f; time < table[clip].duration - 0.02f; time += 1.0f / 30.0f) {
            const std::int32_t row = base.rowOf(clip, time);
            const Features query = base.query(straight(table[clip].speed), row);
            CHECK(base.cost(query, row) < 1e-3f);
            const Match match = base.search(query, ClipFilter::Any, {}, 1e9f);
            CHECK(base.clipOf(match.row) == clip);
            CHECK(std::fabs(base.timeOf(match.row) - time) < 0.05f);
        }
    }
}

TEST_CASE("faster trajectories lead to faster clips, none to standing") {
    const ClipLibrary library = swingingClips();
    const ClipTable table(library);
    const FeatureDatabase base(table);
    const auto found = [&](const char* clip, float speed) {
        const std::int32_t from = base.rowOf(static_cast<std::size_t>(table.find(clip)), 0.2f);
        return table[base.clipOf(
                         base.search(base.query(straight(speed), from), ClipFilter::Any, {}, 1e9f).row)]
            .speed;
    };
    CHECK(found("idle", 0.0f) == 0.0f);
    CHECK(found("walk", 1.25f) == doctest::Approx(1.25f));
    CHECK(found("walk", 2.6f) == doctest::Approx(2.6f));
    CHECK(found("run", 1.25f) == doctest::Approx(1.25f));
}

TEST_CASE("who is foretold to arrive comes to the place, who cruises covers the way") {
    WalkTarget target{.arriving = true, .toPlace = {0.3, 0.0}};
    const Trajectory arriving = predict({1.0, 0.0}, {}, target, 1.0f);
    CHECK(arriving[4] == doctest::Approx(0.3).epsilon(0.1));
    target = {};
    target.cruise = {0.0, 2.0};
    const Trajectory turning = predict({2.0, 0.0}, {}, target, 1.0f);
    CHECK(turning[5] > 1.4f);
    CHECK(turning[11] > 0.9f);
    const Trajectory larger = predict({2.0, 0.0}, {}, target, 1.04f);
    CHECK(larger[5] == doctest::Approx(turning[5] / 1.04f));
    // Turned with the character: nothing but the frame changes.
    const Rotation left{0.0, 1.0};
    target.cruise = {-2.0, 0.0};
    const Trajectory turned = predict({0.0, 2.0}, left, target, 1.0f);
    for (std::size_t k = 0; k < kTrajectoryCount; ++k)
        CHECK(turned[k] == doctest::Approx(turning[k]).epsilon(1e-4));
}
