// The game of the SDL sample without SDL: its orders, its dead, its poses, its job system.
#include <doctest.h>

#include <atomic>

#include "sdl_game/game_battle.h"
#include "sdl_game/jobs.h"

using namespace game;

namespace {

/// Everything in the calling thread.
constexpr muster::TaskRunner kAlone{
    .run = [](void*, std::int32_t count, void (*task)(void*, std::int32_t, std::int32_t), void* context) {
        for (std::int32_t item = 0; item < count; ++item) task(context, item, 0);
    }};

Battle battleOf(const muster::TaskRunner& runner = kAlone) {
    muster::Result<Battle> battle = Battle::create(runner);
    REQUIRE(battle.ok());
    return std::move(*battle);
}

/// A group's members by their ids, of the group with that index.
Ids membersOf(const Battle& battle, std::size_t group) {
    Ids ids;
    for (const std::int32_t member : battle.world().group(group).members)
        ids.insert(battle.world().characters().id[member]);
    return ids;
}

}  // namespace

TEST_CASE("an order to a part of two groups makes one group of it, which goes there; the others stay") {
    Battle battle = battleOf();
    Ids some;
    for (std::size_t group = 0; group < 2; ++group) {
        const Ids members = membersOf(battle, group);
        REQUIRE(members.size() == 50);
        some.insert(members.begin(), std::next(members.begin(), 10));
    }
    battle.order(some, muster::Order::move({-8.0, -1.0}));
    for (int step = 0; step < 2; ++step) battle.step();
    REQUIRE(battle.world().groupCount() == 3);
    CHECK(membersOf(battle, 0).size() == 40);
    CHECK(membersOf(battle, 1).size() == 40);
    CHECK(membersOf(battle, 2) == some);
    for (int step = 0; step < 1500; ++step) battle.step();
    Vec2 middle;
    for (const UnitPose& pose : battle.poses(1.0))
        if (some.contains(pose.id)) middle += pose.position / 20.0;
    CHECK(muster::distance(middle, {-8.0, -1.0}) < 1.0);
    CHECK(battle.fallen().empty());
}

TEST_CASE("a group that is selected as a whole is divided into halves, a part of one is not") {
    Battle battle = battleOf();
    const Ids all = membersOf(battle, 0);
    battle.split(Ids(all.begin(), std::next(all.begin(), 49)));
    battle.step();
    CHECK(battle.world().groupCount() == 2);
    battle.split(all);
    battle.step();
    REQUIRE(battle.world().groupCount() == 3);
    CHECK(membersOf(battle, 0).size() == 25);
    CHECK(membersOf(battle, 2).size() == 25);
}

TEST_CASE("who falls is no unit any more at once, lies there for a while, and does not come back") {
    Battle battle = battleOf();
    battle.step();
    const Ids three{2, 3, 50};
    battle.fall(three);
    battle.fall(three);
    CHECK(battle.poses(0.5).size() == 97);
    CHECK(battle.fallen().size() == 3);
    battle.step();
    CHECK(battle.world().rejections().empty());
    CHECK(battle.world().characters().size() == 97);
    for (double end = battle.world().time() + kFallenSeconds; battle.world().time() <= end;) battle.step();
    CHECK(battle.fallen().empty());
}

TEST_CASE("the tower hits who comes near, once per reload, and nobody else") {
    Battle battle = battleOf();
    battle.order(membersOf(battle, 1), muster::Order::move({13.0, 1.0}));
    std::optional<Fallen> last;
    int shots = 0;
    for (int step = 0; step < 2400; ++step) {
        battle.step();
        const auto shot = battle.lastShot();
        if (!shot || (last && last->time == shot->time)) continue;
        if (last) CHECK(shot->time - last->time >= kReload - 1e-9);
        CHECK(muster::distance(shot->position, kTower) <= kTowerReach);
        last = shot;
        ++shots;
    }
    CHECK(shots > 5);
    CHECK(battle.world().characters().size() == 100u - static_cast<unsigned>(shots));
    CHECK(membersOf(battle, 0).size() == 50);
}

TEST_CASE("poses between two steps lie between those of the steps") {
    Battle battle = battleOf();
    battle.order(membersOf(battle, 0), muster::Order::move({-8.0, 0.0}));
    for (int step = 0; step < 120; ++step) battle.step();
    const auto before = battle.poses(0.0), middle = battle.poses(0.25), after = battle.poses(1.0);
    double moved = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        CHECK(after[i].position == battle.world().characters().position[i]);
        CHECK(muster::distance(middle[i].position, 0.75 * before[i].position + 0.25 * after[i].position) <
              1e-12);
        CHECK(muster::length(middle[i].heading) == doctest::Approx(1.0));
        moved = std::max(moved, muster::distance(before[i].position, after[i].position));
    }
    CHECK(moved > 0.01);
    CHECK(moved < 0.05);
    const Ids row = battle.unitsIn(after[0].position, after[0].position);
    CHECK(row.contains(after[0].id));
    CHECK(battle.unitsIn({-24, -15}, {24, 15}).size() == 100);
    CHECK(battle.unitsIn({20, 10}, {24, 15}).empty());
}

TEST_CASE(
    "the job system does every item once, no two at a time by one worker, and the background beside them") {
    Jobs jobs(3);
    const muster::TaskRunner runner = jobs.runner();
    REQUIRE(runner.threads == 4);
    struct Work {
        std::vector<std::atomic<int>> done = std::vector<std::atomic<int>>(1000);
        std::atomic<int> busy[4]{};
        std::atomic<bool> clash{false}, background{false};
    } work;
    for (int round = 0; round < 50; ++round) {
        work.background = false;
        runner.launch(
            runner.context, [](void* w) { static_cast<Work*>(w)->background = true; }, &work);
        runner.run(
            runner.context, 1000,
            [](void* w, std::int32_t item, std::int32_t worker) {
                Work& all = *static_cast<Work*>(w);
                if (all.busy[worker]++ != 0) all.clash = true;
                ++all.done[item];
                --all.busy[worker];
            },
            &work);
        runner.wait(runner.context);
        CHECK(work.background);
    }
    CHECK_FALSE(work.clash);
    for (const auto& count : work.done) CHECK(count == 50);
    CHECK(jobs.rounds() == 50);
    CHECK(jobs.launches() == 50);
}

TEST_CASE("the battle is the same on the game's threads as on one") {
    Jobs jobs(2);
    Battle alone = battleOf(), together = battleOf(jobs.runner());
    for (Battle* battle : {&alone, &together}) {
        battle->order(membersOf(*battle, 0), muster::Order::moveToLine({3.5, 9.0}, {3.5, -0.5}));
        for (int step = 0; step < 400; ++step) battle->step();
    }
    CHECK(alone.world().hash() == together.world().hash());
    CHECK(jobs.launches() > 0);
}
