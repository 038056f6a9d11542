// One scenario by the C API and by the C++ API: the same hashes, events and sentences.
#include <doctest.h>

#include <cstring>

#include "bindings/c/both_worlds.h"

using namespace muster;

TEST_SUITE("the C API of worlds") {
    TEST_CASE("orders, touches and edits give the same states as by the C++ API") {
        BothWorlds both(makeDef());
        const std::vector<std::pair<std::uint32_t, CommandBody>> script = sampleScript(both.engine());
        std::uint32_t sequence = 0;
        std::size_t next = 0;
        std::size_t events = 0, rejections = 0;
        for (std::uint32_t step = 0; step < 240; ++step) {
            for (; next < script.size() && script[next].first == step; ++next)
                CHECK(both.submit({step, 1, sequence++, script[next].second}) == MUSTER_OK);
            both.step();
            REQUIRE(both.hash() == both.engine().hash());
            events += both.compareEvents();
            rejections += both.compareRejections();
        }
        CHECK(next == script.size());
        CHECK(events > 5);
        CHECK(rejections == 1);
    }

    TEST_CASE("characters and groups are read without a copy and are those of the engine") {
        BothWorlds both(makeDef());
        for (int step = 0; step < 30; ++step) both.step();
        MusterCharacters characters = muster_default_characters();
        REQUIRE(muster_world_characters(both.id(), &characters) == MUSTER_OK);
        const CharactersView view = both.engine().characters();
        REQUIRE(characters.count == static_cast<int>(view.size()));
        for (std::size_t i = 0; i < view.size(); ++i) {
            CHECK(characters.id[i] == view.id[i]);
            CHECK(characters.position[i].x == view.position[i].x);
            CHECK(characters.position[i].y == view.position[i].y);
            CHECK(characters.place[i] == view.place[i]);
            CHECK(characters.body[i].mass == view.body[i].mass);
            CHECK(characters.phase[i] == static_cast<int>(view.phase[i]));
            CHECK(characters.body[i].maxSpeed == view.body[i].maxSpeed);
            CHECK(characters.goal[i] == view.goal[i]);
        }
        MusterGroup group = muster_default_group();
        REQUIRE(muster_world_group(both.id(), 1, &group) == MUSTER_OK);
        const GroupView other = both.engine().group(1);
        CHECK(std::string(group.name) == other.name);
        CHECK(group.id == other.id.value);
        REQUIRE(group.vertexCount == static_cast<int>(other.finalMesh.size()));
        for (std::size_t i = 0; i < other.finalMesh.size(); ++i) {
            CHECK(group.finalMesh[i].x == other.finalMesh[i].x);
            CHECK(group.restMesh[i].y == other.restMesh[i].y);
        }
        REQUIRE(group.triangleCount == static_cast<int>(other.triangles.size()));
        CHECK(std::memcmp(group.triangles, other.triangles.data(), other.triangles.size_bytes()) == 0);
        REQUIRE(group.placeCount == other.count);
        CHECK(group.meshPlaces[3].weight[1] == other.meshPlaces[3].weight[1]);
        CHECK(group.meanLag == other.meanLag);
    }

    TEST_CASE("a snapshot taken in C goes on in C++, and the reverse") {
        BothWorlds both(makeDef());
        for (int step = 0; step < 20; ++step) both.step();
        MusterBuffer bytes{};
        REQUIRE(muster_world_snapshot(both.id(), &bytes) == MUSTER_OK);
        Result<World> restored = World::restore({bytes.data, bytes.size});
        REQUIRE(restored.ok());
        CHECK(restored->hash() == both.engine().hash());
        const std::vector<std::uint8_t> snapshot = both.engine().snapshot();
        for (int step = 0; step < 20; ++step) both.step();
        const std::uint64_t later = both.hash();
        MusterWorldId other{};
        REQUIRE(muster_world_restore(snapshot.data(), snapshot.size(), 1, &other) == MUSTER_OK);
        REQUIRE(muster_world_rewind(both.id(), bytes.data, bytes.size) == MUSTER_OK);
        for (int step = 0; step < 20; ++step) {
            CHECK(muster_world_step(other) == MUSTER_OK);
            CHECK(muster_world_step(both.id()) == MUSTER_OK);
        }
        std::uint64_t hash = 0;
        CHECK(muster_world_hash(other, &hash) == MUSTER_OK);
        CHECK(hash == later);
        CHECK(both.hash() == later);
        muster_free_buffer(&bytes);
        CHECK(bytes.data == nullptr);
        CHECK(muster_world_destroy(other) == MUSTER_OK);
    }

    TEST_CASE("a forecast and a way are those of the C++ API") {
        BothWorlds both(makeDef());
        for (int step = 0; step < 5; ++step) both.step();
        const Order order = Order::move({10.0, 8.0}, 1.0);
        MusterOrder same = muster_default_order();
        same.target = {10.0, 8.0};
        same.hasFacing = true;
        same.facing = 1.0;
        const OrderForecast expected = both.engine().forecast(both.engine().group(0).id, order);
        MusterForecast forecast = muster_default_forecast();
        REQUIRE(muster_world_forecast(both.id(), 1, &same, &forecast) == MUSTER_OK);
        CHECK(forecast.arrives == expected.arrives);
        CHECK(forecast.seconds == expected.seconds);
        REQUIRE(forecast.wayCount == static_cast<int>(expected.way.size()));
        for (std::size_t i = 0; i < expected.way.size(); ++i) CHECK(forecast.way[i].x == expected.way[i].x);

        const std::vector<Vec2> way = both.engine().wayAhead(3);
        const MusterVec2* points = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_world_way_ahead(both.id(), 3, &points, &count) == MUSTER_OK);
        REQUIRE(count == static_cast<int>(way.size()));
        REQUIRE(count >= 2);
        CHECK(points[count - 1].y == way.back().y);

        const std::vector<Standing> standings = both.engine().standings();
        const std::uint8_t* each = nullptr;
        REQUIRE(muster_world_standings(both.id(), &each, &count) == MUSTER_OK);
        REQUIRE(count == static_cast<int>(standings.size()));
        for (int i = 0; i < count; ++i) CHECK(each[i] == static_cast<std::uint8_t>(standings[i]));
    }

    TEST_CASE("the ground is read back as it was defined") {
        BothWorlds both(makeDef());
        const MusterObstacleId* ids = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_world_obstacle_ids(both.id(), &ids, &count) == MUSTER_OK);
        REQUIRE(count == 2);
        MusterObstacle obstacle = muster_default_obstacle();
        REQUIRE(muster_world_obstacle(both.id(), ids[1], &obstacle) == MUSTER_OK);
        CHECK(std::string(obstacle.def.name) == "Gate");
        REQUIRE(obstacle.def.path.waypointCount == 2);
        CHECK(obstacle.def.path.waypoints[1].position.y == 3.0);
        CHECK(obstacle.outlineCount == 4);
        REQUIRE(muster_world_patch_ids(both.id(), &ids, &count) == MUSTER_OK);
        REQUIRE(count == 1);
        MusterPatch patch = muster_default_patch();
        REQUIRE(muster_world_patch(both.id(), ids[0], &patch) == MUSTER_OK);
        CHECK(std::string(patch.def.name) == "Net");
        CHECK(patch.def.motion == 3);
        const MusterItemDef* items = nullptr;
        const std::uint8_t* collected = nullptr;
        REQUIRE(muster_world_items(both.id(), &items, nullptr, &collected, &count) == MUSTER_OK);
        REQUIRE(count == 1);
        CHECK(items[0].position.x == 9.0);
        CHECK(collected[0] == 0);
        const MusterCheckpointDef* checkpoints = nullptr;
        REQUIRE(muster_world_checkpoints(both.id(), &checkpoints, nullptr, nullptr, &count) == MUSTER_OK);
        REQUIRE(count == 1);
        CHECK(checkpoints[0].formation.kind == MUSTER_FORMATION_COLUMN);
        CHECK(checkpoints[0].share == 0.25);
    }

    TEST_CASE("areas are read back with what they have seen") {
        WorldDef def = makeDef();
        def.ring = true;
        BothWorlds both(def);
        for (int step = 0; step < 90; ++step) both.step();
        const MusterArea* areas = nullptr;
        int count = 0;
        REQUIRE(muster_world_areas(both.id(), &areas, &count) == MUSTER_OK);
        REQUIRE(count == 2);
        CHECK(areas[0].id == 1);
        CHECK(std::string(areas[0].def.name) == "Door");
        CHECK(areas[0].def.kind == MUSTER_AREA_EXIT);
        CHECK(areas[1].def.kind == MUSTER_AREA_SOURCE);
        CHECK(areas[1].group == both.engine().group(1).id.value);
        CHECK(areas[1].def.timetable[0].count == 2);
        CHECK(areas[1].def.polygon.points[2].y == 14.0);
        CHECK(areas[1].passed == both.engine().area(1).count.passed);
        CHECK(areas[1].waiting == both.engine().area(1).count.waiting);
        bool ring = false;
        CHECK(muster_world_ring(both.id(), &ring) == MUSTER_OK);
        CHECK(ring);
    }
}
