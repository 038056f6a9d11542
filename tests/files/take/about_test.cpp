// What is said about a take: title, part and speeds.
#include <doctest.h>

#include <cmath>

#include "files/take/take_edits.h"
#include "files/take/take_encoder.h"
#include "files/take/take_format.h"

using namespace muster;

namespace {

WorldDef floorDef() {
    return {.name = "Floor", .box = {{-5, -5}, {5, 5}}, .groups = {{.count = 4}}};
}

void append(std::vector<std::uint8_t>& bytes, const std::vector<std::uint8_t>& record) {
    bytes.insert(bytes.end(), record.begin(), record.end());
}

}  // namespace

TEST_CASE("What is said about a take comes back, and the last word counts, also after the end") {
    TakeAbout first{.from = 12};
    TakeAbout last{.title = "Rain \"and\" wind",
                   .from = 30,
                   .to = 55,
                   .speeds = {{0.1, 0.25, 0.5, 0.05}, {0.5, 0.9, 2.0, 0.0}},
                   .camera = {{12, 1.5, -2.0, 30.0, 0.25, 1.1, false}, {40, 0.0, 3.0, 8.0, -3.0, 0.6, true}}};
    auto bytes = TakeEncoder::begin(floorDef());
    append(bytes, TakeEncoder::about(first));
    CHECK(parseTake(bytes, "a")->about == first);
    append(bytes, TakeEncoder::end({60, 7}));
    append(bytes, TakeEncoder::about(last));
    const auto take = parseTake(bytes, "a");
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    CHECK(take->about == last);
    CHECK(take->finished);
    append(bytes, TakeEncoder::mark({120, 7}));
    CHECK(parseTake(bytes, "a").status().code() == StatusCode::Corrupt);
}

TEST_CASE("The part of a take lies in it and holds a step") {
    TakeAbout about;
    CHECK(about.firstStep(100) == 0);
    CHECK(about.lastStep(100) == 100);
    about.from = 40;
    about.to = 60;
    CHECK(about.firstStep(100) == 40);
    CHECK(about.lastStep(100) == 60);
    CHECK(about.firstStep(50) == 40);
    CHECK(about.lastStep(50) == 50);
    CHECK(about.firstStep(30) == 29);
    CHECK(about.lastStep(30) == 30);
    CHECK(about.firstStep(0) == 0);
    CHECK(about.lastStep(0) == 0);
}

TEST_CASE("Speeds ease in and out, and are continuous") {
    TakeAbout about{.speeds = {{1.0, 3.0, 0.25, 0.5}, {4.0, 5.0, 4.0, 0.0}}};
    REQUIRE(about.check().ok());
    CHECK(about.speedAt(0.5) == 1.0);
    CHECK(about.speedAt(2.0) == 0.25);
    CHECK(about.speedAt(1.25) == doctest::Approx(0.625));
    CHECK(about.speedAt(4.5) == 4.0);
    CHECK(about.speedAt(5.0) == 1.0);
    for (double t = 0.0; t < 3.5; t += 0.001)
        CHECK(std::fabs(about.speedAt(t + 0.001) - about.speedAt(t)) < 0.005);
}

TEST_CASE("Unknown words are ignored, wrong ones named") {
    CHECK(readTakeAbout("{}", "a").value() == TakeAbout{});
    CHECK(readTakeAbout("{\"mood\": [1]}", "a").ok());
    const auto refused = [](const char* text, const char* words) {
        const auto read = readTakeAbout(text, "a");
        REQUIRE_FALSE(read.ok());
        INFO(read.status().message());
        CHECK(read.status().message().find(words) != std::string::npos);
    };
    refused("[]", "expected an object");
    refused("{\"title\": 3}", "title");
    refused("{\"from\": -1}", "from");
    refused("{\"from\": 1.5}", "from");
    refused("{\"to\": 5000000000}", "to");
    refused("{\"from\": 9, \"to\": 9}", "to");
    refused("{\"speeds\": 1}", "speeds");
    refused("{\"speeds\": [1]}", "speeds");
    refused("{\"speeds\": [{\"from\": 0, \"to\": \"x\"}]}", "to");
    refused("{\"speeds\": [{\"from\": 0, \"to\": 1, \"speed\": 0.01}]}", "speed");
    refused("{\"camera\": 1}", "camera");
    refused("{\"camera\": [{\"step\": 1, \"cut\": 3}]}", "cut");
    refused("{\"camera\": [{\"step\": 1, \"distance\": 0}]}", "camera[0].distance");
    refused("{\"camera\": [{\"step\": 2}, {\"step\": 2}]}", "camera[1].step");
}

TEST_CASE("Edits of people come back, and each bad one is named") {
    TakeAbout about{.title = "March"};
    about.edits = {{{3, 7},
                    {{1.5, {0.25, -2.0}, 2.0}, {4.0, {1.0, 0.0}, 60.0}},
                    {{2.0, 2.0}, {5.0, 4.0}},
                    {{"jog", 1.0, 2.5}},
                    {{9, {}, 1.6, 0.0, 3.0}, {0, {4.0, 5.0}, 2.5, 3.0, 4.0}}},
                   {{8}, {}, {}, {{"crawl", 0.0, 1.0}}, {}}};
    const auto read = readTakeAbout(writeTakeAbout(about), "take");
    REQUIRE_MESSAGE(read.ok(), read.status().message());
    CHECK(*read == about);
    const auto message = [](const char* edits) {
        const auto bad = readTakeAbout(std::string("{\"edits\":") + edits + "}", "take");
        CHECK_FALSE(bad.ok());
        return bad.status().message();
    };
    CHECK(message("3") == "take: edits: found the number 3, expected an array");
    CHECK(message(R"([{}])") == "take: people: found no array, expected the numbers of people");
    CHECK(message(R"([{"people":[]}])") == "take: edits[0].people: found nobody, expected somebody");
    CHECK(message(R"([{"people":[2,1]}])") ==
          "take: edits[0].people[1]: found 1, expected numbers above 0 in ascending order");
    CHECK(message(R"([{"people":[1]},{"people":[1]}])") ==
          "take: edits[1].people[0]: found 1, expected nobody with two edits");
    CHECK(message(R"([{"people":[1],"pins":[{"time":1},{"time":1.05}]}])") ==
          "take: edits[0].pins[1].time: found 1.05, expected 1.1 to 1000000");
    CHECK(message(R"([{"people":[1],"pins":[{"time":1,"x":1e8}]}])") ==
          "take: edits[0].pins[0].x: found 100000000, expected -10000 to 10000");
    CHECK(message(R"([{"people":[1],"pins":[{"time":1,"seconds":0}]}])") ==
          "take: edits[0].pins[0].seconds: found 0, expected 0.2 to 60");
    CHECK(message(R"([{"people":[1],"pins":[{"time":"now"}]}])") ==
          "take: pins: time: found the text \"now\", expected a number");
    CHECK(message(R"([{"people":[1],"clock":[{"time":1,"own":1}]}])") ==
          "take: edits[0].clock: found 1, expected no points, or two and more");
    CHECK(message(R"([{"people":[1],"clock":[{"time":1,"own":2},{"time":2,"own":1}]}])") ==
          "take: edits[0].clock[1].own: found 1, expected a clock that runs 1/3 to 8 times as fast");
    CHECK(message(R"([{"people":[1],"clips":[{"from":1,"to":2}]}])") ==
          "take: clips: name: found no text, expected the name of a clip");
    CHECK(message(R"([{"people":[1],"clips":[{"name":"run","from":3,"to":2}]}])") ==
          "take: edits[0].clips[0].to: found 2, expected later than from");
    CHECK(message(R"([{"people":[1],"looks":[{"height":1000,"from":1,"to":2}]}])") ==
          "take: edits[0].looks[0].height: found 1000, expected -10 to 100");
    CHECK(checkClips({{{1}, {}, {}, {{"fly", 0.0, 1.0}}, {}}}, {"run", "walk"}).message() ==
          "there is no clip \"fly\"; there are run, walk");
    // Not a number hides nowhere.
    about.edits = {{{1}, {{std::nan(""), {}, 2.0}}, {}, {}, {}}};
    CHECK_FALSE(about.check().ok());
}
