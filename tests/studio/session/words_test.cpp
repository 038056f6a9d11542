// Sentences in a session: shown before they are done, done, taken back in one step, and refused in words.
#include "studio/session/words_stage.h"

using namespace muster;
using namespace muster::testing;
using protocol::SayAct;

namespace {

constexpr const char* kHalf = "half of North to the fountain in a ring, the rest hold";

}  // namespace

TEST_CASE("words: a preview shows places and a forecast, and changes nothing") {
    WordsStage stage;
    const protocol::Said said = stage.ask(kHalf, SayAct::Preview);
    CHECK(said.problem.empty());
    CHECK(said.sentences == "20 of North go to Fountain in a ring.\nThe rest of North (20) holds.");
    REQUIRE(said.places.size() == 1);
    CHECK(said.places[0].places.size() == 40);
    CHECK(std::count(said.places[0].unfit.begin(), said.places[0].unfit.end(), 0) == 20);
    REQUIRE(said.forecasts.size() == 1);
    CHECK(said.forecasts[0].arrives);
    CHECK(said.forecasts[0].seconds > 2.0f);
    stage.settle(1.0);
    CHECK(stage.world().groupCount() == 3);
    CHECK(stage.client.history.undo == 0);
    CHECK(stage.stayed("North") == 40);
}

TEST_CASE("words: a sentence is one step of the history, taken back and done again") {
    WordsStage stage;
    (void)stage.say(kHalf);
    stage.settle(1.0);
    CHECK(stage.world().groupCount() == 4);
    CHECK(stage.client.history.undo == 1);
    CHECK(stage.client.history.undoLabel == kHalf);
    stage.client.send(protocol::UndoEdit{false});
    stage.settle(1.0);
    CHECK(stage.world().groupCount() == 3);
    CHECK(stage.group("North").count == 40);
    CHECK(stage.group("North").orders.empty());
    CHECK(!stage.group("North").held);
    stage.client.send(protocol::UndoEdit{true});
    stage.settle(1.0);
    REQUIRE(stage.world().groupCount() == 4);
    CHECK(stage.group("North").held);
    CHECK(stage.world().group(3).orders.size() == 1);
}

TEST_CASE("words: in a world that is paused the part is made, and its order waits") {
    WordsStage stage;
    (void)stage.say("pause");
    const std::uint32_t step = stage.world().stepCount();
    (void)stage.say(kHalf);
    stage.settle(0.5);
    CHECK(stage.world().groupCount() == 4);
    CHECK(stage.world().stepCount() == step + 1);
    (void)stage.say("play");
    stage.settle(0.5);
    CHECK(stage.world().group(3).orders.size() == 1);
    CHECK(stage.client.history.undo == 1);
}

TEST_CASE("words: what is not understood is named, with what it could be") {
    WordsStage stage;
    const auto problem = [&](const char* text) { return stage.say(text).problem; };
    CHECK(problem("North go to the fountin") == "“fountin”: did you mean Fountain?");
    CHECK(problem("Norht go to the fountain") == "“Norht”: did you mean North?");
    CHECK(problem("go to the fountain").starts_with("Who? Begin with a group, as “North”"));
    CHECK(problem("North").starts_with("What are they to do?"));
    CHECK(problem("North go to the xyzzyplugh").starts_with("I do not know “xyzzyplugh”"));
    CHECK(problem("50 of South go to the middle") == "There are only 24 people, not 50.");
    CHECK(problem("North go to the fountain in 10 seconds").starts_with("I cannot start something later"));
    CHECK(problem("").starts_with("What are they to do?"));
    stage.settle(0.2);
    CHECK(stage.client.history.undo == 0);
    CHECK(stage.client.noticed("rejected").empty());
}

TEST_CASE("words: a sentence that names nobody is about the chosen groups") {
    WordsStage stage;
    protocol::Say say;
    say.act = SayAct::Do;
    say.text = "form a column and go to 5, -8";
    say.chosen = {stage.group("South").id.value, 999};
    stage.client.send(say);
    stage.settle(0.5);
    CHECK(stage.group("South").orders.size() == 1);
    CHECK(stage.group("North").orders.empty());
}

TEST_CASE("words: a director who has one group cannot direct another") {
    WordsStage stage;
    FakeClient other(stage.session);
    stage.client.send(protocol::GiveGroup{other.id, stage.group("South").id.value});
    protocol::Say say;
    say.act = SayAct::Do;
    say.text = "North stop";
    other.send(say);
    other.poll();
    REQUIRE(!other.said.empty());
    CHECK(other.said.back().problem.find("not yours to direct") != std::string::npos);
}

TEST_CASE("words: names come first among what may follow, and looking tells what there is") {
    WordsStage stage;
    const protocol::Said said = stage.ask("Red guard go to the fo", SayAct::Complete);
    REQUIRE(!said.completions.empty());
    CHECK(said.completions[0].words == "Fountain");
    CHECK(said.completions[0].whole == "Red guard go to the Fountain ");
    const std::string seen = stage.ask("", SayAct::Look).sentences;
    CHECK(seen.find("Group 3 Red guard: 20 people, a line at (-12, 0), facing east. Orders: none.") !=
          std::string::npos);
    CHECK(seen.find("Obstacle 1 Fountain: at (14, 0), 4 m by 4 m.") != std::string::npos);
    CHECK(seen.find("##") != std::string::npos);
}

TEST_CASE("words: parts get names of their own") {
    WordsStage stage;
    (void)stage.say("a third of North to the pool, a third to the fountain, the rest stay");
    stage.settle(1.0);
    CHECK(stage.isThere("North 2"));
    CHECK(stage.isThere("North 3"));
    CHECK(stage.group("North").count == 14);
    CHECK(stage.client.history.undo == 1);
}
