// The studio without a server, as a page sees it: a session, the shelf and the scenarios behind messages and
// requests.
#include "page_engine.h"

#include <doctest.h>

#include <filesystem>
#include <string>

#include "base/text_file.h"
#include "json/json.h"
#include "muster/take.h"
#include "studio/session/fake_client.h"
#include "temporary_folder.h"

using namespace muster;
using muster::testing::FakeClient;
namespace fs = std::filesystem;

namespace {

constexpr double kLook = 1.0 / 60.0;

std::string floorText(const std::string& name, int count) {
    return R"({"format":"muster-scenario","version":1,"name":")" + name +
           R"(","box":[[-12,-12],[12,12]],"groups":[{"count":)" + std::to_string(count) + "}]}";
}

/// Folders with two scenarios and one that cannot be read.
struct Folders : testing::TemporaryFolder {
    Folders() : TemporaryFolder("page_engine") {
        put("scenarios/floor.json", floorText("Floor", 16));
        put("scenarios/more/hall.json", floorText("Hall", 25));
        put("scenarios/more/broken.json", "{\"format\":");
    }
    PageEngineDef def(const std::string& scenario = "", std::int32_t threads = 1) const {
        return {.scenarioFolder = (base / "scenarios").string(),
                .takesFolder = (base / "takes").string(),
                .scenario = scenario,
                .version = "of a test",
                .threads = threads};
    }
    std::unique_ptr<PageEngine> open(const std::string& scenario = "", std::int32_t threads = 1) const {
        auto engine = PageEngine::open(def(scenario, threads));
        REQUIRE_MESSAGE(engine.ok(), engine.status().message());
        return std::move(engine).value();
    }
};

/// Lets time pass as a page's worker does.
void pass(PageEngine& engine, double seconds, FakeClient& client) {
    for (double passed = 0.0; passed < seconds; passed += kLook) {
        engine.advance(kLook);
        client.poll();
    }
}

HttpAnswer ask(PageEngine& engine, const std::string& method, const std::string& target,
               const std::string& body = "") {
    return engine.ask(method, target, {reinterpret_cast<const std::uint8_t*>(body.data()), body.size()});
}

Json jsonOf(const HttpAnswer& answer) {
    REQUIRE_MESSAGE(answer.status == 200, answer.body);
    auto value = parseJson(answer.body, "answer");
    REQUIRE_MESSAGE(value.ok(), value.status().message());
    return std::move(value).value();
}

/// Drags a corner of the formation while half a second passes.
void drag(PageEngine& engine, FakeClient& client) {
    client.touchAt(TouchPhase::Down, {0.2, 0.0}, 1.0);
    for (int i = 1; i <= 30; ++i) {
        client.touchAt(TouchPhase::Move, {0.2 + 0.1 * i, 0.05 * i}, 1.0 + kLook * i);
        pass(engine, kLook, client);
    }
    client.touchAt(TouchPhase::Up, {3.2, 1.5}, 1.6);
    pass(engine, 1.0, client);
}

/// Records for so many seconds; the name of the take.
std::string record(PageEngine& engine, FakeClient& client, double seconds) {
    client.send(protocol::Record{true});
    pass(engine, seconds, client);
    client.send(protocol::Record{false});
    pass(engine, 0.1, client);
    REQUIRE_FALSE(client.kept.empty());
    return client.kept.back().name;
}

}  // namespace

TEST_CASE("a page is greeted with the scenarios of the folder and sees the first one move") {
    const Folders folders;
    const auto engine = folders.open();
    FakeClient client(engine->session());
    pass(*engine, 0.5, client);
    REQUIRE(client.welcome.has_value());
    CHECK(client.welcome->version == "of a test");
    REQUIRE(client.welcome->scenarios.size() == 2);
    CHECK(client.welcome->scenarios[0].name == "floor");
    CHECK(client.welcome->scenarios[1].name == "more/hall");
    REQUIRE_FALSE(client.frames.empty());
    CHECK(client.frames.back().step > 20);
    client.send(protocol::LoadScenario{"more/hall"});
    pass(*engine, 0.3, client);
    CHECK(client.page.x.size() == 25);
}

TEST_CASE("what cannot be opened is told in a sentence") {
    const Folders folders;
    CHECK(PageEngine::open(folders.def("harbour")).status().message() == "no scenario is called 'harbour'");
    CHECK(PageEngine::open(folders.def("more/broken")).status().message() ==
          "no scenario is called 'more/broken'");
    const auto engine = folders.open();
    FakeClient client(engine->session());
    pass(*engine, 0.1, client);
    client.send(protocol::LoadScenario{"harbour"});
    pass(*engine, 0.1, client);
    REQUIRE_FALSE(client.notices.empty());
    CHECK(client.notices.back().text.find("harbour") != std::string::npos);
    CHECK(client.page.x.size() == 16);
}

TEST_CASE("the engine asks to be called again in time, and at once while a step is due") {
    const Folders folders;
    const auto engine = folders.open();
    FakeClient client(engine->session());
    CHECK(engine->advance(-1.0) >= 0.0);
    for (int i = 0; i < 200; ++i) {
        const double wait = engine->advance(0.001 * (i % 40));
        CHECK(wait >= 0.0);
        CHECK(wait <= 0.25);
        client.poll();
    }
    const std::uint32_t before = client.frames.back().step;
    // A page that slept for a second gets its steps one by one.
    engine->advance(1.0);
    client.poll();
    CHECK(client.frames.back().step <= before + 2);
}

TEST_CASE("threads change nothing that a page sees") {
    const Folders folders;
    const auto one = folders.open("more/hall", 1);
    const auto three = folders.open("more/hall", 3);
    FakeClient first(one->session()), second(three->session());
    drag(*one, first);
    drag(*three, second);
    REQUIRE(first.page.x.size() == 25);
    CHECK(first.frames.back().step == second.frames.back().step);
    CHECK(first.page.x == second.page.x);
    CHECK(first.page.y == second.page.y);
    const HttpAnswer a = ask(*one, "GET", "/take"), b = ask(*three, "GET", "/take");
    REQUIRE(a.status == 200);
    CHECK(a.body == b.body);
}

TEST_CASE("a recording lies on the shelf, is given away, replayed, renamed and removed") {
    const Folders folders;
    const auto engine = folders.open();
    FakeClient client(engine->session());
    pass(*engine, 0.2, client);
    CHECK(jsonOf(ask(*engine, "GET", "/takes")).find("takes")->size() == 0);
    const std::string name = record(*engine, client, 1.0);
    const Json list = jsonOf(ask(*engine, "GET", "/takes"));
    REQUIRE(list.find("takes")->size() == 1);
    const HttpAnswer given = ask(*engine, "GET", "/takes/" + name);
    REQUIRE(given.status == 200);
    CHECK(given.path.empty());  // A page cannot open files.
    const auto take = parseTake({reinterpret_cast<const std::uint8_t*>(given.body.data()), given.body.size()},
                                "given");
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    CHECK(take->steps() > 50);
    CHECK(take->finished);
    CHECK(ask(*engine, "POST", "/takes/" + name + "/open").status == 200);
    pass(*engine, 0.2, client);
    REQUIRE_FALSE(client.takes.empty());
    CHECK(client.takes.back().open);
    CHECK(ask(*engine, "DELETE", "/takes/" + name).status == 200);
    CHECK(jsonOf(ask(*engine, "GET", "/takes")).find("takes")->size() == 0);
    CHECK(ask(*engine, "POST", "/takes/" + name + "/restore").status == 200);
    CHECK(jsonOf(ask(*engine, "GET", "/takes")).find("takes")->size() == 1);
    // The same bytes are not put there twice.
    CHECK(ask(*engine, "POST", "/takes", given.body).status == 200);
    CHECK(jsonOf(ask(*engine, "GET", "/takes")).find("takes")->size() == 1);
}

TEST_CASE("requests that lead nowhere are answered in a sentence") {
    const Folders folders;
    const auto engine = folders.open();
    const auto status = [&](const char* method, const char* target, const std::string& body = "") {
        const HttpAnswer answer = ask(*engine, method, target, body);
        CHECK(!answer.body.empty());
        return answer.status;
    };
    CHECK(status("GET", "/elsewhere") == 404);
    CHECK(status("PUT", "/takes") == 405);
    CHECK(status("GET", "/takes/none.take") == 404);
    CHECK(status("GET", "/takes/../page.take") == 405);
    CHECK(status("POST", "/takes/none.take/open") == 404);
    CHECK(status("POST", "/takes", "no take") == 400);
    CHECK(status("GET", "/bodies/none.glb") == 404);
    CHECK(status("POST", "/scenario?name=x", "{") == 400);
    CHECK(status("POST", "/handover", "no world") == 400);
    CHECK(status("PATCH", "/takes/none.take", std::string(std::size_t{20} << 10, ' ')) == 413);
    // Exports are made by other workers.
    CHECK(status("POST", "/exports", "{}") == 404);
}

TEST_CASE("a place is given as a scenario and opened from one") {
    const Folders folders;
    const auto engine = folders.open();
    FakeClient client(engine->session());
    pass(*engine, 0.1, client);
    const HttpAnswer place = ask(*engine, "GET", "/scenario");
    REQUIRE(place.status == 200);
    CHECK(jsonOf(place).find("format")->text() == "muster-scenario");
    CHECK(ask(*engine, "POST", "/scenario?name=harbour", floorText("Harbour", 9)).status == 200);
    pass(*engine, 0.2, client);
    CHECK(client.page.x.size() == 9);
    // A place with a fault changes nothing.
    const HttpAnswer refused = ask(*engine, "POST", "/scenario?name=harbour", floorText("Harbour", -4));
    CHECK(refused.status == 400);
    CHECK(refused.body.find("count") != std::string::npos);
    pass(*engine, 0.2, client);
    CHECK(client.page.x.size() == 9);
    CHECK(ask(*engine, "POST", "/scenario?name=b", place.body).status == 200);
    pass(*engine, 0.2, client);
    CHECK(client.page.x.size() == 16);
}

TEST_CASE("bodies are binary glTF files") {
    const Folders folders;
    const auto engine = folders.open();
    for (const char* name : {"body-1", "body-1-far", "body-2", "body-2-far"}) {
        const HttpAnswer answer = ask(*engine, "GET", std::string("/bodies/") + name + ".glb");
        REQUIRE(answer.status == 200);
        CHECK(answer.type == "model/gltf-binary");
        CHECK(answer.body.substr(0, 4) == "glTF");
    }
}

TEST_CASE("another engine goes on with the world of this one") {
    const Folders folders;
    const auto before = folders.open();
    FakeClient client(before->session());
    drag(*before, client);
    const HttpAnswer handover = ask(*before, "GET", "/handover");
    REQUIRE(handover.status == 200);
    const auto after = folders.open("more/hall");
    REQUIRE(ask(*after, "POST", "/handover", handover.body).status == 200);
    // The fingers of whoever directed are let go there, as they are here when that page goes.
    before->session().disconnect(client.id);
    FakeClient here(before->session()), there(after->session());
    pass(*before, 1.2, here);
    pass(*after, 1.2, there);
    REQUIRE(there.page.x.size() == 16);
    const auto marksOf = [](PageEngine& engine) {
        const HttpAnswer whole = ask(engine, "GET", "/take");
        const auto take = parseTake(
            {reinterpret_cast<const std::uint8_t*>(whole.body.data()), whole.body.size()}, "whole");
        REQUIRE_MESSAGE(take.ok(), take.status().message());
        return take->marks;
    };
    // The last mark is of the moment when the take was asked for.
    const auto first = marksOf(*before), second = marksOf(*after);
    REQUIRE(first.size() >= 3);
    REQUIRE(second.size() >= 3);
    for (std::size_t i = 0; i + 1 < std::min(first.size(), second.size()); ++i) {
        CHECK(first[i].step == second[i].step);
        CHECK(first[i].hash == second[i].hash);
    }
}
