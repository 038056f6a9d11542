// Draws the fields of random commands: valid values of each type, and what the fields of one command have to
// be together.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "base/random.h"
#include "muster/command.h"
#include "muster/generated/enumerations.h"

namespace muster {

class CommandDraw {
public:
    explicit CommandDraw(std::uint64_t seed) : random_(seed) {}

    std::uint32_t number() { return 1 + random_.below(1000000); }
    bool flag() { return random_.below(2) == 1; }
    double real(double low, double high) { return low + (high - low) * random_.below(1001) / 1000.0; }
    std::int32_t whole(std::int32_t low, std::int32_t high) {
        return low + static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(high - low) + 1));
    }
    Vec2 place() { return {real(-1e3, 1e3), real(-1e3, 1e3)}; }
    std::string text() { return "Guests " + std::to_string(number()); }
    template <class Enum>
    Enum value() {
        return static_cast<Enum>(random_.below(static_cast<std::uint32_t>(kCountOf<Enum>)));
    }
    /// Fills a list with one to four entries.
    template <class Item, class Make>
    void list(std::vector<Item>& items, const Make& make) {
        items.resize(0);
        for (std::uint32_t k = 1 + random_.below(4); k > 0; --k) items.push_back(make());
    }
    /// One to four different ids.
    std::vector<std::uint32_t> ids() {
        std::vector<std::uint32_t> found;
        for (std::uint32_t k = 1 + random_.below(4), id = number(); k > 0; --k) found.push_back(id += 3);
        return found;
    }

    std::uint8_t unitClass() { return static_cast<std::uint8_t>(whole(1, 9)); }
    TimedPath path() {
        if (flag()) return {};
        return {.waypoints = {{0.0, {0, 0}, 0.0}, {2.5, place(), real(-3, 3)}}, .loop = flag()};
    }
    Body body() {
        return {real(0.1, 1.0), real(0.5, 5.0), real(1.0, 9.0), real(0.5, 3.0), real(0.5, 2.0),
                unitClass(),    real(0.1, 2.0), real(0.0, 90),  real(0.1, 1.0), real(0.1, 1.0)};
    }
    RoleDef roleDef() { return {value<RoleArea>(), unitClass()}; }
    PeopleDef peopleDef() {
        if (flag()) return adults();
        return {.name = text(),
                .share = real(0.1, 1.0),
                .unitClass = unitClass(),
                .speed = Distribution::normal(real(1.0, 1.5), 0.25, 0.5, 2.0),
                .radius = Distribution::uniform(0.2, real(0.21, 0.3)),
                .headway = Distribution::constant(real(0.1, 1.0)),
                .premovement = {Spread::LogNormal, real(2.0, 4.0), 0.5, 0.0, 500.0},
                .age = {Spread::Weibull, real(30.0, 50.0), 7.0, 20.0, 70.0},
                .upstairs = real(0.1, 1.0),
                .downstairs = real(0.1, 1.0)};
    }
    FormationDef formationDef() {
        FormationDef def{.spacing = real(0.5, 3.0)};
        if (flag()) {
            def.kind = flag() ? FormationKind::Ring : FormationKind::Square;
        } else if (flag()) {
            def.kind = FormationKind::Points;
            def.points = {place(), place()};
        } else {
            def.kind = FormationKind::Outline;
            def.outline = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}}}};
        }
        return def;
    }
    ObstacleDef obstacleDef() {
        ObstacleDef def{.name = text(), .path = path()};
        if (flag()) {
            def.centre = place();
            def.radius = real(0.5, 4.0);
        } else {
            def.polygon = {{0, 0}, {real(1, 5), 0}, {1, 1}};
        }
        if (flag()) def.range = real(0.5, 3.0);
        if (flag()) def.strength = real(0.0, 1.0);
        if (flag()) def.height = real(0.5, 5.0);
        return def;
    }
    PatchDef patchDef() {
        PatchDef def{.name = text(),
                     .polygon = {{0, 0}, {real(1, 5), 0}, {1, 1}},
                     .path = path(),
                     .motion = whole(0, 9)};
        if (flag()) def.speed = real(0.1, 1.0);
        if (flag()) def.ascent = real(-3, 3);
        if (flag()) def.speedDown = real(0.1, 1.0);
        return def;
    }
    ItemDef itemDef() { return {place(), real(0.1, 2.0)}; }
    FormationCheckpointDef checkpointDef() {
        return {.position = place(),
                .radius = real(0.5, 3.0),
                .formation = formationDef(),
                .once = flag(),
                .trigger = value<CheckpointTrigger>(),
                .share = real(0.1, 1.0)};
    }
    AreaDef areaDef() {
        AreaDef def{.name = text(), .polygon = {{0, 0}, {2, 0}, {2, 2}}, .open = flag()};
        if (flag()) {
            def.queue = {place(), place()};
        } else {
            def.kind = AreaKind::Source;
            def.rate = real(0.1, 2.0);
            def.from = real(0.0, 5.0);
            def.until = real(10.0, 90.0);
            def.most = whole(1, 30);
            def.timetable = {{real(0.0, 1.0), 4}, {2.0, 5}};
        }
        return def;
    }
    Conduct conduct() { return {value<Stance>(), real(0, 1), real(0, 1), flag()}; }
    Order order() {
        switch (random_.below(8)) {
            case 0:
                return Order::face(real(-3, 3));
            case 1: {
                Order order = Order::guard(place(), {real(0, 4), real(0, 4)}, real(-3, 3));
                order.path = path();
                if (flag()) order.character = number();
                return order;
            }
            case 2:
                return Order::follow(GroupId{number()}, place());
            case 3:
                return Order::followCharacter(number(), place());
            case 4: {
                Order order = Order::leave({AreaId{number()}, AreaId{1000001}});
                order.choice = value<ExitChoice>();
                order.attractions = {real(-5, 5), real(-5, 5)};
                order.herding = real(0, 9);
                order.misjudgement = real(0, 9);
                return order;
            }
            case 5:
                return Order::wait(AreaId{number()}, real(0, 90));
            case 6:
                return Order::walk(real(-3, 3));
            default: {
                Order order = Order::move(place(), real(-3, 3));
                order.manner = value<Manner>();
                order.turn = value<Turn>();
                order.pace = real(0, 2);
                order.width = real(1, 9);
                order.share = real(0.1, 1.0);
                if (flag()) order.route = {place(), place()};
                if (flag()) order.formation = formationDef();
                return order;
            }
        }
    }
    GroupDef groupDef() {
        GroupDef def{.name = text(),
                     .count = 2,
                     .formation = formationDef(),
                     .position = place(),
                     .angle = real(-3, 3),
                     .starts = {place(), place()},
                     .jitter = real(0.0, 1.0),
                     .bodies = {body(), body()},
                     .roles = {roleDef()},
                     .demands = {real(0.5, 2), real(0.5, 2)},
                     .conduct = conduct(),
                     .orders = {order(), order()},
                     .patrols = flag()};
        if (flag()) def.colour = number();
        if (flag()) def.build = value<BodyBuild>();
        if (flag()) def.motions = value<MotionSet>();
        if (flag()) def.people = {peopleDef(), peopleDef()};
        return def;
    }

    /// Makes the fields of a command fit each other; most do so already.
    template <class Kind>
    void relate(Kind&) {}
    void relate(AddControl& c) {
        c.touches = ids();
        c.positions.assign(c.touches.size(), place());
        c.kind = static_cast<ControlKind>(std::min<std::size_t>(c.touches.size(), 3) - 1);
    }
    void relate(SetParameter& c) {
        c.name = "plan.exponent";
        c.value = real(1, 4);
    }
    void relate(AddCharacters& c) { c.bodies.resize(flag() ? 1 : c.positions.size(), body()); }
    void relate(SplitGroup& c) {
        if (c.by == SplitBy::Line) c.points = {place(), {2e3, 0}};
        if (c.by == SplitBy::Lasso) c.points = {place(), place(), {2e3, 0}};
        c.shares = {real(0.1, 2), real(0.1, 2)};
    }
    void relate(MergeGroups& c) { c.groups = {GroupId{number()}, GroupId{1000001}}; }
    void relate(SetBodies& c) { c.bodies.resize(flag() ? 1 : c.ids.size(), body()); }
    void relate(WriteMotion& c) {
        c.positions.resize(c.ids.size(), place());
        c.velocities.resize(flag() ? 0 : c.ids.size());
    }

private:
    Random random_;
};

}  // namespace muster
