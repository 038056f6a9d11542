// Questions about places: where would everybody stand, and who could not get there?
#include <doctest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A floor of 60 m by 40 m with 16 characters at -20, 0, a house of 12 m in the south, and a wall that cuts
/// off all beyond x = 21; with a gap of 0.4 m between two blocks in the south-west, if wanted.
Session houseSession(bool gap = false) {
    SessionDef def = sessionDef();
    Session session(def);
    WorldDef world = smallFloor();
    world.box = {{-30, -20}, {30, 20}};
    world.groups[0].position = {-20, 0};
    ObstacleDef house{.polygon = {{0, -18}, {12, -18}, {12, -6}, {0, -6}}};
    ObstacleDef wall{.polygon = {{20, -20}, {21, -20}, {21, 20}, {20, 20}}};
    ObstacleDef low{.polygon = {{-28, -18}, {-27, -18}, {-27, -17}, {-28, -17}}};
    ObstacleDef high{.polygon = {{-28, -16.6}, {-27, -16.6}, {-27, -16}, {-28, -16}}};
    world.obstacles = {house, wall};
    if (gap) world.obstacles.insert(world.obstacles.end(), {low, high});
    REQUIRE(session.load("small", world).ok());
    return session;
}

protocol::PlacesAsk ask(const FormationDef& formation, Vec2 at, double facing = 0.0) {
    protocol::PlacesAsk made;
    made.group = 1;
    made.formation = formation;
    made.x = at.x;
    made.y = at.y;
    made.facing = facing;
    return made;
}

FormationDef formationOf(FormationKind kind, std::vector<Vec2> points = {}) {
    FormationDef def;
    def.kind = kind;
    def.points = std::move(points);
    return def;
}

const FormationDef kColumn = formationOf(FormationKind::Column);

}  // namespace

TEST_CASE("Every place of a formation is answered, and nothing changes") {
    Session session = houseSession();
    FakeClient client(session);
    client.poll();
    const std::uint64_t hash = session.world()->hash();
    const std::uint32_t version = session.world()->group(0).formationVersion;
    client.send(protocol::AskPlaces{7, {ask(kColumn, {-20, 5}, 0.5 * 3.14159265358979)}});
    client.poll();
    CHECK(session.world()->hash() == hash);
    CHECK(session.world()->group(0).formationVersion == version);
    REQUIRE(client.places.size() == 1);
    CHECK(client.places[0].number == 7);
    REQUIRE(client.places[0].answers.size() == 1);
    const protocol::PlacesFrame& answer = client.places[0].answers[0];
    CHECK(answer.problem.empty());
    REQUIRE(answer.places.size() == 32);
    REQUIRE(answer.unfit.size() == 16);
    CHECK(std::count(answer.unfit.begin(), answer.unfit.end(), 0) == 16);
    // Two files of eight, facing +y, about the centre.
    float left = 1e9f, right = -1e9f, rear = 1e9f, front = -1e9f;
    for (std::size_t i = 0; i < 32; i += 2) {
        left = std::min(left, answer.places[i]), right = std::max(right, answer.places[i]);
        rear = std::min(rear, answer.places[i + 1]), front = std::max(front, answer.places[i + 1]);
    }
    CHECK(right - left == doctest::Approx(1.0));
    CHECK(front - rear == doctest::Approx(7.0));
    CHECK(front + rear == doctest::Approx(10.0));
}

TEST_CASE("Places in obstacles, outside, and beyond a wall are told apart") {
    Session session = houseSession(true);
    FakeClient client(session);
    protocol::PlacesAsk given{.group = 1, .places = {-10, 0, 6, -12, 25, 3, 40, 0, -27.5, -16.8, 0.0, -4.0}};
    client.send(protocol::AskPlaces{1, {given, ask(kColumn, {6, -6})}});
    client.poll();
    REQUIRE(client.places.size() == 1);
    REQUIRE(client.places[0].answers.size() == 2);
    const auto bar = [&](std::size_t k) {
        return static_cast<Standing>(client.places[0].answers[0].unfit[k]);
    };
    CHECK(bar(0) == Standing::InPlace);
    CHECK(bar(1) == Standing::Obstacle);
    CHECK(bar(2) == Standing::NoWay);
    CHECK(bar(3) == Standing::Outside);
    CHECK(bar(4) == Standing::Narrow);
    CHECK(bar(5) == Standing::InPlace);
    CHECK(client.places[0].answers[0].places.size() == 12);
    // A column along the wall of the house: one of its files stands inside, the other outside.
    const auto& column = client.places[0].answers[1].unfit;
    CHECK(std::count(column.begin(), column.end(), 0) == 8);
    CHECK(std::count(column.begin(), column.end(), static_cast<std::uint8_t>(Standing::NoWay)) == 0);
}

TEST_CASE("A formation that cannot be made is answered by its problem, one of nobody is left out") {
    Session session = houseSession();
    FakeClient client(session);
    protocol::PlacesAsk nobody = ask(kColumn, {0, 0});
    nobody.group = 5;
    client.send(
        protocol::AskPlaces{1, {nobody, ask(formationOf(FormationKind::Points, {{0, 0}, {1, 0}}), {0, 0})}});
    client.poll();
    CHECK(client.notices.empty());
    REQUIRE(client.places.size() == 1);
    REQUIRE(client.places[0].answers.size() == 1);
    CHECK(client.places[0].answers[0].places.empty());
    CHECK(client.places[0].answers[0].problem == "found 2 points for 16 places");
}

TEST_CASE("Bad questions about places are refused") {
    Session session = houseSession();
    FakeClient client(session);
    protocol::PlacesAsk odd{.group = 1, .places = {1, 2, 3}};
    client.send(protocol::AskPlaces{1, {odd}});
    client.send(protocol::AskPlaces{2, {ask(kColumn, {std::numeric_limits<double>::infinity(), 0})}});
    client.send(protocol::AskPlaces{3, std::vector(17, ask(kColumn, {0, 0}))});
    client.poll();
    CHECK(client.places.empty());
    REQUIRE(client.notices.size() == 3);
    CHECK(client.notices[0].text == "places that are not finite pairs");
    CHECK(client.notices[1].text == "places about a centre that is not finite");
    CHECK(client.notices[2].text == "found 17 questions about places, expected at most 16");
}
