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

    Body body() { return {real(0.1, 1.0), real(0.5, 5.0), real(1.0, 9.0), real(0.5, 3.0), 1.0, 2}; }
    RoleDef roleDef() { return {value<RoleArea>(), static_cast<std::uint8_t>(whole(1, 9))}; }
    PeopleDef peopleDef() {
        PeopleDef people = adults();
        people.share = real(0.1, 1.0);
        return people;
    }
    FormationDef formationDef() {
        FormationDef def;
        def.spacing = real(0.5, 3.0);
        if (flag()) return def;
        def.kind = FormationKind::Outline;
        def.outline.outline = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
        def.outline.holes = {{{1, 1}, {1, 2}, {2, 2}}};
        return def;
    }
    ObstacleDef obstacleDef() {
        ObstacleDef def;
        def.name = text();
        if (flag()) {
            def.centre = place();
            def.radius = real(0.5, 4.0);
        } else {
            def.polygon = {{0, 0}, {real(1, 5), 0}, {1, 1}};
            def.path.waypoints = {{0.0, {0, 0}, 0.0}, {2.5, {3, 1}, 0.5}};
            def.path.loop = flag();
        }
        return def;
    }
    PatchDef patchDef() {
        PatchDef def;
        def.polygon = {{0, 0}, {real(1, 5), 0}, {1, 1}};
        def.motion = whole(0, 9);
        return def;
    }
    ItemDef itemDef() { return {place(), real(0.1, 2.0)}; }
    FormationCheckpointDef checkpointDef() {
        FormationCheckpointDef def;
        def.position = place();
        def.formation = formationDef();
        def.once = flag();
        def.trigger = value<CheckpointTrigger>();
        return def;
    }
    AreaDef areaDef() {
        AreaDef def;
        def.name = text();
        def.polygon = {{0, 0}, {2, 0}, {2, 2}};
        def.kind = AreaKind::Exit;
        return def;
    }
    Conduct conduct() { return {value<Stance>(), real(0, 1), real(0, 1), flag()}; }
    Order order() {
        Order order = Order::move(place(), real(-3, 3));
        order.manner = flag() ? Manner::March : Manner::Free;
        if (flag()) order.route = {place(), place()};
        if (flag()) order.formation = formationDef();
        return order;
    }
    GroupDef groupDef() {
        GroupDef def;
        def.name = text();
        def.count = 2;
        def.starts = {place(), place()};
        def.formation = formationDef();
        def.conduct = conduct();
        def.orders = {order()};
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
