// Whatever is typed gets an answer: commands that are valid, or one sentence.
#include <doctest.h>

#include <random>
#include <string>

#include "muster/command.h"
#include "muster/world.h"
#include "studio/words/words.h"

using namespace muster;

namespace {

World madeWorld() {
    WorldDef def;
    def.groups = {{.name = "North", .count = 12, .position = {0, 8}},
                  {.name = "North 2", .count = 5, .position = {0, -8}},
                  {.name = "", .count = 1, .position = {8, 0}}};
    def.obstacles = {{.name = "North wall", .centre = {6, 6}, .radius = 1.0},
                     {.name = "", .centre = {-6, 6}, .radius = 1.0}};
    def.areas = {{.name = "Exit", .polygon = {{10, 10}, {12, 10}, {12, 12}, {10, 12}}}};
    auto made = World::create(def);
    REQUIRE_MESSAGE(made.ok(), made.status().message());
    return std::move(made).value();
}

const char* const kPieces[] = {
    "north",  "North 2",  "half",    "of",      "the",        "rest",        "10",      "-3.5",   "m",
    "%",      ",",        "and",     "then",    "go",         "to",          "split",   "merge",  "into",
    "three",  "ring",     "in",      "a",       "face",       "left",        "guard",   "wall",   "follow",
    "leave",  "by",       "exit",    "nearest", "people",     "wait",        "for",     "s",      "swap",
    "rename", "red",      "between", "around",  "north wall", "everybody",   "except",  "patrol", "spacing",
    "2",      "apart",    "they",    "with",    "turn",       "undo",        "pause",   "speed",  "next",
    "not",    "\xff\xfe", "é",       "\"",      "(",          "99999999999", "degrees", "as",     ".",
};

}  // namespace

TEST_CASE("words: any text gets valid commands or one sentence, and twice the same") {
    World world = madeWorld();
    world.step();
    std::mt19937 random(20261129);
    const GroupId chosen[] = {world.group(0).id};
    for (int round = 0; round < 20000; ++round) {
        std::string text;
        const auto words = random() % 14;
        for (std::uint32_t k = 0; k < words; ++k)
            text += std::string(kPieces[random() % std::size(kPieces)]) + (random() % 9 == 0 ? "" : " ");
        CAPTURE(text);
        const WordsScene scene{world, std::span(chosen, random() % 2)};
        const Understood once = understand(text, scene), twice = understand(text, scene);
        CHECK(once.sentences == twice.sentences);
        CHECK(once.problem == twice.problem);
        CHECK(once.problem.empty() != once.sentences.empty());
        CHECK((once.problem.empty() || once.commands.empty()));
        for (const auto* all : {&once.commands, &once.followers, &once.edits})
            for (const CommandBody& body : *all) {
                const Status valid = validateCommand({0, 1, 1, body});
                CHECK_MESSAGE(valid.ok(), valid.message());
            }
        for (const WordsCompletion& completion : completions(text, scene))
            CHECK(completion.whole.size() > completion.words.size());
    }
}

TEST_CASE("words: a world without groups is told so") {
    WorldDef def;
    def.groups.clear();
    auto made = World::create(def);
    REQUIRE(made.ok());
    const Understood none = understand("everybody go to the middle", {*made, {}});
    CHECK(none.problem == "There is no group here.");
    CHECK(!lookAround(*made).empty());
    CHECK(!mapFromAbove(*made).empty());
}
