// Nothing that a sentence says is lost: each part changes what comes of it, or the sentence is refused.
#include <doctest.h>

#include <string>
#include <vector>

#include "engine/state/command_archive.h"
#include "muster/world.h"
#include "studio/words/words.h"

using namespace muster;

namespace {

World squareWithThings() {
    WorldDef def;
    def.groups = {{.name = "North", .count = 24, .position = {0, 12}},
                  {.name = "South", .count = 12, .position = {0, -12}},
                  {.name = "Reserve", .count = 8, .position = {-12, 0}}};
    def.obstacles = {{.name = "Fountain", .centre = {9, 2}, .radius = 1.0},
                     {.name = "Hall", .centre = {-9, 6}, .radius = 1.0}};
    def.areas = {{.name = "Exit", .polygon = {{14, 10}, {16, 10}, {16, 12}, {14, 12}}},
                 {.name = "Court",
                  .kind = AreaKind::Waiting,
                  .polygon = {{-16, -16}, {-10, -16}, {-10, -10}, {-16, -10}}}};
    auto made = World::create(def);
    REQUIRE_MESSAGE(made.ok(), made.status().message());
    return std::move(made).value();
}

/// All that a text would do, as bytes; its problem where it is refused.
struct Meaning {
    bool refused = false;
    std::string text;
    friend bool operator==(const Meaning&, const Meaning&) = default;
};

Meaning meaningOf(const std::string& text, const WordsScene& scene) {
    const Understood said = understand(text, scene);
    if (!said.problem.empty()) return {true, said.problem};
    Writer writer;
    for (const auto* all : {&said.commands, &said.followers, &said.edits})
        for (const CommandBody& body : *all) encodeBody(writer, body);
    const std::vector<std::uint8_t> bytes = writer.take();
    return {false, std::string(bytes.begin(), bytes.end())};
}

const char* const kVerbs[] = {
    "North go to 10, 10",
    "North go to 10, 10 and wait there",
    "North follow South",
    "North guard the fountain",
    "North leave",
    "North leave by the exit",
    "North wait",
    "North wait in the court",
    "North keep walking",
    "North stop",
    "North hold",
    "North resume",
    "North patrol between the fountain and the hall",
    "North stop patrolling",
    "North form a line",
    "North 3 m apart",
    "North face west",
    "spread North out",
    "split North",
    "South joins North",
    "North and South swap places",
    "colour North blue",
    "North faster",
    "North slower",
    "add 5 people to North",
    "North reverse",
    "half of North go to 10, 10",
};

const char* const kModifiers[] = {
    "facing east",
    "2 m apart",
    "in a wedge",
    "in a big ring",
    "6 abreast",
    "at 0.5 m/s",
    "slowly",
    "for 20 seconds",
    "by way of 5, -5",
    "to the hall",
    "5 m east",
    "each on their own",
    "closer together",
    "with Reserve",
    "into three",
    "red",
    "then form a column",
    "then face south",
    "then guard the hall",
};

}  // namespace

TEST_CASE("words: no part of a sentence is lost, for any verb") {
    World world = squareWithThings();
    world.step();
    const WordsScene scene{world, {}};
    std::size_t done = 0, refused = 0;
    for (const std::string verb : kVerbs) {
        const Meaning alone = meaningOf(verb, scene);
        CHECK_MESSAGE(!alone.refused, verb << ": " << alone.text);
        const Meaning later = meaningOf("then " + verb, scene);
        CHECK_MESSAGE(later != alone, "then " << verb);
        for (const std::string one : kModifiers) {
            const Meaning with = meaningOf(verb + " " + one, scene);
            CHECK_MESSAGE(with != alone, verb << " " << one);
            ++(with.refused ? refused : done);
            for (const std::string other : kModifiers) {
                const bool same = one == other || (one + other).find("slowly") != std::string::npos;
                if (with.refused || same) continue;  // Who says “slowly” may say how fast that is.
                const Meaning both = meaningOf(verb + " " + one + " " + other, scene);
                CHECK_MESSAGE(
                    (both.refused || (both != with && both != meaningOf(verb + " " + other, scene))),
                    verb << " " << one << " " << other);
            }
        }
    }
    CHECK(done > 100);
    CHECK(refused > 100);
}

TEST_CASE("words: a spacing keeps the facing that is said with it, and a form that comes later waits") {
    World world = squareWithThings();
    world.step();
    const WordsScene scene{world, {}};
    const Understood spaced = understand("North 2 m apart facing east", scene);
    CHECK(spaced.problem == "");
    REQUIRE(spaced.commands.size() == 2);
    REQUIRE(std::holds_alternative<ChangeGroup>(spaced.commands[0]));
    CHECK(std::get<ChangeGroup>(spaced.commands[0]).formation->spacing == doctest::Approx(2.0));
    REQUIRE(std::holds_alternative<GiveOrder>(spaced.commands[1]));
    CHECK(std::get<GiveOrder>(spaced.commands[1]).order.kind == OrderKind::Face);
    const Understood later = understand("North go to 10, 10 then form a ring", scene);
    CHECK(later.problem == "");
    REQUIRE(later.commands.size() == 2);
    const auto& order = std::get<GiveOrder>(later.commands[1]);
    CHECK(order.mode == QueueMode::Append);
    CHECK(order.order.formation->kind == FormationKind::Ring);
    CHECK(understand("North guard the fountain in a ring", scene).problem ==
          "A shape cannot be said with “guard”: leave it out, or say it in a sentence of its own.");
    CHECK(understand("North go to 10, 10 in a ring in a line", scene).problem ==
          "That is said twice: say it once, or “then” before the second.");
}

TEST_CASE("words: a gate is gone through, whatever its name begins with") {
    WorldDef def;
    def.groups = {{.name = "North", .count = 9, .position = {0, 8}},
                  {.name = "South", .count = 4, .position = {9, -9}}};
    ObstacleDef gate{.name = "North gate", .polygon = {{-2, -0.1}, {2, -0.1}, {2, 0.1}, {-2, 0.1}}};
    gate.path.waypoints = {{0.0, {0, 0}, 0.0}, {5.0, {0, 0}, 0.0}, {8.0, {4, 0}, 0.0}, {1e7, {0, 0}, 0.0}};
    def.obstacles = {gate};
    auto made = World::create(def);
    REQUIRE_MESSAGE(made.ok(), made.status().message());
    World world = std::move(made).value();
    world.step();
    const WordsScene scene{world, {}};
    const auto orderOf = [&](const char* text) {
        const Understood said = understand(text, scene);
        CHECK_MESSAGE(said.problem == "", text);
        REQUIRE_MESSAGE(said.commands.size() == 1, text);
        return std::get<GiveOrder>(said.commands[0]).order;
    };
    for (const char* text :
         {"North go to 0, -9 through the North gate", "North go by way of the gate to 0, -9",
          "North walk through the door to 0, -9"}) {
        const Order order = orderOf(text);
        REQUIRE_MESSAGE(order.route.size() == 3, text);
        CHECK_MESSAGE(distance(order.route[1], {0, 0}) < 1e-9, text);
        CHECK_MESSAGE(distance(order.target, {0, -9}) < 1e-9, text);
    }
    const Order through = orderOf("North go through the North gate");
    CHECK(through.route.size() == 3);
    CHECK(through.target.y < -2.0);
    CHECK(orderOf("North go to the North gate").target.y > 1.0);
}

TEST_CASE("words: who swims, climbs or crawls crosses the ground for it, and nothing else") {
    WorldDef def;
    def.groups = {{.name = "North", .count = 9, .position = {0, 9}}};
    def.patches = {{.name = "Pool", .polygon = {{-4, -2}, {4, -2}, {4, 2}, {-4, 2}}}};
    def.obstacles = {{.name = "Fountain", .centre = {12, 2}, .radius = 1.0}};
    auto made = World::create(def);
    REQUIRE_MESSAGE(made.ok(), made.status().message());
    const WordsScene scene{*made};
    for (const char* text : {"North swim across the pool", "North swims through the pool",
                             "North cross the pool", "North climb over the pool", "North jump over pool"}) {
        CAPTURE(text);
        const Understood said = understand(text, scene);
        REQUIRE_MESSAGE(said.problem.empty(), said.problem);
        REQUIRE(said.commands.size() == 1);
        const auto* give = std::get_if<GiveOrder>(&said.commands[0]);
        REQUIRE(give != nullptr);
        CHECK(give->order.target.y < -3.0);
        REQUIRE(give->order.route.size() == 3);
        CHECK(length(give->order.route[1]) < 1e-9);
    }
    const Understood on = understand("North swim across the pool to 12, -9", scene);
    REQUIRE_MESSAGE(on.problem.empty(), on.problem);
    CHECK(std::get<GiveOrder>(on.commands.at(0)).order.target.x == doctest::Approx(12.0));
    CHECK(understand("North climb the fountain", scene).problem.find("Nobody can go over or through") !=
          std::string::npos);
}
