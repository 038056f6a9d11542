// Figures of people who leave and come.
#include <doctest.h>

#include "engine/world/metrics.h"
#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

AreaDef areaAt(AreaKind kind, const char* name, double x0, double y0, double x1, double y1) {
    return {.name = name, .kind = kind, .polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// A hall of 20 m x 10 m with an exit at either end, whose people leave.
WorldDef hallFor(std::int32_t count) {
    WorldDef def{.box = {{0, 0}, {20, 10}}, .parameters = *parameterPreset("people")};
    def.groups = {{.count = count, .position = {8, 5}, .orders = {Order::leave()}}};
    def.areas = {areaAt(AreaKind::Exit, "West", 0, 3, 1, 7), areaAt(AreaKind::Exit, "East", 19, 3, 20, 7)};
    return def;
}

/// Steps until nothing is left to do, at most so many seconds.
RunFigures watched(const WorldDef& def, double seconds, double& settled) {
    World world = World::create(def).value();
    RunMetrics metrics(world);
    settled = -1.0;
    while (world.time() < seconds && settled < 0.0) {
        world.step();
        metrics.observe(world);
        if (metrics.settled(world)) settled = world.time();
    }
    return metrics.figures(world, false);
}

}  // namespace

TEST_CASE("who leaves is counted by exit with its times, and the last one ends the run") {
    double settled = 0.0;
    const RunFigures f = watched(hallFor(36), 60.0, settled);
    const DepartureFigures& d = f.departures;
    CHECK(settled == doctest::Approx(d.last));
    CHECK(f.characters == 0);
    CHECK(d.left == 36);
    REQUIRE(d.exits.size() == 2);
    CHECK(d.exits[0].name == "West");
    CHECK(d.exits[1].name == "East");
    CHECK(d.exits[0].left + d.exits[1].left == 36);
    CHECK(std::min(d.exits[0].first, d.exits[1].first) == d.first);
    CHECK(std::max(d.exits[0].last, d.exits[1].last) == d.last);
    CHECK(d.first < d.left50);
    CHECK(d.left50 < d.left95);
    CHECK(d.left95 <= d.last);
    // Who leaves has arrived: without commands both clocks are the same.
    CHECK(f.arrived95 == d.left95);
    CHECK(f.arrived100 == d.last);
    const ExitFigures& west = d.exits[0];
    CHECK(west.flow == doctest::Approx((west.left - 1) / (west.last - west.first)));
}

TEST_CASE("who is still inside, before the exit too, has not arrived") {
    WorldDef def = hallFor(36);
    def.areas[0].rate = def.areas[1].rate = 0.2;
    double settled = 0.0;
    const RunFigures f = watched(def, 60.0, settled);
    CHECK(settled == -1.0);
    CHECK(f.characters > 5);
    CHECK(f.departures.left + static_cast<std::uint32_t>(f.characters) == 36);
    CHECK(f.departures.left50 > 0.0);
    CHECK(f.departures.left95 == -1.0);
    CHECK(f.arrived95 == -1.0);
}

TEST_CASE("while a source may send more, no share has left and nothing is settled") {
    WorldDef def = hallFor(4);
    AreaDef train = areaAt(AreaKind::Source, "Train", 9, 1, 10, 2);
    train.timetable = {{30.0, 12}};
    def.areas.push_back(train);
    double settled = 0.0;
    const RunFigures before = watched(def, 28.0, settled);
    CHECK(settled == -1.0);
    CHECK(before.characters == 0);
    CHECK(before.departures.left == 4);
    CHECK(before.departures.left50 == -1.0);
    CHECK(before.arrived100 == -1.0);
    const RunFigures after = watched(def, 90.0, settled);
    CHECK(settled > 35.0);
    REQUIRE(after.departures.sources.size() == 1);
    CHECK(after.departures.sources[0].name == "Train");
    CHECK(after.departures.sources[0].entered == 12);
    CHECK(after.departures.sources[0].waiting == 0);
    CHECK(after.departures.left == 16);
    CHECK(after.departures.left95 > 30.0);
}

TEST_CASE("who waits at a source is counted there, and a closed source keeps nobody waiting for it") {
    WorldDef def = hallFor(1);
    AreaDef train = areaAt(AreaKind::Source, "Train", 9, 1, 9.6, 1.6);
    train.timetable = {{1.0, 40}};
    def.areas.push_back(train);
    double settled = 0.0;
    const RunFigures f = watched(def, 3.0, settled);
    const SourceFigures& source = f.departures.sources.at(0);
    CHECK(source.waiting > 20);
    CHECK(source.entered + source.waiting == 40);
    def.areas[2].open = false;
    watched(def, 60.0, settled);
    CHECK(settled > 0.0);
}

TEST_CASE("an event about a group counts its persons") {
    WorldDef def = hallFor(20);
    def.areas[0].open = def.areas[1].open = false;
    double settled = 0.0;
    const RunFigures f = watched(def, 2.0, settled);
    const auto kind = static_cast<std::size_t>(EventKind::NoPath);
    CHECK(f.events[kind] == 1);
    CHECK(f.eventPersons[kind] == 20);
}

TEST_CASE("a run goes on while a group waits for its next order") {
    WorldDef def = hallFor(6);
    def.areas.push_back(areaAt(AreaKind::Waiting, "", 6, 3, 10, 7));
    def.groups[0].orders = {Order::wait(AreaId{3}, 20.0), Order::leave()};
    double settled = 0.0;
    const RunFigures f = watched(def, 80.0, settled);
    CHECK(f.departures.left == 6);
    CHECK(settled > 20.0);
}

TEST_CASE("the seam of a ring is no displacement") {
    WorldDef def = hallFor(4);
    def.ring = true;
    def.areas.clear();
    def.groups[0].orders = {Order::walk(0.0)};
    double settled = 0.0;
    const RunFigures f = watched(def, 30.0, settled);
    CHECK(f.topSpeedRatio > 0.8);
    CHECK(f.topSpeedRatio < 1.1);
    CHECK(f.walked.longest < 1.1 * 30.0 * def.parameters.character.maxSpeed);
    CHECK(f.walked.longest > 20.0);
}
