// Several directors on one world: names, colours, groups of their own.
#include "studio/session/inbox/directors.h"

#include <doctest.h>

#include <string>

#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Two groups of 16, left and right.
WorldDef leftAndRight() {
    WorldDef def = smallFloor();
    def.groups.push_back(def.groups[0]);
    def.groups[0].name = "Left";
    def.groups[0].position = {-6, 0};
    def.groups[1].name = "Right";
    def.groups[1].position = {6, 0};
    return def;
}

const protocol::DirectorFrame& newest(const FakeClient& client, std::size_t index) {
    REQUIRE(!client.directors.empty());
    REQUIRE(client.directors.back().directors.size() > index);
    return client.directors.back().directors[index];
}

std::string hold(std::uint32_t group) {
    return R"([{"kind":"queue","group":)" + std::to_string(group) + R"(,"edit":"hold"}])";
}

}  // namespace

TEST_CASE("Names are cut between letters and freed of what cannot be seen") {
    Directors directors;
    directors.join(7, "  A\nn\x01na ");
    CHECK(directors.name(7) == "Anna");
    directors.rename(7, " \t ");
    CHECK(directors.name(7) == "Director 1");
    std::string umlauts;
    for (int i = 0; i < 50; ++i) umlauts += "ü";
    directors.rename(7, umlauts);
    CHECK(directors.name(7) == umlauts.substr(0, 2 * Directors::kMaxNameLetters));
    CHECK(directors.name(8) == "Somebody");
}

TEST_CASE("Each director has a colour of their own, and who comes later takes the first that is free") {
    Directors directors;
    for (std::uint32_t client = 1; client <= 3; ++client) directors.join(client, "");
    directors.leave(2);
    directors.join(4, "");
    const auto all = directors.message().directors;
    REQUIRE(all.size() == 3);
    CHECK(all[0].colour == 0);
    CHECK(all[1].colour == 2);
    CHECK(all[2].colour == 1);
    CHECK(all[2].name == "Director 2");
}

TEST_CASE("Everybody learns who is there, at once and after each change") {
    Session session = startedSession();
    FakeClient anna(session, true, "Anna");
    run(session, 0.1, {&anna});
    {
        FakeClient ben(session, true, "Ben");
        run(session, 0.1, {&anna, &ben});
        CHECK(newest(ben, 0).name == "Anna");
        CHECK(newest(ben, 0).client == anna.id);
        CHECK(newest(anna, 1).name == "Ben");
        ben.send(protocol::SetName{"Benno"});
        run(session, 0.1, {&anna, &ben});
        CHECK(newest(anna, 1).name == "Benno");
        const std::size_t heard = anna.directors.size();
        run(session, 0.5, {&anna, &ben});
        CHECK(anna.directors.size() == heard);
        session.disconnect(ben.id);
    }
    run(session, 0.1, {&anna});
    CHECK(anna.directors.back().directors.size() == 1);
}

TEST_CASE("A director who was given one group directs it and its parts, and nothing else") {
    Session session = startedSession();
    REQUIRE(session.load("small", leftAndRight()).ok());
    FakeClient anna(session, true, "Anna"), ben(session, true, "Ben");
    run(session, 0.1, {&anna, &ben});
    anna.send(protocol::GiveGroup{ben.id, 2});
    run(session, 0.1, {&anna, &ben});
    CHECK(newest(anna, 1).groups == std::vector<std::uint32_t>{2});
    CHECK(ben.noticed("director") == "Anna gave you Right to direct.");
    ben.send(commandsOf(hold(2)));
    run(session, 0.1, {&anna, &ben});
    CHECK(ben.noticed("Commands").empty());
    ben.send(commandsOf(hold(1)));
    run(session, 0.1, {&anna, &ben});
    CHECK(ben.noticed("Commands").find("group 1 is not yours") != std::string::npos);
    // A finger that names no group takes theirs, however near the other one is.
    ben.touchAt(TouchPhase::Down, {-6, 0}, 0.1);
    run(session, 0.1, {&anna, &ben});
    CHECK(ben.frames.back().groups[0].controls.empty());
    ben.touchAt(TouchPhase::Up, {-6, 0}, 0.2);
    anna.send(commandsOf(hold(1)));
    ben.send(commandsOf(R"([{"kind":"split","group":2,"by":"line","points":[[6,-9],[6,9]]}])"));
    run(session, 0.3, {&anna, &ben});
    CHECK(anna.noticed("Commands").empty());
    REQUIRE(newest(ben, 1).groups.size() == 2);
    const std::uint32_t part = newest(ben, 1).groups[1];
    ben.send(commandsOf(hold(part)));
    ben.send(commandsOf(R"([{"kind":"merge","groups":[1,2]}])"));
    run(session, 0.1, {&anna, &ben});
    CHECK(ben.frames.back().groups.size() == 3);
    // Somebody else joins all of Ben's people to the other group: it is his as well then.
    anna.send(commandsOf(R"([{"kind":"merge","groups":[1,2]}])"));
    run(session, 0.3, {&anna, &ben});
    CHECK(newest(ben, 1).groups == std::vector<std::uint32_t>{1, part});
    REQUIRE(session.load("small", leftAndRight()).ok());
    run(session, 0.1, {&anna, &ben});
    CHECK(newest(ben, 1).groups.empty());
}

TEST_CASE("Only what is there can be given") {
    Session session = startedSession();
    FakeClient anna(session);
    run(session, 0.1, {&anna});
    anna.send(protocol::GiveGroup{anna.id, 9});
    anna.send(protocol::GiveGroup{anna.id + 5, 1});
    run(session, 0.1, {&anna});
    CHECK(anna.notices.size() == 2);
    CHECK(newest(anna, 0).groups.empty());
}

TEST_CASE("Who leaves with a finger down freezes nothing") {
    Session session = startedSession();
    FakeClient anna(session, true, "Anna");
    const std::uint32_t id = session.connect();
    FakeClient ben(session, true, "Ben");
    (void)id;
    run(session, 0.1, {&anna, &ben});
    ben.touchAt(TouchPhase::Down, {0, 0}, 0.1);
    run(session, 0.2, {&anna, &ben});
    REQUIRE(anna.frames.back().groups[0].controls.size() == 1);
    session.disconnect(ben.id);
    run(session, 0.5, {&anna});
    CHECK(anna.frames.back().groups[0].controls.empty());
    anna.touchAt(TouchPhase::Down, {0, 0}, 0.5);
    run(session, 0.2, {&anna});
    CHECK(anna.frames.back().groups[0].controls.size() == 1);
}
