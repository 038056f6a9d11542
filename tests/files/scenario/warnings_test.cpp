// Warnings about exits, sources, waiting areas and the people who go there.
#include <doctest.h>

#include <string>

#include "muster/parameter_table.h"
#include "muster/scenario.h"

using namespace muster;

namespace {

AreaDef areaOf(AreaKind kind, double x0, double y0, double x1, double y1) {
    return {.kind = kind, .polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

ObstacleDef wallOf(double x0, double y0, double x1, double y1) {
    return {.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// Two rooms with a door of 1.2 m; ten people in the left one are to leave by an exit in the right one.
WorldDef rooms() {
    WorldDef def{.box = {{0, 0}, {20, 10}},
                 .obstacles = {wallOf(10, 0, 10.2, 4.4), wallOf(10, 5.6, 10.2, 10)},
                 .parameters = *parameterPreset("people")};
    def.groups = {{.name = "Guests", .count = 10, .position = {5, 5}, .orders = {Order::leave()}}};
    def.areas = {areaOf(AreaKind::Exit, 18, 3, 19, 7)};
    return def;
}

/// The only warning; a text that says how many there are, where there is not one.
std::string warningOf(const WorldDef& def) {
    const auto warnings = scenarioWarnings(def);
    return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
}

bool startsWith(const std::string& text, const std::string& part) {
    CAPTURE(text);
    return text.rfind(part, 0) == 0;
}

}  // namespace

TEST_CASE(
    "a good scene of people has no warning, nor has an exit that lies partly in a wall or off the ground") {
    WorldDef def = rooms();
    CHECK(scenarioWarnings(def).empty());
    def.areas[0] = areaOf(AreaKind::Exit, 19, 3, 25, 7);
    CHECK(scenarioWarnings(def).empty());
    def.areas[0] = areaOf(AreaKind::Exit, 10, 4, 10.2, 6);
    CHECK(scenarioWarnings(def).empty());
}

TEST_CASE("exits, sources and waiting areas without room for a body are named") {
    for (const AreaDef& exit :
         {areaOf(AreaKind::Exit, 10.02, 1, 10.18, 3), areaOf(AreaKind::Exit, 30, 3, 31, 7),
          areaOf(AreaKind::Exit, 10.2, 1, 10.35, 4)}) {
        WorldDef def = rooms();
        def.areas[0].polygon = exit.polygon;
        def.areas[0].name = "Main door";
        CHECK(startsWith(warningOf(def), "exit 1 \"Main door\" lies in obstacles or off the ground"));
    }
    WorldDef def = rooms();
    def.areas.push_back(areaOf(AreaKind::Source, 10, 1, 10.2, 3));
    CHECK(startsWith(warningOf(def), "source 2 lies in obstacles or off the ground"));
    def.areas[1] = areaOf(AreaKind::Waiting, -4, 1, -2, 3);
    CHECK(startsWith(warningOf(def), "waiting area 2 lies in obstacles or off the ground"));
}

TEST_CASE("an exit that people step over is named") {
    WorldDef def = rooms();
    def.areas[0] = areaOf(AreaKind::Exit, 18, 5, 18.01, 5.01);
    CHECK(startsWith(warningOf(def), "exit 1 is less than 0.05 m across"));
    def.areas[0] = areaOf(AreaKind::Exit, 18, 3, 18.01, 7);
    CHECK(startsWith(warningOf(def), "exit 1 is less than 0.05 m across"));
    def.areas[0] = areaOf(AreaKind::Exit, 18, 5, 18.06, 5.06);
    CHECK(scenarioWarnings(def).empty());
}

TEST_CASE("a line of people through a wall is named") {
    WorldDef def = rooms();
    def.areas[0].queue = {{17, 5}, {12, 5}, {12, 8}};
    CHECK(scenarioWarnings(def).empty());
    def.areas[0].queue = {{17, 2}, {12, 2}, {6, 2}};
    CHECK(startsWith(warningOf(def), "the queue of exit 1 comes nearer than the radius of a body"));
    CHECK(warningOf(def).find("between (12.00, 2.00) and (6.00, 2.00)") != std::string::npos);
    def.areas[0].queue = {{17, 8}, {17, 12}};
    CHECK(startsWith(warningOf(def), "the queue of exit 1"));
}

TEST_CASE("starts on top of each other are counted, those that only touch are not") {
    WorldDef def = rooms();
    def.groups[0].count = 4;
    def.groups[0].starts = {{2, 2}, {2, 2}, {2.1, 2}, {5, 5}};
    CHECK(
        warningOf(def) ==
        "3 characters start on top of others, the first of group 1 \"Guests\" at (2.00, 2.00); they will be "
        "moved apart");
    const double diameter = 2.0 * def.parameters.character.radius;
    def.groups[0].starts = {{2, 2}, {2 + 0.95 * diameter, 2}, {2, 4}, {5, 5}};
    CHECK(scenarioWarnings(def).empty());
}

TEST_CASE("people who are too large for every way, and people without a way, are counted") {
    WorldDef def = rooms();
    def.groups[0].bodies.assign(10, Body{});
    def.groups[0].bodies[3].radius = def.groups[0].bodies[7].radius = 0.7;
    const auto narrow = scenarioWarnings(def);
    REQUIRE(narrow.size() == 2);
    CHECK(startsWith(narrow[0], "the gap between"));
    CHECK(startsWith(
        narrow[1],
        "group 1 \"Guests\" has 2 of 10 persons larger than every way to an exit of theirs: the first, of "
        "radius 0.7 m"));
    // A second exit on their side.
    def.areas.push_back(areaOf(AreaKind::Exit, 1, 3, 2, 7));
    CHECK(startsWith(warningOf(def), "the gap between"));
    WorldDef walled = rooms();
    walled.obstacles.push_back(wallOf(10, 4.4, 10.2, 5.6));
    CHECK(startsWith(warningOf(walled), "group 1 \"Guests\" has 10 of 10 persons without a way"));
    walled.groups[0].position = {15, 5};
    CHECK(scenarioWarnings(walled).empty());
    AreaDef source = areaOf(AreaKind::Source, 1, 1, 3, 3);
    source.timetable = {{1.0, 4}};
    walled.areas.push_back(source);
    CHECK(warningOf(walled) == "source 2 sends people who have no way to an exit of theirs");
}

TEST_CASE("people without a way to their waiting area are counted, before what they do next") {
    WorldDef def = rooms();
    def.obstacles.push_back(wallOf(10, 4.4, 10.2, 5.6));
    def.areas[0] = areaOf(AreaKind::Exit, 1, 3, 2, 7);
    def.areas.push_back(areaOf(AreaKind::Waiting, 12, 3, 16, 7));
    def.areas[1].name = "Lounge";
    def.groups[0].orders = {Order::wait(AreaId{2}, 5.0), Order::leave()};
    CHECK(startsWith(warningOf(def),
                     "group 1 \"Guests\" has 10 of 10 persons without a way to waiting area 2 "
                     "\"Lounge\": the first"));
    def.groups[0].position = {13, 5};
    CHECK(startsWith(warningOf(def),
                     "group 1 \"Guests\" has 10 of 10 persons without a way to an exit of theirs"));
}

TEST_CASE("the joined sides of a ring are no walls") {
    WorldDef def = rooms();
    def.ring = true;
    def.obstacles = {wallOf(0, 4, 0.2, 6)};
    def.obstacles.push_back(wallOf(19.8, 0, 19.9, 3));
    CHECK(scenarioWarnings(def).empty());
}

TEST_CASE("a source without people, exits that are all shut, and orders that never begin are named") {
    WorldDef def = rooms();
    def.areas.push_back(areaOf(AreaKind::Source, 1, 1, 3, 3));
    CHECK(warningOf(def) == "source 2 has neither a rate nor a timetable: nobody comes");
    def.areas[1].rate = 0.5;
    CHECK(scenarioWarnings(def).empty());
    def.areas[0].open = false;
    CHECK(warningOf(def) == "every exit is shut: nobody leaves until a command opens one");
    def.areas[0].open = true;
    def.areas.push_back(areaOf(AreaKind::Waiting, 12, 3, 16, 7));
    def.groups[0].orders = {Order::wait(AreaId{3}), Order::leave()};
    CHECK(warningOf(def) ==
          "order 1 of group 1 \"Guests\" waits without end: the orders behind it never begin");
    def.groups[0].orders[0] = Order::wait(AreaId{3}, 5.0);
    CHECK(scenarioWarnings(def).empty());
}
