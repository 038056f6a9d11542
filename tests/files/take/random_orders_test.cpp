// Properties: whatever is ordered in whatever scene, nobody is lost or broken, and all of it replays.
#include <doctest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/take/take_encoder.h"
#include "files/take/unit_director.h"
#include "muster/take.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Scenes per property; more where MUSTER_SCENES says so.
std::uint64_t scenes(std::uint64_t usual) {
    const char* const wanted = std::getenv("MUSTER_SCENES");
    return wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : usual;
}

/// Submits a random command now and then; those that are malformed are refused at once.
void disturb(World& world, UnitDirector& director, Random& dice, std::vector<Command>& log) {
    if (dice.below(6) != 0) return;
    Command command{world.stepCount(), 1, static_cast<std::uint32_t>(log.size()), director.next(world)};
    if (world.submit(command).ok()) log.push_back(std::move(command));
}

/// Who lives, by what the world tells of joining and leaving.
class Register {
public:
    explicit Register(const World& world) {
        ids_.insert(world.characters().id.begin(), world.characters().id.end());
    }
    void read(const World& world) {
        for (const Event& event : world.events()) {
            if (event.kind == EventKind::Joined) CHECK(ids_.insert(event.subject).second);
            if (event.kind == EventKind::Left) CHECK(ids_.erase(event.subject) == 1);
        }
    }
    bool agrees(const World& world) const {
        const auto ids = world.characters().id;
        return std::is_sorted(ids.begin(), ids.end()) &&
               std::equal(ids.begin(), ids.end(), ids_.begin(), ids_.end());
    }

private:
    std::set<std::uint32_t> ids_;
};

void checkNumbers(const World& world) {
    const CharactersView c = world.characters();
    const Box box = inspect::environment(world).def().box;
    std::size_t members = 0;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView group = world.group(g);
        members += group.members.size();
        CHECK(static_cast<std::size_t>(group.count) == group.members.size());
        for (const std::int32_t i : group.members) CHECK(c.group[static_cast<std::size_t>(i)] == g);
        for (const Vec2 v : group.finalMesh) REQUIRE(isFinite(v));
        for (const Vec2 p : group.placePositions) REQUIRE(isFinite(p));
        std::set<std::int32_t> taken;
        for (const std::int32_t i : group.members) {
            const std::int32_t place = c.place[static_cast<std::size_t>(i)];
            REQUIRE(place < static_cast<std::int32_t>(group.placePositions.size()));
            if (place >= 0) CHECK(taken.insert(place).second);
        }
    }
    CHECK(members == c.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
        REQUIRE(isFinite(c.position[i]));
        REQUIRE(isFinite(c.velocity[i]));
        REQUIRE(isFinite(c.heading[i]));
        REQUIRE(isFinite(c.wantedVelocity[i]));
        CHECK(box.contains(c.position[i]));
    }
}

/// True for commands after which bodies may stand in each other or in a wall for a while.
bool crowds(const CommandBody& body) {
    return std::holds_alternative<AddCharacters>(body) || std::holds_alternative<ChangeCharacters>(body);
}

}  // namespace

TEST_CASE("random orders in random scenes: nobody is lost, no number breaks, no two stand in each other") {
    for (std::uint64_t seed = 1; seed <= scenes(12); ++seed) {
        CAPTURE(seed);
        World world = World::create(randomField(seed)).value();
        UnitDirector director(seed * 31 + 7, false);
        Random dice(seed * 17 + 3);
        std::vector<Command> log;
        Register alive(world);
        double clear = 0.0;  // From when on all must have parted [s].
        while (world.time() < 6.0) {
            const std::size_t before = log.size();
            disturb(world, director, dice, log);
            world.step();
            if (log.size() > before && crowds(log.back().body)) clear = world.time() + 2.0;
            CAPTURE(world.stepCount());
            alive.read(world);
            REQUIRE(alive.agrees(world));
            checkNumbers(world);
            if (world.time() < clear) continue;
            const CharactersView c = world.characters();
            const Environment& ground = inspect::environment(world);
            for (std::size_t i = 0; i < c.size(); ++i)
                CHECK(ground.distanceToObstacle(c.position[i]) > world.parameters().character.radius * 0.5);
            CHECK(world.contacts().overlapPairs == 0);
        }
    }
}

TEST_CASE("random orders replay from a take, and go on from snapshots, to the same bits") {
    for (std::uint64_t seed = 1; seed <= scenes(8); ++seed) {
        CAPTURE(seed);
        const WorldDef def = randomField(seed);
        World world = World::create(def).value();
        UnitDirector director(seed * 13 + 1);
        Random dice(seed + 5);
        std::vector<Command> log;
        std::vector<std::uint8_t> take = TakeEncoder::begin(def), middle;
        const auto append = [&](const std::vector<std::uint8_t>& bytes) {
            take.insert(take.end(), bytes.begin(), bytes.end());
        };
        std::size_t logged = 0;
        const std::uint32_t last = 160;
        while (world.stepCount() < last) {
            if (world.stepCount() == last / 2) {
                middle = world.snapshot();
                logged = log.size();
            }
            const std::size_t before = log.size();
            disturb(world, director, dice, log);
            if (log.size() > before) append(TakeEncoder::command(log.back()));
            world.step();
            append(TakeEncoder::events(world));
            if (world.stepCount() % 40 == 0) append(TakeEncoder::mark({world.stepCount(), world.hash()}));
        }
        const std::uint64_t hash = world.hash();
        append(TakeEncoder::end({last, hash}));
        const auto read = parseTake(take, "T");
        REQUIRE_MESSAGE(read.ok(), read.status().message());
        const auto replayed = replayTake(*read, 2);
        REQUIRE_MESSAGE(replayed.ok(), replayed.status().message());
        CHECK(replayed->hash == hash);

        auto restored = World::restore(middle);
        REQUIRE_MESSAGE(restored.ok(), restored.status().message());
        REQUIRE(world.rewind(middle).ok());
        for (World* again : {&*restored, &world}) {
            for (std::size_t k = logged; k < log.size(); ++k) REQUIRE(again->submit(log[k]).ok());
            while (again->stepCount() < last) again->step();
            CHECK(again->hash() == hash);
        }
    }
}

TEST_CASE("a command that is refused changes nothing") {
    int refused = 0;
    for (std::uint64_t seed = 1; seed <= scenes(6); ++seed) {
        CAPTURE(seed);
        World world = World::create(randomField(seed)).value();
        UnitDirector director(seed * 7 + 2);
        Random dice(seed);
        std::vector<Command> log;
        for (int s = 0; s < 120; ++s) {
            const std::size_t before = log.size();
            std::vector<std::uint8_t> snapshot;
            if (dice.below(3) == 0) snapshot = world.snapshot();
            disturb(world, director, dice, log);
            world.step();
            if (snapshot.empty() || log.size() == before || world.rejections().empty()) continue;
            ++refused;
            World other = World::restore(snapshot).value();
            other.step();
            CAPTURE(std::string(commandName(log.back())));
            CAPTURE(world.rejections()[0].status.message());
            CHECK(other.hash() == world.hash());
        }
    }
    CHECK(refused > 5);
}
