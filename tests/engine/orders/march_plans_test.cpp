// The plans of a group's marches: a rewound world is as far in each step as it was, without the work.
#include "engine/orders/march_plans.h"

#include <doctest.h>

#include "engine/orders/stream_scenes.h"

using namespace muster;
using namespace muster::stream_scenes;

namespace {

constexpr GroundVersion kGround{1, 1};
const Grid kCells = Grid::covering({{-50, -50}, {50, 50}}, 0.5);

/// Plans in steps of a budget, and notes what was spent after each; counts the looks at the ground.
struct Planner {
    Scene scene = door(2);
    Task task = taskOf(scene, true);
    std::int64_t looks = 0;

    std::vector<std::int64_t> goOn(MarchPlans& plans, std::int64_t budget, int most = 1 << 20) {
        const auto ground = [&](Vec2 p) {
            ++looks;
            return scene.ground.room(p);
        };
        std::vector<std::int64_t> spent;
        while (most-- > 0) {
            const StreamStatus status = plans.advance(ground, budget);
            spent.push_back(plans.operations());
            if (status != StreamStatus::Planning) break;
        }
        return spent;
    }
    void resume(MarchPlans& plans, std::int64_t spent, GroundVersion ground = kGround) {
        plans.resume(
            task.def(), {}, ground, kCells, [&](Vec2 p) { return scene.ground.room(p); }, spent);
    }
    Points at(MarchPlans& plans, double q) const {
        Points places(task.starts.size());
        plans.best().at(q, places);
        return places;
    }
};

}  // namespace

TEST_CASE("a march that is planned again after a rewind costs no look at the ground, step by step") {
    Planner planner;
    MarchPlans first, rewound;
    first.start(planner.task.def(), {}, kGround, kCells);
    const auto spent = planner.goOn(first, 5000);
    REQUIRE(spent.size() > 10);
    const Points middle = planner.at(first, 0.5);
    rewound.keep(first);
    CHECK_FALSE(rewound.begun());
    planner.resume(rewound, spent[3]);
    planner.looks = 0;
    const auto again = planner.goOn(rewound, 5000);
    CHECK(planner.looks == 0);
    CHECK(std::equal(again.begin(), again.end(), spent.begin() + 4, spent.end()));
    CHECK(planner.at(rewound, 0.5) == middle);
    // From the start, too.
    rewound.start(planner.task.def(), {}, kGround, kCells);
    CHECK(rewound.operations() == 0);
    CHECK(planner.goOn(rewound, 5000) == spent);
    CHECK(planner.looks == 0);
}

TEST_CASE("with other budgets a march is planned as if nothing were known") {
    Planner planner;
    MarchPlans known, fresh;
    known.start(planner.task.def(), {}, kGround, kCells);
    const auto spent = planner.goOn(known, 5000);
    known.start(planner.task.def(), {}, kGround, kCells);
    planner.goOn(known, 5000, 3);
    fresh.start(planner.task.def(), {}, kGround, kCells);
    planner.goOn(fresh, 5000, 3);
    CHECK(known.operations() == fresh.operations());
    CHECK(planner.goOn(known, 1700) == planner.goOn(fresh, 1700));
    CHECK(planner.at(known, 0.3) == planner.at(fresh, 0.3));
}

TEST_CASE("on another ground nothing is known, and of two marches both are after a rewind") {
    Planner one, two;
    two.scene = door(5);
    two.task = taskOf(two.scene, true);
    MarchPlans first, rewound;
    first.start(one.task.def(), {}, kGround, kCells);
    const auto spent = one.goOn(first, 5000);
    rewound.keep(first);
    one.resume(rewound, spent.back());
    rewound.start(two.task.def(), {}, kGround, kCells);
    two.goOn(rewound, 5000);
    one.looks = two.looks = 0;
    one.resume(rewound, 0);
    one.goOn(rewound, 5000);
    rewound.start(two.task.def(), {}, kGround, kCells);
    two.goOn(rewound, 5000);
    CHECK(one.looks == 0);
    CHECK(two.looks == 0);
    one.resume(rewound, 0, {1, 2});
    CHECK(one.goOn(rewound, 5000) == spent);
    CHECK(one.looks > 0);
}
