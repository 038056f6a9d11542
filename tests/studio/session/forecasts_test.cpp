// Questions about orders: would they arrive, by which way, when?
#include <doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "muster/scenario.h"
#include "studio/session/fake_client.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A floor of 60 m by 40 m with 16 characters at -20, 0, a wall from the south edge to y = 10, and a house of
/// 12 m.
Session walledSession() {
    SessionDef def = sessionDef();
    Session session(def);
    WorldDef world = smallFloor();
    world.box = {{-30, -20}, {30, 20}};
    world.groups[0].position = {-20, 0};
    ObstacleDef wall{.polygon = {{-1, -20}, {1, -20}, {1, 10}, {-1, 10}}};
    ObstacleDef house{.polygon = {{16, -18}, {28, -18}, {28, -6}, {16, -6}}};
    world.obstacles = {wall, house};
    REQUIRE(session.load("small", world).ok());
    return session;
}

protocol::ForecastAsk ask(const Order& order) {
    protocol::ForecastAsk made{.group = 1};
    made.asked = order;
    return made;
}

const Order kEast = Order::move({20, 0});

double wayLength(const protocol::ForecastFrame& frame) {
    double sum = 0.0;
    for (std::size_t i = 2; i + 1 < frame.way.size(); i += 2)
        sum += std::hypot(frame.way[i] - frame.way[i - 2], frame.way[i + 1] - frame.way[i - 1]);
    return sum;
}

}  // namespace

TEST_CASE("A forecast tells way and time, and changes nothing") {
    Session session = walledSession();
    FakeClient client(session);
    client.poll();
    const std::uint64_t hash = session.world()->hash();
    client.send(protocol::AskForecasts{7, {ask(kEast)}});
    client.poll();
    CHECK(session.world()->hash() == hash);
    REQUIRE(client.forecasts.size() == 1);
    CHECK(client.forecasts[0].number == 7);
    REQUIRE(client.forecasts[0].answers.size() == 1);
    const protocol::ForecastFrame& answer = client.forecasts[0].answers[0];
    CHECK(answer.arrives);
    CHECK(answer.x == doctest::Approx(20.0));
    // At least by the corners of the wall: 22.2 m twice and 2 m, beside 40 m straight through it.
    const double shortest = 2.0 * std::hypot(19.0, 10.0) + 2.0;
    CHECK(wayLength(answer) > shortest);
    CHECK(wayLength(answer) < 1.4 * shortest);
    const double speed = session.world()->parameters().character.maxSpeed;
    CHECK(answer.seconds > shortest / speed);
    CHECK(answer.seconds < 4.0 * shortest / speed);
}

TEST_CASE("A forecast may begin where another order would end, and be of an order in the queue") {
    Session session = walledSession();
    FakeClient client(session);
    client.send(commandsOf(R"([{"kind":"move","group":1,"x":20,"y":0},
                         {"kind":"move","group":1,"mode":"append","x":20,"y":15}])"));
    session.elapse(0.1);
    while (session.stepDue()) session.step();
    client.poll();
    const std::vector<QueuedOrder> orders = client.page.orders[0];
    REQUIRE(orders.size() == 2);
    protocol::ForecastAsk second{.group = 1, .order = orders[1].id, .placed = true, .x = 20.0};
    client.send(protocol::AskForecasts{1, {second}});
    client.poll();
    REQUIRE(client.forecasts.back().answers.size() == 1);
    const protocol::ForecastFrame& answer = client.forecasts.back().answers[0];
    CHECK(answer.order == orders[1].id);
    CHECK(answer.arrives);
    CHECK(wayLength(answer) == doctest::Approx(15.0).epsilon(0.02));
    CHECK(answer.way[0] == 20.0f);
}

TEST_CASE("What cannot be reached is said, and what is gone is left out") {
    Session session = walledSession();
    FakeClient client(session);
    const Order inside = Order::move({22, -12});  // The middle of the house.
    protocol::ForecastAsk gone;
    gone.group = 1;
    gone.order = 99;
    protocol::ForecastAsk nobody = ask(kEast);
    nobody.group = 5;
    client.send(protocol::AskForecasts{1, {gone, nobody, ask(inside)}});
    client.poll();
    REQUIRE(client.forecasts.size() == 1);
    REQUIRE(client.forecasts[0].answers.size() == 1);
    CHECK_FALSE(client.forecasts[0].answers[0].arrives);
    CHECK(std::isinf(client.forecasts[0].answers[0].seconds));
    CHECK(client.notices.empty());
}

TEST_CASE("Bad questions are refused with one sentence each") {
    Session session = walledSession();
    FakeClient client(session);
    protocol::ForecastAsk nowhere = ask(kEast);
    nowhere.placed = true;
    nowhere.x = std::numeric_limits<double>::quiet_NaN();
    client.send(protocol::AskForecasts{1, {nowhere}});
    Order endless = kEast;
    endless.pace = std::numeric_limits<double>::infinity();
    protocol::ForecastAsk none;
    none.group = 1;
    client.send(protocol::AskForecasts{2, {none}});
    client.send(protocol::AskForecasts{3, {ask(endless)}});
    client.send(protocol::AskForecasts{4, std::vector(17, ask(kEast))});
    client.poll();
    CHECK(client.forecasts.empty());
    REQUIRE(client.notices.size() == 4);
    CHECK(client.notices[0].text == "a forecast from a place that is not finite");
    CHECK(client.notices[1].text == "a forecast of no order");
    CHECK(client.notices[2].text.find("pace") != std::string::npos);
    CHECK(client.notices[3].text == "found 17 forecasts, expected at most 16");
}

TEST_CASE("A client gets so many forecasts a second") {
    Session session = walledSession();
    FakeClient client(session);
    for (std::uint32_t k = 0; k < 6; ++k) client.send(protocol::AskForecasts{k, std::vector(10, ask(kEast))});
    client.poll();
    CHECK(client.forecasts.size() == 6);
    client.send(protocol::AskForecasts{7, {ask(kEast)}});
    client.poll();
    CHECK(client.forecasts.size() == 6);
    CHECK(client.noticed("AskForecasts") == "more than 60 forecasts a second");
    session.elapse(0.5);
    client.send(protocol::AskForecasts{8, {ask(kEast)}});
    client.poll();
    CHECK(client.forecasts.back().number == 8);
}

TEST_CASE("An order in the queue comes with all that it says") {
    Session session = walledSession();
    FakeClient client(session);
    Order order = Order::move({3, 4});
    order.pace = 0.75;
    order.share = 0.5;
    order.formation.emplace().kind = FormationKind::Wedge;
    client.send(commandsOf(GiveOrder{GroupId{1}, QueueMode::Replace, 0, order}));
    session.elapse(0.1);
    while (session.stepDue()) session.step();
    client.poll();
    const std::vector<QueuedOrder> orders = client.page.orders[0];
    REQUIRE(orders.size() == 1);
    const auto bytesOf = [](const Order& one) { return encodeCommand({0, 0, 0, GiveOrder{{}, {}, 0, one}}); };
    CHECK(bytesOf(orders[0].order) == bytesOf(order));
}
