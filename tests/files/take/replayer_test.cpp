#include "files/take/replayer.h"

#include <doctest.h>

#include <string>
#include <vector>

#include "files/take/take_encoder.h"

using namespace muster;

namespace {

WorldDef replayedDef() {
    return {.box = {{-6, -5}, {6, 5}}, .cell = 0.5, .groups = {{.count = 4, .position = {-3, 0}}}};
}

Command setting(std::uint32_t step, std::uint32_t sequence, const char* name, double value) {
    return {step, 7, sequence, SetParameter{name, value}};
}

std::vector<Vec2> positions(const World& world) {
    const auto view = world.characters().position;
    return {view.begin(), view.end()};
}

/// A take put together by hand from a world that runs along, and where its characters were after each step.
struct Recording {
    Take take;
    std::vector<std::vector<Vec2>> path;
    World world;

    Recording() : world(*World::create(replayedDef())) {
        take.def = replayedDef();
        take.finished = true;
        path.push_back(positions(world));
    }
    void submit(const Command& command) {
        REQUIRE(world.submit(command).ok());
        take.commands.push_back(command);
    }
    void mark() {
        take.marks.push_back(
            {world.stepCount(), world.hash(), static_cast<std::uint32_t>(take.commands.size())});
    }
    void step(int count) {
        for (int i = 0; i < count; ++i) {
            world.step();
            path.push_back(positions(world));
        }
    }
};

/// Marks before the first step, two at one step with a command between them, and commands that wait.
Recording replayable() {
    Recording r;
    r.mark();
    r.submit(setting(0, 0, "character.maxSpeed", 0.7));
    r.submit({0, 7, 1, Touch{TouchPhase::Down, 1, {-3, 0}, 0.0, {}}});
    r.submit(setting(9, 2, "character.maxSpeed", 1.5));
    r.mark();
    r.step(5);
    r.submit({5, 7, 3, Touch{TouchPhase::Move, 1, {2, 1}, 5.0 / 60, {}}});
    r.step(7);
    r.mark();
    r.submit(setting(30, 4, "cost.gamma", 2.0));
    r.mark();
    r.step(8);
    r.mark();
    return r;
}

/// The code and the sentence with which a replay ends.
Status replay(const Take& take, std::uint32_t& compared) {
    World world = *World::create(take.def);
    Replayer replayer(take);
    Status status = replayer.compare(world);
    while (status.ok() && !replayer.atEnd(world)) {
        status = replayer.submit(world);
        if (!status.ok()) break;
        world.step();
        status = replayer.compare(world);
    }
    compared = replayer.compared();
    return status;
}

}  // namespace

TEST_CASE("a replay moves its characters as the recording did, step by step, through every mark") {
    const Recording r = replayable();
    REQUIRE(r.take.marks.size() == 5);
    // Commands that wait are state: the marks of one step differ.
    CHECK(r.take.marks[0].hash != r.take.marks[1].hash);
    CHECK(r.take.marks[2].hash != r.take.marks[3].hash);
    CHECK(r.path[20] != r.path[5]);

    World world = *World::create(r.take.def);
    Replayer replayer(r.take);
    CHECK(replayer.steps() == 20);
    CHECK(replayer.unmarked() == 0);
    CHECK(replayer.compared() == 0);
    CHECK(replayer.lastHash() == 0);
    REQUIRE(replayer.compare(world).ok());
    CHECK(replayer.compared() == 2);
    CHECK(replayer.lastHash() == r.take.marks[1].hash);
    while (!replayer.atEnd(world)) {
        REQUIRE(replayer.submit(world).ok());
        world.step();
        REQUIRE(replayer.compare(world).ok());
        const std::uint32_t done = world.stepCount();
        CHECK(positions(world) == r.path[done]);
        CHECK(replayer.compared() == (done < 12 ? 2 : (done < 20 ? 4 : 5)));
    }
    CHECK(world.stepCount() == 20);
    CHECK(replayer.lastHash() == r.world.hash());
    CHECK(world.hash() == r.world.hash());
}

TEST_CASE("each mark that is changed is found, and the sentence names its step") {
    const Recording r = replayable();
    for (std::size_t k = 0; k < r.take.marks.size(); ++k) {
        for (const std::uint64_t change : {std::uint64_t{1}, std::uint64_t{1} << 63}) {
            Take take = r.take;
            take.marks[k].hash ^= change;
            std::uint32_t compared = 0;
            const Status status = replay(take, compared);
            CAPTURE(k);
            CHECK(status.code() == StatusCode::Corrupt);
            CHECK(compared == k);
            CHECK(status.message().rfind("step " + std::to_string(take.marks[k].step) + ": ", 0) == 0);
            CHECK((status.message().find("all marks before it match") != std::string::npos) == (k > 0));
        }
    }
}

TEST_CASE("each command that is changed, dropped or moved behind a mark is found at the next mark") {
    const Recording r = replayable();
    const std::vector<std::size_t> nextMark{1, 1, 1, 2, 3};
    std::uint32_t compared = 0;
    for (std::size_t k = 0; k < r.take.commands.size(); ++k) {
        CAPTURE(k);
        Take changed = r.take;
        changed.commands[k].client = 8;
        CHECK(replay(changed, compared).code() == StatusCode::Corrupt);
        CHECK(compared == nextMark[k]);

        Take dropped = r.take;
        dropped.commands.erase(dropped.commands.begin() + static_cast<std::ptrdiff_t>(k));
        for (HashMark& mark : dropped.marks) mark.commands -= mark.commands > k ? 1 : 0;
        CHECK(replay(dropped, compared).code() == StatusCode::Corrupt);
        CHECK(compared == nextMark[k]);
    }
    // The last command that a mark counts, given after it instead.
    for (const std::size_t m : {1u, 3u}) {
        Take moved = r.take;
        --moved.marks[m].commands;
        CHECK(replay(moved, compared).code() == StatusCode::Corrupt);
        CHECK(compared == m);
    }
    CHECK(replay(r.take, compared).ok());
    CHECK(compared == 5);
}

TEST_CASE("commands that wait are ordered by the world, so those before one mark may change places") {
    // Before the second mark the world orders what waits by step, client and sequence.
    Recording r = replayable();
    std::uint32_t compared = 0;
    Take take = r.take;
    std::swap(take.commands[0], take.commands[2]);
    CHECK(replay(take, compared).ok());
    CHECK(compared == 5);
}

TEST_CASE("a command that the world refuses ends the replay with its client and step") {
    const Recording r = replayable();
    std::uint32_t compared = 0;
    Take late = r.take;
    late.commands[3].step = 1;  // Given in time, but not as replayable.
    CHECK(replay(late, compared).code() == StatusCode::Corrupt);
    Take past = r.take;
    past.commands[4].step = 2;  // It is given at step 12.
    const Status status = replay(past, compared);
    CHECK(status.code() == StatusCode::InvalidArgument);
    CHECK(status.message().rfind("command of client 7 for step 2: ", 0) == 0);
    CHECK(compared == 3);
    Take malformed = r.take;
    malformed.commands[1].body = Touch{TouchPhase::Down, 1, {NAN, 0}, 0.0, {}};
    CHECK(replay(malformed, compared).message().rfind("command of client 7 for step 0: ", 0) == 0);
    CHECK(compared == 1);
}

TEST_CASE("a take without commands and marks has no step") {
    Take take{.def = replayedDef()};
    World world = *World::create(take.def);
    Replayer replayer(take);
    CHECK(replayer.atEnd(world));
    CHECK(replayer.compare(world).ok());
    CHECK(replayer.steps() == 0);
    CHECK(replayer.unmarked() == 0);
    CHECK(replayer.compared() == 0);
}

namespace {

/// A take in which an order is carried out, as it is written record by record.
std::vector<std::uint8_t> takeWithArrival(std::vector<TakeEvent>& told) {
    World world = *World::create(replayedDef());
    std::vector<std::uint8_t> bytes = TakeEncoder::begin(replayedDef());
    const auto append = [&](const std::vector<std::uint8_t>& record) {
        bytes.insert(bytes.end(), record.begin(), record.end());
    };
    const Command order{20, 7, 0, SetPose{world.group(0).id, {2, 1}, 0.0}};
    REQUIRE(world.submit(order).ok());
    append(TakeEncoder::command(order));
    for (int s = 0; s < 400; ++s) {
        world.step();
        append(TakeEncoder::events(world));
        for (const Event& event : world.events())
            if (isOrderEvent(event.kind)) told.push_back({world.stepCount(), event});
    }
    append(TakeEncoder::end({world.stepCount(), world.hash()}));
    return bytes;
}

}  // namespace

TEST_CASE("what was told of orders stands in the take, and a replay tells it again") {
    std::vector<TakeEvent> told;
    const auto bytes = takeWithArrival(told);
    const auto take = parseTake(bytes, "memory");
    REQUIRE_MESSAGE(take.ok(), take.status().message());
    REQUIRE(told.size() == 1);
    CHECK(told[0].event.kind == EventKind::Arrived);
    CHECK(take->events == told);
    std::uint32_t compared = 0;
    CHECK(replay(*take, compared).ok());
    CHECK(compared == 1);
    // Takes of before have no events.
    Take before = *take;
    before.events.clear();
    CHECK(replay(before, compared).ok());
}

TEST_CASE("an event that the world does not tell ends the replay at its step") {
    std::vector<TakeEvent> told;
    const Take take = *parseTake(takeWithArrival(told), "memory");
    const auto refused = [&](const auto& tamper) {
        Take other = take;
        tamper(other.events[0]);
        std::uint32_t compared = 0;
        const Status status = replay(other, compared);
        CHECK(status.code() == StatusCode::Corrupt);
        return status.message();
    };
    const std::string step = std::to_string(told[0].step);
    CHECK(refused([](TakeEvent& e) { ++e.event.value; }) ==
          "step " + step + ": found no event 'arrived' of 1 with 5, expected it as recorded");
    CHECK(refused([](TakeEvent& e) { e.event.kind = EventKind::NoPath; }).rfind("step " + step, 0) == 0);
    CHECK(refused([](TakeEvent& e) { e.step -= 1; }).rfind("step " + std::to_string(told[0].step - 1), 0) ==
          0);
}

TEST_CASE("a record of an event that is none is refused") {
    std::vector<std::uint8_t> bytes = TakeEncoder::begin(replayedDef());
    const auto record = TakeEncoder::event({3, {EventKind::Swap, 1, 2, {}}});
    bytes.insert(bytes.end(), record.begin(), record.end());
    const auto take = parseTake(bytes, "memory");
    CHECK(take.status().code() == StatusCode::Corrupt);
    CHECK(take.status().message().find("found an event of unknown kind") != std::string::npos);
}
