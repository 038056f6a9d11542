// The body of a whole group, changed while a place is made.
#include <doctest.h>

#include <algorithm>
#include <string>

#include "muster/scenario.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

struct BodyDesk {
    Session session = startedSession();
    FakeClient client{session};

    void edit(const std::string& events) {
        client.send(edited("Body", 0, "[" + events + "]"));
        run(session, 0.1, {&client});
    }
    void give(const std::vector<protocol::GroupBodyEdit>& bodies, std::uint32_t gesture = 0) {
        client.send(protocol::Edit{"Body", gesture, {}, bodies});
        run(session, 0.1, {&client});
    }
    void undo() {
        client.send(protocol::UndoEdit{false});
        run(session, 0.1, {&client});
    }
    std::span<const Body> bodies() const { return session.world()->characters().body; }
    bool all(auto test) const { return std::ranges::all_of(bodies(), test); }
    /// The first group in the newest scene.
    protocol::SceneGroup shown() {
        run(session, 0.1, {&client});
        REQUIRE_FALSE(client.scenes.back().groups.empty());
        return client.scenes.back().groups[0];
    }
};

protocol::GroupBodyEdit radius(double metres, std::uint32_t group = 1) {
    return {group, metres, {}, {}};
}

}  // namespace

TEST_CASE("all of a group get a number of their body, and all other numbers stay") {
    BodyDesk desk;
    const std::uint32_t first = desk.session.world()->characters().id[0];
    desk.edit(R"({"kind":"bodies","ids":[)" + std::to_string(first) +
              R"(],"bodies":[{"mass":3,"class":2}]})");
    desk.give({radius(0.3)});
    CHECK(desk.all([](const Body& body) { return body.radius == 0.3; }));
    CHECK(desk.bodies()[0].mass == 3.0);
    CHECK(desk.bodies()[0].unitClass == 2);
    CHECK(desk.bodies()[1].mass == 1.0);
    desk.give({{1, {}, 1.2, std::uint8_t{1}}});
    CHECK(desk.all([](const Body& body) { return body.maxSpeed == 1.2 && body.unitClass == 1; }));
    CHECK(desk.bodies()[0].mass == 3.0);
    desk.undo();
    CHECK(desk.bodies()[0].unitClass == 2);
    CHECK(desk.bodies()[1].maxSpeed == 0.0);
    CHECK(desk.all([](const Body& body) { return body.radius == 0.3; }));
    CHECK(desk.client.notices.empty());
}

TEST_CASE("a slider that is dragged is one step of the history") {
    BodyDesk desk;
    for (const double metres : {0.2, 0.26, 0.31, 0.4}) desk.give({radius(metres)}, 7);
    CHECK(desk.client.history.undo == 1);
    CHECK(desk.all([](const Body& body) { return body.radius == 0.4; }));
    desk.give({radius(0.5)}, 8);
    CHECK(desk.client.history.undo == 2);
    desk.undo();
    CHECK(desk.all([](const Body& body) { return body.radius == 0.4; }));
    desk.undo();
    CHECK(desk.all([](const Body& body) { return body.radius == 0.0; }));
    CHECK(desk.client.history.undo == 0);
}

TEST_CASE("the scene tells what all in a group have in common, and the file keeps it") {
    BodyDesk desk;
    CHECK(desk.shown().body.radius == 0.25);
    CHECK(desk.shown().body.maxSpeed == 2.0);
    CHECK(desk.shown().body.unitClass == 0);
    CHECK(desk.shown().definition.bodies.empty());
    const std::uint32_t first = desk.session.world()->characters().id[0];
    desk.edit(R"({"kind":"bodies","ids":[)" + std::to_string(first) + R"(],"bodies":[{"class":2}]})");
    CHECK_FALSE(desk.shown().body.unitClass.has_value());
    CHECK(desk.shown().definition.bodies.empty());
    desk.give({{1, 0.3, 1.5, std::uint8_t{4}}});
    desk.edit(R"({"kind":"roles","group":1,"roles":[{"area":"rim","class":4}]})");
    CHECK(desk.shown().body.radius == 0.3);
    CHECK(desk.shown().body.unitClass == 4);
    REQUIRE(desk.shown().definition.bodies.size() == 1);
    CHECK(desk.shown().definition.bodies[0] == Body{.radius = 0.3, .maxSpeed = 1.5, .unitClass = 4});
    REQUIRE(desk.shown().definition.roles.size() == 1);
    CHECK(desk.shown().definition.roles[0].area == RoleArea::Rim);
    const auto saved = parseScenario(*desk.session.scenario(), "saved.json", "");
    REQUIRE(saved.ok());
    REQUIRE(saved->groups[0].bodies.size() == 1);
    CHECK(saved->groups[0].bodies[0].radius == 0.3);
    CHECK(saved->groups[0].bodies[0].unitClass == 4);
    CHECK(saved->groups[0].roles.size() == 1);
}

TEST_CASE("bad bodies of groups are answered by one sentence and change nothing") {
    BodyDesk desk;
    const auto says = [&](const protocol::Edit& edit, const char* what) {
        desk.client.notices.clear();
        desk.client.send(edit);
        run(desk.session, 1.1, {&desk.client});
        REQUIRE(desk.client.notices.size() == 1);
        CHECK(desk.client.notices[0].text.find(what) != std::string::npos);
    };
    says({"Body", 0, {}, {radius(7)}}, "radius");
    says({"Body", 0, {}, {radius(0.01)}}, "radius");
    says({"Body", 0, {}, {radius(0.3, 9)}}, "a group with people in it");
    says({"Body", 0, {}, {radius(0.3), radius(0.4)}}, "one for each group");
    says({"Body", 0, commandBytes(R"([{"kind":"nameGroup","group":1,"name":"A"}])"), {radius(0.3)}},
         "only one");
    CHECK(desk.all([](const Body& body) { return body == Body{}; }));
    CHECK(desk.client.history.undo == 0);
}
