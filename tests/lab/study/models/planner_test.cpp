#include "lab/study/models/planner.h"

#include <doctest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "lab/study/models/model_trial.h"

namespace muster {
namespace {

const Box kGround{{-20.0, -11.25}, {20.0, 11.25}};
const std::vector<Box> kCorridor{{{-7.0, 2.0}, {7.0, 11.25}}, {{-7.0, -11.25}, {7.0, -2.0}}};

/// A square of 36 round a point, 1 m apart.
SeenPart squareAt(Vec2 middle) {
    std::vector<std::uint32_t> ids(36);
    std::iota(ids.begin(), ids.end(), 1);
    std::vector<Vec2> positions;
    for (int i = 0; i < 36; ++i) positions.push_back(middle + Vec2{i % 6 - 2.5, i / 6 - 2.5});
    return seenPart(std::move(ids), std::move(positions));
}

PlannerDef defOf(const char* scheme) {
    PlannerDef def;
    def.repertoire = repertoireOf(namedScheme(scheme).value().def);
    def.parameters = operatorSetting("default").value();
    def.border = kGround.grown(-0.5);
    return def;
}

/// The plan of one scheme for these items.
OperatorPlan planOf(const char* scheme, const std::vector<Box>& blocks, const std::vector<Vec2>& items,
                    Vec2 crowd) {
    const SeenGround ground(blocks, kGround, 0.8);
    const TourFinder tours(ground, items);
    const PlannerDef def = defOf(scheme);
    const Motor motor(def.parameters, def.repertoire.touch, 1.0);
    const Planner planner(def, tours, motor);
    std::vector<std::int32_t> open(items.size());
    std::iota(open.begin(), open.end(), 0);
    Chance chance(5);
    return planner.plan(squareAt(crowd), open, chance);
}

/// Items in rows and columns 3 m apart.
std::vector<Vec2> gridOf(Box box) {
    std::vector<Vec2> items;
    for (double x = box.min.x; x <= box.max.x; x += 3.0)
        for (double y = box.min.y; y <= box.max.y; y += 3.0) items.push_back({x, y});
    return items;
}

TEST_CASE("a front sees where its way is narrow, and where that ends") {
    const SeenGround ground(kCorridor, kGround, 0.8);
    const auto through = ground.narrowest({-15.0, 0.0}, {15.0, 0.0}, 20.0);
    // 4 m less twice the margin are free between the blocks.
    CHECK(through.least == doctest::Approx(2.4).epsilon(0.25));
    CHECK(through.end == doctest::Approx(15.0 + 7.8).epsilon(0.05));
    const auto before = ground.narrowest({-15.0, 0.0}, {-9.0, 0.0}, 10.0);
    CHECK(before.least == doctest::Approx(10.0));
    CHECK(before.end == 0.0);
    // What lies beyond the border is no part of the front.
    const auto edge = ground.narrowest({-15.0, 9.0}, {-9.0, 9.0}, 10.0);
    CHECK(edge.least == doctest::Approx(10.0));
}

TEST_CASE("each scheme plans only what it can do") {
    const std::vector<Vec2> items = gridOf({{-6.0, -9.0}, {18.0, 9.0}});
    const OperatorPlan touch = planOf("touch", {}, items, {-13.5, 0.0});
    const bool sweeps = std::any_of(touch.parts.begin(), touch.parts.end(),
                                    [](const PlannedPart& part) { return part.width > 0.0; });
    CHECK(sweeps);
    for (const char* scheme : {"touch-no-shapes", "touch-one-finger", "mouse-full-free", "mouse-mesh"}) {
        INFO("scheme ", std::string(scheme));
        for (const PlannedPart& part : planOf(scheme, {}, items, {-13.5, 0.0}).parts)
            CHECK(part.width == 0.0);
    }
    const OperatorPlan whole = planOf("touch-no-splits", {}, items, {-13.5, 0.0});
    CHECK(whole.parts.size() == 1);
    CHECK(whole.cuts.empty());
}

TEST_CASE("a plan sends everybody once, and leads over or sweeps up all items") {
    const std::vector<Vec2> items = gridOf({{-18.0, -9.0}, {18.0, 9.0}});
    for (const char* scheme : {"touch", "touch-no-shapes", "mouse-full-continuum", "mouse-full-free"}) {
        INFO("scheme ", std::string(scheme));
        const OperatorPlan plan = planOf(scheme, {}, items, {0.0, 0.0});
        std::multiset<std::uint32_t> ids;
        for (const PlannedPart& part : plan.parts) ids.insert(part.part.ids.begin(), part.part.ids.end());
        CHECK(ids.size() == 36);
        CHECK(std::set<std::uint32_t>(ids.begin(), ids.end()).size() == 36);
        // Nobody can have walked less than to the farthest item, at 2 m/s.
        CHECK(plan.seconds > 6.0);
        CHECK(plan.seconds < 200.0);
    }
}

TEST_CASE("a part that has been cut off is led as a part, not as the whole crowd") {
    // A model that took the first part for all of the crowd drew its first way from the middle of all.
    TrialDef def{.environment = "four-blocks", .scheme = "touch-no-shapes"};
    int divided = 0;
    for (int i = 1; i <= 6; ++i) {
        def.seed = kFirstTuningSeed + i;
        const auto trial = runModelTrial(def, "default");
        REQUIRE(trial.ok());
        const auto cut = std::find_if(trial->decisions.begin(), trial->decisions.end(),
                                      [](const ModelDecision& d) { return d.kind == "cut"; });
        if (cut == trial->decisions.end()) continue;
        ++divided;
        // Then the second finger stroke would tear nobody: the first drawn way begins inside one quarter.
        std::vector<Vec2> downs;
        for (const StampedInput& input : trial->inputs)
            if (const auto* pointer = std::get_if<PointerEvent>(&input.event))
                if (pointer->phase == PointerPhase::Down)
                    downs.push_back(studyView().groundAt(pointer->screen).value());
        const auto cuts = static_cast<std::size_t>(
            std::count_if(trial->decisions.begin(), trial->decisions.end(),
                          [](const ModelDecision& d) { return d.kind == "cut"; }));
        REQUIRE(downs.size() > cuts);
        CHECK(length(downs[cuts]) > 0.7);
    }
    CHECK(divided >= 3);
}

TEST_CASE("calls fetch what a front has left behind") {
    TrialDef def{.environment = "single-block", .scheme = "touch", .seed = kFirstTuningSeed + 2};
    const auto calls = runModelTrial(def, "default");
    def.scheme = "touch-no-calls";
    const auto without = runModelTrial(def, "default");
    REQUIRE(calls.ok());
    REQUIRE(without.ok());
    const auto count = [](const ModelTrial& trial) {
        return std::count_if(trial.decisions.begin(), trial.decisions.end(),
                             [](const ModelDecision& d) { return d.kind == "call"; });
    };
    CHECK(count(*calls) > 0);
    CHECK(count(*without) == 0);
    CHECK(calls->result.done);
}

}  // namespace
}  // namespace muster
