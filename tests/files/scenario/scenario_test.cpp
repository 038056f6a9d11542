#include "muster/scenario.h"
#include "test_folders.h"

#include <doctest.h>

#include <filesystem>
#include <string>

#include "base/archive.h"
#include "base/random.h"
#include "muster/parameter_table.h"

using namespace muster;

namespace {

const std::string kFolder = sourceFolder() + "/scenarios";

/// All members of a definition as bytes, for exact comparison.
std::vector<std::uint8_t> bytesOf(WorldDef def) {
    Writer w;
    w(def.name, def.description, def.credit, def.gestures, def.box.min, def.box.max, def.cell, def.seed,
      def.clips, def.obstacles, def.patches, def.map, def.groups, def.checkpoints, def.items);
    for (const ParameterInfo& info : parameterTable()) {
        double value = info.get(def.parameters);
        w(value);
    }
    return w.take();
}

/// A sort of persons whose numbers are all drawn differently.
PeopleDef richSort() {
    return {.name = "Guests",
            .share = 1.0 / 3.0,
            .unitClass = 4,
            .speed = Distribution::normal(1.0 / 3.0, 0.26, 0.1, 2.2),
            .radius = Distribution::constant(0.1 + 0.2),
            .headway = {Spread::Gamma, 4.0, 1.0 / 3.0, 0.1, 4.0},
            .premovement = {Spread::LogNormal, -1.0 / 3.0, 0.25, 0.0, 1e6},
            .age = {Spread::Weibull, 40.0, 7.0, 20.0, 70.0},
            .upstairs = 0.3,
            .downstairs = 1.0 / 3.0};
}

/// An area that says all that its kind can say.
AreaDef richArea(AreaKind kind) {
    AreaDef area{.name = "Gate",
                 .kind = kind,
                 .polygon = {{1.1, 2.2}, {3.3, 2.2}, {3.3, 4.400000000000001}},
                 .open = kind != AreaKind::Exit,
                 .rate = 1.0 / 3.0};
    if (kind == AreaKind::Exit) area.queue = {{1.0 / 3.0, 0}, {5, 6}, {7, -0.0}};
    if (kind != AreaKind::Source) return area;
    area.group = 1;
    area.from = 0.1;
    area.until = 0.1 + 0.2;
    area.most = 12;
    area.timetable = {{1.0 / 3.0, 2}, {1e6, 200000}};
    return area;
}

/// A definition with a value in every member, with numbers that are hard to print.
WorldDef richDef() {
    WorldDef def{.name = "Rich \"quoted\" \\ \n \xc3\xa9",
                 .description = "All of it.",
                 .credit = "Nobody",
                 .gestures = "touches/by hand.json",
                 .box = {{-1.0 / 3.0, -0.1}, {31.7, 20.000000000000004}},
                 .cell = 0.1 + 0.2,
                 .seed = 9007199254740991ull};
    def.clips[3].file = "crawl.bvh";
    def.clips[3].length = 1e-3 / 7.0;
    ObstacleDef box{
        .name = "Box",
        .polygon = {{1.1, 2.2}, {3.3, 2.2}, {3.3, 4.400000000000001}},
        .path = {.waypoints = {{0.0, {0, 0}, 0.0}, {1.0 / 3.0, {0.7, -0.0}, 0.123456789012345678}},
                 .loop = true},
        .strength = 0.0};
    ObstacleDef disc{.centre = {5, 6}, .radius = 0.30000000000000004, .range = 2.5};
    def.obstacles = {box, disc};
    PatchDef patch{.name = "Net", .polygon = {{6, 6}, {8, 6}, {8, 8}}, .motion = 3, .speed = 1.0 / 7.0};
    def.patches = {patch};
    GroupDef group{.name = "A",
                   .count = 3,
                   .formation = {.kind = FormationKind::Points, .points = {{0, 0}, {1, 0.1}, {0.2, 1}}},
                   .position = {10, 10},
                   .angle = 1e-9,
                   .starts = {{2, 9}, {3, 9}, {4, 9}},
                   .jitter = 0.05,
                   .colour = 0x00A1FF,
                   .build = BodyBuild::Narrow,
                   .motions = MotionSet::March};
    GroupDef other{.formation = {.kind = FormationKind::Outline,
                                 .outline = {.outline = {{0, 0}, {5, 0}, {5, 5}, {0, 5}},
                                             .holes = {{{1, 1}, {1, 2}, {2, 2}}, {{3, 3}, {3, 4}, {4, 4}}}}}};
    def.groups = {group, other};
    def.checkpoints = {{.position = {12, 3},
                        .formation = {.kind = FormationKind::Pacman, .opening = 0.7},
                        .group = 1,
                        .once = false}};
    def.items = {{{3, 3}, 0.4}};
    PatchDef stairs = patch;
    stairs.ascent = -1.0 / 3.0;
    stairs.speedDown = 0.1 + 0.2;
    def.patches.push_back(stairs);
    def.groups[0].people = {adults(), richSort()};
    def.groups[0].bodies = {Body{0.3, 1.1, 4.0, 2.0, 1.5, 1, 1.0 / 3.0, 17.25, 0.5, 0.1 + 0.2}};
    def.groups[1].count = 0;
    def.groups[1].people = {adults()};
    Order leave = Order::leave({AreaId{1}});
    leave.attractions = {-1.0 / 3.0};
    leave.herding = 0.1 + 0.2;
    leave.misjudgement = 1e-9;
    leave.choice = ExitChoice::Nearest;
    def.groups[0].orders = {Order::wait(AreaId{3}, 1.0 / 3.0), Order::walk(0.1 + 0.2), leave};
    def.areas = {richArea(AreaKind::Exit), richArea(AreaKind::Source), richArea(AreaKind::Waiting)};
    def.ring = true;
    def.parameters.plan.exponent = 1.7;
    def.parameters.plan.mode = PlanMode::Fixed;
    return def;
}

std::string minimal(const std::string& more) {
    return R"({"format":"muster-scenario","version":1)" + (more.empty() ? "" : "," + more) + "}";
}

std::string failureOf(const std::string& text) {
    const auto def = parseScenario(text, "F.json", "");
    return def.ok() ? "" : def.status().message();
}

}  // namespace

TEST_CASE("a definition survives writing and reading bit for bit") {
    const WorldDef def = richDef();
    const std::string text = writeScenario(def);
    const auto back = parseScenario(text, "rich", "");
    REQUIRE_MESSAGE(back.ok(), back.status().message());
    CHECK(bytesOf(*back) == bytesOf(def));
    CHECK(writeScenario(*back) == text);
}

TEST_CASE("people are one sort, a list or a word, and numbers stand for what all have") {
    const auto peopleOf = [](const std::string& people) {
        const auto def = parseScenario(minimal(R"("groups":[{"people":)" + people + "}]"), "F.json", "");
        REQUIRE_MESSAGE(def.ok(), def.status().message());
        return def->groups[0].people;
    };
    const auto refused = [](const std::string& people, const std::string& by) {
        const std::string message = failureOf(minimal(R"("groups":[{"people":)" + people + "}]"));
        CAPTURE(message);
        CHECK(message.find(by) != std::string::npos);
    };
    CHECK(peopleOf(R"("adults")") == std::vector{adults()});
    const auto one = peopleOf(
        R"({"name":"Slow","speed":0.8,"premovement":{"spread":"uniform","a":10,"b":100}})");
    REQUIRE(one.size() == 1);
    CHECK(one[0].speed == Distribution::constant(0.8));
    CHECK(one[0].premovement == Distribution::uniform(10, 100));
    const auto list = peopleOf(
        R"(["adults",{"share":2,"age":{"spread":"normal","a":40,"b":9,"least":20,"most":70}}])");
    REQUIRE(list.size() == 2);
    CHECK(list[0] == adults());
    CHECK(list[1].age == Distribution::normal(40, 9, 20, 70));
    CHECK(peopleOf("[]").empty());
    refused(R"("children")", R"($.groups[0].people: found the text "children", expected "adults")");
    refused(R"([{"speed":{"spread":"even"}}])", "$.groups[0].people[0].speed.spread:");
    refused(R"([{"speed":{"a":1}}])", R"($.groups[0].people[0].speed: found no "spread")");
    refused(R"({"pace":1})", "unknown key \"pace\"");
    refused(R"({"speed":90})", "$.groups[0]");
    // What is as usual is left out.
    const auto def = parseScenario(minimal(R"("groups":[{"people":"adults"},{}])"), "F.json", "");
    const std::string text = writeScenario(*def);
    CHECK(text.find(R"("people": "adults")") != std::string::npos);
    CHECK(text.find("people") == text.rfind("people"));
    CHECK(text.find("premovement") == std::string::npos);
    CHECK(text.find("ring") == std::string::npos);
}

TEST_CASE("a source names a group of the file") {
    const std::string polygon = R"("polygon":[[0,0],[2,0],[2,2]])";
    const auto def = parseScenario(
        minimal(R"("groups":[{},{"count":0}],"ring":true,"areas":[{"kind":"exit",)" + polygon +
                R"(},{"kind":"source","group":1,"rate":2,)" + polygon + "}]"),
        "F.json", "");
    REQUIRE_MESSAGE(def.ok(), def.status().message());
    CHECK(def->ring);
    REQUIRE(def->areas.size() == 2);
    CHECK(def->areas[1].group == 1);
    CHECK(def->areas[1].until == 1e9);
    const auto refused = [&](const std::string& area, const std::string& by) {
        const std::string message = failureOf(minimal(R"("groups":[{}],"areas":[{)" + area + polygon + "}]"));
        CAPTURE(message);
        CHECK(message.find(by) != std::string::npos);
    };
    refused(R"("kind":"source","group":1,)", "$.areas[0].group:");
    refused("", R"($.areas[0]: found no "kind")");
    refused(R"("kind":"exit","rate":-1,)", "$.areas[0].rate:");
    refused(R"("kind":"exit","queue":[[0,0]],)", "$.areas[0].queue:");
    refused(R"("kind":"source","timetable":[{"t":1,"count":0}],)", "$.areas[0].timetable[0].count:");
    CHECK(failureOf(minimal(R"("groups":[{"count":0}])")).find("no source") != std::string::npos);
}

TEST_CASE("warnings name orders that lead nowhere") {
    WorldDef def{.groups = {{.name = "Guests", .orders = {Order::leave()}}}};
    CHECK(scenarioWarnings(def).size() == 1);
    CHECK(scenarioWarnings(def)[0] == "group \"Guests\" is to leave, and there is no exit");
    AreaDef area{.polygon = {{0, 0}, {2, 0}, {2, 2}, {0, 2}}};
    def.areas = {area, area};
    def.areas[1].kind = AreaKind::Waiting;
    CHECK(scenarioWarnings(def).empty());
    def.groups[0].orders = {Order::leave({AreaId{2}}), Order::wait(AreaId{1}, 5.0), Order::wait(AreaId{2})};
    const auto warnings = scenarioWarnings(def);
    REQUIRE(warnings.size() == 2);
    CHECK(warnings[0] == "group \"Guests\" is to leave by area 2, which is no exit");
    CHECK(warnings[1] == "group \"Guests\" is to wait in area 1, which is no waiting area");
}

TEST_CASE("appearances are words, and left out where they are as usual") {
    const auto def = parseScenario(
        minimal(R"("groups":[{"build":"broad","motions":"weary"},{"motions":"march"},{}])"), "F.json", "");
    REQUIRE_MESSAGE(def.ok(), def.status().message());
    CHECK(def->groups[0].build == BodyBuild::Broad);
    CHECK(def->groups[0].motions == MotionSet::Weary);
    CHECK_FALSE(def->groups[1].build);
    CHECK(def->groups[1].motions == MotionSet::March);
    CHECK_FALSE(def->groups[2].motions);
    const std::string text = writeScenario(*def);
    CHECK(text.find("\"build\": \"broad\"") == text.rfind("\"build\""));
    CHECK(text.find("\"motions\": \"weary\"") != std::string::npos);
    CHECK(failureOf(minimal(R"("groups":[{"motions":"hop"}])")) ==
          R"(F.json: $.groups[0].motions: found the text "hop", expected one of "march", "weary")");
}

TEST_CASE("colours are read in either case, written in small letters, and left out where none was chosen") {
    const auto def = parseScenario(minimal(R"("groups":[{"colour":"#00A1Ff"},{}])"), "F.json", "");
    REQUIRE_MESSAGE(def.ok(), def.status().message());
    CHECK(def->groups[0].colour == 0x00A1FFu);
    CHECK_FALSE(def->groups[1].colour);
    const std::string text = writeScenario(*def);
    CHECK(text.find(R"("colour": "#00a1ff")") != std::string::npos);
    CHECK(text.find("colour") == text.rfind("colour"));
    CHECK(failureOf(minimal(R"("groups":[{"colour":"red"}])")) ==
          R"(F.json: $.groups[0].colour: found the text "red", expected a colour as "#rrggbb")");
}

TEST_CASE("random doubles survive bit for bit") {
    Random random(11);
    for (int round = 0; round < 300; ++round) {
        WorldDef def{.groups = {{.position = {random.uniform(-9e5, 9e5), random.uniform(-1e-5, 1e-5)},
                                 .angle = random.uniform(-7, 7) / 3.0}}};
        for (const ParameterInfo& info : parameterTable()) {
            const double value = info.minimum +
                                 (info.maximum - info.minimum) * random.uniform() * random.uniform();
            (void)setParameter(def.parameters, info.name, value).ok();
        }
        // These parameters may not contradict each other.
        Parameters& p = def.parameters;
        p.density.max = p.density.min + 1.0 / 3.0;
        p.cost.alpha = 0.1 + random.uniform(), p.cost.beta = random.uniform(),
        p.cost.gamma = random.uniform() / 3.0;
        p.cost.minSpeed = 0.01 + random.uniform() / 3.0, p.discomfort.gain = random.uniform() * 7.0;
        if (p.density.max > 100.0) continue;
        const auto back = parseScenario(writeScenario(def), "random", "");
        REQUIRE_MESSAGE(back.ok(), back.status().message());
        CHECK(bytesOf(*back) == bytesOf(def));
    }
}

TEST_CASE("random definitions survive bit for bit, also where texts, lists and paths are empty") {
    Random random(17);
    const auto coin = [&] { return random.below(2) == 0; };
    const auto word = [&] { return coin() ? std::string() : "w" + std::to_string(random.below(9)); };
    const auto path = [&] {
        TimedPath path{.loop = coin()};
        const std::uint32_t count = random.below(3);
        for (std::uint32_t i = 0; i < count; ++i)
            path.waypoints.push_back({1.0 * i, {random.uniform(), 0.0}, random.uniform()});
        return path;
    };
    const auto formation = [&] {
        FormationDef formation{
            coin() ? FormationKind::Square : FormationKind::Outline, 1.0 + random.uniform(), 1.2, {}, {}};
        if (formation.kind == FormationKind::Outline || coin())
            formation.outline.outline = {{0, 0}, {9, 0}, {9, 9}};
        if (coin()) formation.points = {{0.5, 0.25}};
        return formation;
    };
    const auto drawn = [&] {
        return coin() ? Distribution::constant(coin() ? 0.0 : random.uniform())
                      : Distribution{coin() ? Spread::Uniform : Spread::Normal, random.uniform(),
                                     1.0 + random.uniform(), 0.0, coin() ? 1e9 : 100.0};
    };
    for (int round = 0; round < 400; ++round) {
        WorldDef def;
        def.name = word(), def.description = word(), def.credit = word(), def.gestures = word();
        for (std::size_t i = 0; i < def.clips.size(); ++i) def.clips[i].file = word();
        if (coin()) def.clips[2].name = "";
        for (std::uint32_t i = random.below(3); i > 0; --i) {
            ObstacleDef obstacle{.name = word()};
            if (coin())
                obstacle.polygon = {{0, 0}, {1, 0}, {1, 1}};
            else
                obstacle.radius = 0.5, obstacle.centre = {coin() ? 0.0 : 2.0, 0.0};
            obstacle.path = path();
            if (coin()) obstacle.range = random.uniform();
            if (coin()) obstacle.strength = coin() ? 0.0 : random.uniform();
            def.obstacles.push_back(obstacle);
        }
        for (std::uint32_t i = random.below(3); i > 0; --i) {
            PatchDef patch{
                word(), {{0, 0}, {1, 0}, {1, 1}}, path(), static_cast<std::int32_t>(random.below(8)), -1.0};
            if (coin()) patch.speed = 0.5;
            def.patches.push_back(patch);
        }
        for (PatchDef& patch : def.patches) {
            if (coin()) patch.ascent = random.uniform(-3, 3);
            if (coin()) patch.speedDown = random.uniform(0.1, 1);
        }
        for (std::uint32_t i = random.below(3); i > 0; --i) {
            GroupDef group;
            group.name = word(), group.count = 1, group.formation = formation();
            if (coin()) group.starts = {{1, 1}};
            if (coin()) group.people = {coin() ? adults() : PeopleDef{}};
            if (coin()) group.people.push_back({word(), 1.0, 0, {}, {}, {}, drawn(), {}, 0.0, 0.25});
            def.groups.push_back(group);
        }
        if (coin())
            def.checkpoints.push_back(
                {{1, 2}, 1.0, formation(), static_cast<std::int32_t>(def.groups.size()) - 1, coin()});
        if (coin()) def.items.push_back({{1, 2}, 0.25});
        for (std::uint32_t i = random.below(3); i > 0; --i) {
            AreaDef area;
            area.name = word(), area.polygon = {{0, 0}, {1, 0}, {1, 1}}, area.open = coin();
            area.kind = coin() || def.groups.empty() ? AreaKind::Exit : AreaKind::Source;
            if (coin()) area.rate = random.uniform();
            if (coin()) area.from = random.uniform(), area.until = 2.0;
            if (area.kind == AreaKind::Exit && coin()) area.queue = {{0, 0}, {1, 5}};
            if (area.kind == AreaKind::Source && coin()) area.timetable = {{random.uniform(), 3}};
            def.areas.push_back(area);
        }
        def.ring = coin();
        const std::string text = writeScenario(def);
        const auto back = parseScenario(text, "random", "");
        REQUIRE_MESSAGE(back.ok(), back.status().message(), "\n", text);
        const bool same = bytesOf(*back) == bytesOf(def);
        CHECK_MESSAGE(same, text);
    }
}

TEST_CASE("defaults apply where a file gives no value, and an embedded map gives the box") {
    const auto def = parseScenario(minimal(""), "F", "");
    REQUIRE(def.ok());
    CHECK(bytesOf(*def) == bytesOf(WorldDef{}));
    const auto map = parseScenario(
        minimal(
            R"("map":{"rows":["..@","..."],"metresPerCell":2,"origin":[1,1]},"groups":[{"formation":"wedge"}])"),
        "F", "");
    REQUIRE_MESSAGE(map.ok(), map.status().message());
    CHECK(map->map->grid.width == 3);
    CHECK(map->map->grid.cells == "..@...");
    CHECK(map->box.max == Vec2{7, 5});
    CHECK(map->groups[0].formation.kind == FormationKind::Wedge);
    const auto back = parseScenario(writeScenario(*map), "F", "");
    REQUIRE(back.ok());
    CHECK(bytesOf(*back) == bytesOf(*map));
}

TEST_CASE("a preset gives the initial values of the parameters") {
    const auto def = parseScenario(minimal(R"("preset":"paper","parameters":{"plan.period":3})"), "F", "");
    REQUIRE(def.ok());
    CHECK(def->parameters.plan.exponent == 1.0);
    CHECK(def->parameters.plan.period == 3);
}

TEST_CASE("every failure names file, path, what was found and what was expected") {
    const auto says = [](const std::string& more, const std::string& path) {
        const std::string message = failureOf(minimal(more));
        CAPTURE(message);
        CHECK(message.rfind("F.json: " + path, 0) == 0);
        CHECK(message.find("found") != std::string::npos);
        CHECK(message.find("expected") != std::string::npos);
        CHECK(message.find('\n') == std::string::npos);
    };
    says(R"("cell":"x")", "$.cell:");
    says(R"("cell":0)", "$.cell:");
    says(R"("colour":1)", "$:");
    says(R"("obstacles":{})", "$.obstacles:");
    says(R"("obstacles":[{"centre":[0,0],"radius":1},{"polygon":[[0,0],[1]]}])", "$.obstacles[1].polygon");
    says(R"("obstacles":[{"centre":[0,0],"radius":-1}])", "$.obstacles[0].radius:");
    says(R"("obstacles":[3])", "$.obstacles[0]:");
    says(R"("obstacles":[{"centre":[0,0],"radius":1,"path":{"waypoints":[{"x":1}]}}])",
         "$.obstacles[0].path.waypoints[0]:");
    says(R"("patches":[{"polygon":[[0,0],[1,0],[1,1]],"motion":"fly"}])", "$.patches[0].motion:");
    says(R"("patches":[{"motion":"run"}])", "$.patches[0]:");
    says(R"("groups":[{"count":-1}])", "$.groups[0].count:");
    says(R"("groups":[{"count":2.5}])", "$.groups[0].count:");
    for (const char* bad : {R"("red")", R"("#12345")", R"("#12345g")", R"("1234567")", "3", "null"})
        says(R"("groups":[{"colour":)" + std::string(bad) + "}]", "$.groups[0].colour:");
    says(R"("groups":[{"count":200001}])", "$.groups[0].count:");
    says(R"("groups":[{"formation":"blob"}])", "$.groups[0].formation.kind:");
    says(R"("groups":[{"formation":{"kind":"line","spacing":0}}])", "$.groups[0].formation.spacing:");
    says(R"("parameters":{"plan.exponent":0.2})", "$.parameters[\"plan.exponent\"]:");
    says(R"("parameters":{"plan.exp":2})", "$.parameters:");
    says(R"("preset":"rubens")", "$.preset:");
    says(R"("map":{})", "$.map:");
    says(R"("map":{"rows":["..","."]})", "$.map.rows[1]:");
    says(R"("map":{"file":"nowhere.map"})", "$.map.file:");
    says(R"("seed":-1)", "$.seed:");
    says(R"("gestures":7)", "$.gestures:");
    for (const char* outside : {"/a.json", "../a.json", "a/../../b.json", "a/..", "..", R"(a\\..\\b.json)"})
        says(std::string(R"("gestures":")") + outside + "\"", "$.gestures:");
    CHECK(failureOf("[]").find("F.json: $: found an array") == 0);
    CHECK(failureOf("{}").find("no \"format\"") != std::string::npos);
    CHECK(failureOf(R"({"format":"muster-scenario","version":2})").find("$.version") != std::string::npos);
}

TEST_CASE("contradictions between fields are checked too") {
    CHECK(
        failureOf(minimal(R"("obstacles":[{"polygon":[[0,0],[1,1],[1,0],[0,1]]}])")).find("$.obstacles[0]") !=
        std::string::npos);
    CHECK(failureOf(minimal(R"("obstacles":[{}])")).find("$.obstacles[0]") != std::string::npos);
    CHECK(failureOf(minimal(R"("groups":[{"count":3,"starts":[[0,0]]}])")).find("$.groups[0]") !=
          std::string::npos);
    CHECK(failureOf(minimal(R"("box":[[0,0],[1000,1000]],"cell":0.01)")).find("16 million") !=
          std::string::npos);
    CHECK(failureOf(minimal(R"("box":[[0,0],[0,5]])")).find("empty") != std::string::npos);
    // A few cells of ground, but more density cells than an integer can count.
    CHECK(failureOf(minimal(R"("box":[[0,0],[65536,65536]],"cell":100)"))
              .find("$.parameters: parameter density.cell") != std::string::npos);
    CHECK(failureOf(minimal(R"("box":[[0,0],[410,410]],"parameters":{"density.cell":0.1})"))
              .find("density.cell") != std::string::npos);
    CHECK(failureOf(minimal(R"("clips":[{"name":"run"},{"name":"run"}])")).find("$.clips[1].name") !=
          std::string::npos);
    CHECK(failureOf(minimal(R"("parameters":{"plan.solver":0},"groups":[{"count":3000},{"count":3000}])"))
              .find("at most 5000") != std::string::npos);
    CHECK(failureOf(minimal(R"("parameters":{"density.min":4})")).find("density.max") != std::string::npos);
}

TEST_CASE("syntax errors name line and column") {
    CHECK(failureOf("{\n  \"format\": \"muster-scenario\",\n  \"version\": 1,,\n}").find("F.json:3:") == 0);
    CHECK(failureOf("").find("F.json:1:1") == 0);
    CHECK(failureOf("{\"a\":1,\"a\":2}").find("twice") != std::string::npos);
    CHECK(failureOf(std::string(100000, '[')).find("64 levels") != std::string::npos);
    CHECK(failureOf("{\"a\":1e999}").find("F.json:1:") == 0);
    CHECK(failureOf("{\"a\":\"\xff\"}").find("F.json:1:") == 0);
}

TEST_CASE("too many items are refused") {
    std::string list;
    for (int i = 0; i < 20001; ++i) list += std::string(i > 0 ? "," : "") + R"({"position":[0,0]})";
    CHECK(failureOf(minimal("\"items\":[" + list + "]")).find("at most 20000") != std::string::npos);
}

TEST_CASE("damaged text never crashes") {
    const std::string text = writeScenario(richDef());
    Random random(5);
    for (int round = 0; round < 3000; ++round) {
        std::string bad = text;
        const auto at = random.below(static_cast<std::uint32_t>(bad.size()));
        if (round % 3 == 0)
            bad.erase(at, 1 + random.below(20));
        else
            bad[at] = static_cast<char>(random.below(256));
        const auto def = parseScenario(bad, "F.json", "");
        if (!def.ok()) CHECK(def.status().message().rfind("F.json", 0) == 0);
    }
}

TEST_CASE("map files are found relative to the scenario") {
    const auto folder = std::filesystem::temp_directory_path() / "muster_scenario_test";
    std::filesystem::create_directories(folder);
    const auto write = [&](const char* name, const std::string& text) {
        std::FILE* file = std::fopen((folder / name).c_str(), "wb");
        REQUIRE(file != nullptr);
        std::fwrite(text.data(), 1, text.size(), file);
        std::fclose(file);
    };
    write("small.map", "type octile\nheight 2\nwidth 4\nmap\n....\n.@T.\n");
    write("s.json", minimal(R"("map":{"file":"small.map"})"));
    const auto def = loadScenario((folder / "s.json").string());
    REQUIRE_MESSAGE(def.ok(), def.status().message());
    CHECK(def->map->grid.cells == ".....@T.");
    CHECK(def->box.max == Vec2{4, 2});
    CHECK(loadScenario((folder / "no.json").string()).status().code() == StatusCode::IoError);
    std::filesystem::remove_all(folder);
}

TEST_CASE("warnings report narrow gaps and bad starts") {
    WorldDef def;
    for (double x : {0.0, 1.3}) def.obstacles.push_back({.centre = {x, 0.0}, .radius = 0.5});
    def.groups = {{.count = 2, .starts = {{0.0, 0.1}, {5.0, 5.0}}}};
    const auto warnings = scenarioWarnings(def);
    REQUIRE(warnings.size() == 2);
    CHECK(warnings[0].find("0.30 m") != std::string::npos);
    CHECK(warnings[1].find("1 characters") != std::string::npos);
    def.obstacles[1].centre.x = 1.6;
    def.groups[0].starts[0] = {-3.0, 0.0};
    CHECK(scenarioWarnings(def).empty());
}

TEST_CASE("warnings report gaps exactly where a group's bodies find no way") {
    WorldDef def;
    for (double x : {0.0, 1.6}) def.obstacles.push_back({.centre = {x, 0.0}, .radius = 0.5});
    GroupDef group{.count = 2, .starts = {{-4.0, 0.0}, {5.0, 5.0}}};
    def.groups = {group, group};
    def.groups[1].name = "Carts";
    def.groups[1].starts = {{-4.0, 3.0}, {5.0, 8.0}};
    CHECK(scenarioWarnings(def).empty());
    // Of the class of bodies up to 0.297 m, who are led through 0.595 m; 0.35 m are of that up to 0.354 m.
    def.groups[1].bodies = {{.radius = 0.29}};
    CHECK(scenarioWarnings(def).empty());
    def.groups[1].bodies[0].radius = 0.35;
    const auto warnings = scenarioWarnings(def);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].find("0.60 m wide, too narrow for the largest bodies of group \"Carts\"") !=
          std::string::npos);
    CHECK(warnings[0].find("led through 0.71 m and more") != std::string::npos);
    def.groups.erase(def.groups.begin());
    CHECK(scenarioWarnings(def)[0].find("narrower than a character") != std::string::npos);
    // Smaller bodies fit where the usual ones do not.
    def.obstacles[1].centre.x = 1.45;
    def.groups[0].bodies[0].radius = 0.2;
    CHECK(scenarioWarnings(def).empty());
    def.groups[0].bodies.clear();
    CHECK(scenarioWarnings(def).size() == 1);
}

TEST_CASE("every shipped scenario is valid and has no warnings") {
    int count = 0;
    std::vector<std::filesystem::directory_entry> files;
    for (const std::string& folder : {kFolder, kFolder + "/paper"})
        for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry);
    for (const auto& entry : files) {
        if (entry.path().extension() != ".json") continue;
        CAPTURE(entry.path().string());
        const auto def = loadScenario(entry.path().string());
        REQUIRE_MESSAGE(def.ok(), def.status().message());
        ++count;
        CHECK(!def->description.empty());
        CHECK(def->groups.size() >= 1);
        const auto gestures = loadScenarioGestures(entry.path().string(), *def);
        REQUIRE_MESSAGE(gestures.ok(), gestures.status().message());
        CHECK_MESSAGE(!gestures->empty(), "carries no gestures");
        for (const std::string& warning : scenarioWarnings(*def)) CHECK_MESSAGE(false, warning);
    }
    CHECK(count >= 6);
}

TEST_CASE("single-step patches that do not suit their clips are reported by name, found and expected") {
    WorldDef def;
    PatchDef wall;
    wall.motion = 6;                                            // Climb, 1.2 m.
    wall.polygon = {{-1, 0}, {3, 4}, {2.2, 4.8}, {-1.8, 0.8}};  // 1.13 m across.
    def.patches = {wall};
    CHECK(scenarioWarnings(def).empty());
    wall.polygon = {{0, -5}, {1.4, -5}, {1.4, 5}, {0, 5}};
    def.patches.push_back(wall);
    wall.motion = 3;  // Crawling lasts as long as the patch.
    def.patches.push_back(wall);
    const auto warnings = scenarioWarnings(def);
    REQUIRE(warnings.size() == 1);
    for (const char* part : {"patch 2", "is 1.40 m across", "expected 1.02 to 1.38 m", "climb", "1.20 m"})
        CHECK_MESSAGE(warnings[0].find(part) != std::string::npos, warnings[0]);
}
