// Random commands of all kinds, good and bad, for random scenes.
#pragma once

#include <algorithm>
#include <vector>

#include "base/random.h"
#include "muster/world.h"

namespace muster::testing {

/// A floor with houses, trees, a moving car and four groups with bodies, roles and orders, chosen by `seed`.
inline WorldDef randomField(std::uint64_t seed) {
    Random random(seed);
    WorldDef def{.box = {{-18, -14}, {18, 14}}, .seed = seed};
    constexpr double kRates[] = {60.0, 60.0, 30.0, 20.0, 120.0};
    def.parameters.stepTime = 1.0 / kRates[random.below(5)];
    def.parameters.plan.solver = random.below(3) == 0 ? PlanSolver::Exact : def.parameters.plan.solver;
    for (int k = 0; k < 4; ++k)
        def.obstacles.push_back(
            {.centre = {random.uniform(-6, 6), -10.0 + 6.5 * k}, .radius = random.uniform(0.3, 1.0)});
    ObstacleDef house;
    const double half = random.uniform(0.5, 2.5);
    house.polygon = {{-2, -half}, {2, -half}, {2, half}, {-2, half}};
    def.obstacles.push_back(house);
    def.obstacles.push_back(
        {.centre = {-8, 11},
         .radius = 0.8,
         .path = {.waypoints = {{0, {0, 0}, 0}, {8, {16, 0}, 0}, {16, {0, 0}, 0}}, .loop = true}});
    for (int g = 0; g < 4; ++g) {
        GroupDef group{.count = static_cast<std::int32_t>(1 + random.below(24)),
                       .formation = {.kind = static_cast<FormationKind>(random.below(8))},
                       .position = {g % 2 == 0 ? -11.0 : 11.0, g < 2 ? -6.0 : 6.0}};
        if (random.below(2) == 0) group.bodies = {{0.2, 1.5, 0.0, 2.0, 1.0, 1}};
        if (random.below(2) == 0) group.roles = {{RoleArea::Front, 1}, {RoleArea::Rim, 2}};
        if (random.below(2) == 0) group.orders = {Order::move({0, 8}), Order::face(1.0)};
        group.patrols = random.below(4) == 0;
        def.groups.push_back(group);
    }
    return def;
}

/// Makes commands at random; about one in ten names what does not exist or says what may not be.
class UnitDirector {
public:
    explicit UnitDirector(std::uint64_t seed, bool outside = true) : random_(seed), outside_(outside) {}

    /// The next command for a world.
    CommandBody next(const World& world) {
        world_ = &world;
        switch (random_.below(24)) {
            case 0:
            case 1:
            case 2:
            case 3:
            case 4:
                return GiveOrder{group(), mode(), random_.below(4), order()};
            case 5:
            case 6:
                return EditQueue{group(), pick<QueueEdit>(6), random_.below(8)};
            case 7:
                return ChangeGroup{
                    .group = group(),
                    .conduct = Conduct{pick<Stance>(3), random_.uniform(), random_.uniform(), flip()}};
            case 8:
            case 9:
                return AddCharacters{group(), places(1 + random_.below(4)), {}};
            case 10:
            case 11:
                return TransferCharacters{ids(1 + random_.below(4)), {}};
            case 12:
                return TransferCharacters{ids(1 + random_.below(6)), group()};
            case 13:
            case 14:
                return split();
            case 15:
            case 16:
                return MergeGroups{{group(), group()}, pick<PartShape>(2)};
            case 17:
                return ChangeCharacters{ids(1 + random_.below(3)), std::vector<Body>{body()}, {}};
            case 18:
                return ChangeGroup{
                    .group = group(),
                    .roles = std::vector<RoleDef>{{pick<RoleArea>(7), 1}, {pick<RoleArea>(7), 2}}};
            case 19:
                return ChangeGroup{.group = group(),
                                   .demands = std::vector<double>(random_.below(30), random_.uniform(0, 2))};
            case 20:
                return ChangeGroup{.group = group(), .formation = formation()};
            case 21:
                return SetPose{group(), place(), random_.uniform(-3, 3)};
            case 22:
                return outside_
                           ? CommandBody(ChangeCharacters{ids(1 + random_.below(3)), {}, pick<Driver>(2)})
                           : CommandBody(RemoveGroup{{99}});
            default:
                return outside_ ? motion() : CommandBody(TransferCharacters{{999999}, {}});
        }
    }

private:
    bool flip() { return random_.below(2) == 0; }
    template <class Value>
    Value pick(std::uint32_t values) {
        return static_cast<Value>(random_.below(values));
    }
    QueueMode mode() { return pick<QueueMode>(3); }
    Vec2 place() { return {random_.uniform(-17, 17), random_.uniform(-13, 13)}; }
    std::vector<Vec2> places(std::uint32_t count) {
        std::vector<Vec2> list;
        const Vec2 middle = place();
        for (std::uint32_t k = 0; k < count; ++k) list.push_back(middle + Vec2{0.3 * k, 0.1 * k});
        return list;
    }
    GroupId group() {
        if (world_->groupCount() == 0 || random_.below(12) == 0) return {random_.below(1000)};
        return world_->group(random_.below(static_cast<std::uint32_t>(world_->groupCount()))).id;
    }
    std::uint32_t id() {
        const auto all = world_->characters().id;
        if (all.empty() || random_.below(20) == 0) return random_.below(100000);
        return all[random_.below(static_cast<std::uint32_t>(all.size()))];
    }
    std::vector<std::uint32_t> ids(std::uint32_t count) {
        std::vector<std::uint32_t> list;
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t one = id();
            if (random_.below(30) == 0 || std::find(list.begin(), list.end(), one) == list.end())
                list.push_back(one);
        }
        return list;
    }
    FormationDef formation() {
        return {.kind = pick<FormationKind>(8),
                .spacing = random_.uniform(0.8, 1.4),
                .files = static_cast<std::int32_t>(random_.below(8))};
    }
    Body body() {
        return {.radius = random_.uniform(0.12, 0.35),
                .maxSpeed = random_.uniform(0.8, 3.0),
                .mass = random_.uniform(0.3, 5.0),
                .unitClass = static_cast<std::uint8_t>(random_.below(3))};
    }
    Order order() {
        Order order = Order::move(place());
        order.kind = pick<OrderKind>(4);
        if (order.kind == OrderKind::Face || flip()) order.facing = random_.uniform(-4, 4);
        order.manner = pick<Manner>(2);
        order.turn = pick<Turn>(3);
        order.width = random_.below(3) == 0 ? random_.uniform(0, 12) : 0.0;
        order.pace = random_.below(4) == 0 ? random_.uniform(0.2, 3) : 0.0;
        order.share = random_.uniform(0.3, 1.0);
        if (random_.below(3) == 0) order.route = {place(), place()};
        if (random_.below(4) == 0) order.formation = formation();
        if (flip()) order.group = group();
        if (random_.below(3) == 0) order.character = id();
        order.offset = {random_.uniform(-4, 4), random_.uniform(-4, 4)};
        order.halfSize = {random_.uniform(0, 3), random_.uniform(0, 3)};
        return order;
    }
    SplitGroup split() {
        SplitGroup split{group(), pick<SplitBy>(4), {}, {}, {}, flip(), pick<PartShape>(2)};
        if (split.by == SplitBy::Ids) split.ids = ids(1 + random_.below(8));
        if (split.by == SplitBy::Line) split.points = {place(), place()};
        if (split.by == SplitBy::Lasso) split.points = {place(), place(), place(), place()};
        if (split.by == SplitBy::Shares) split.shares = {random_.uniform(0, 1), random_.uniform(0.1, 1)};
        return split;
    }
    /// Those that are moved from outside walk on; now and then it names others too.
    CommandBody motion() {
        WriteMotion motion;
        const CharactersView c = world_->characters();
        for (std::size_t i = 0; i < c.size(); ++i) {
            if (c.driver[i] != Driver::Outside && random_.below(200) != 0) continue;
            motion.ids.push_back(c.id[i]);
            motion.positions.push_back(c.position[i] + c.wantedVelocity[i] * 0.01);
            motion.velocities.push_back(c.wantedVelocity[i]);
        }
        if (motion.ids.empty()) return RemoveGroup{{77}};
        return motion;
    }

    Random random_;
    bool outside_;
    const World* world_ = nullptr;
};

}  // namespace muster::testing
