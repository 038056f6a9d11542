#include "scale/battle_script.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster::scale {
namespace {

constexpr std::uint32_t kOrderSteps = 18;      // From order to order of a side.
constexpr std::uint32_t kFallSteps = 30;       // From one loss to the next.
constexpr std::uint32_t kJoinSteps = 300;      // The same of joiners,
constexpr std::uint32_t kBuildingSteps = 180;  // of buildings.
constexpr std::size_t kBuildings = 6;          // That stand; older ones are torn down.
constexpr std::int32_t kJoiners = 12;
constexpr double kObstacleGap = 3.0;    // Between obstacles at least [m].
constexpr std::size_t kMostGroups = 3;  // Times those of the beginning.

// Three classes, with their radius [m], top speed [m/s], acceleration [m/s^2] and mass.
Body bodyOf(std::uint8_t unitClass) {
    constexpr double kRadii[]{0.3, 0.6, 0.45}, kSpeeds[]{3.0, 5.0, 2.0}, kAccelerations[]{8.0, 8.0, 5.0};
    const int k = unitClass - 1;
    return {kRadii[k], kSpeeds[k], kAccelerations[k], 1.0 * unitClass, 1.0, unitClass};
}

ObstacleDef block(Vec2 centre, double width, double height, double angle) {
    ObstacleDef obstacle;
    const Rotation turned{cosine(angle), sine(angle)};
    for (const Vec2 corner : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{1, 1}, Vec2{-1, 1}})
        obstacle.polygon.push_back(centre + turned.apply({0.5 * width * corner.x, 0.5 * height * corner.y}));
    return obstacle;
}

}  // namespace

BattleScript::BattleScript(const BattleDef& def) : def_(def), random_(def.seed) {}

Vec2 BattleScript::somewhere(double share) {
    const double x = random_.uniform(-0.5, 0.5), y = random_.uniform(-0.5, 0.5);
    return Vec2{x, y} * (share * def_.side);
}

// They fill the middle of the ground, apart from each other.
void BattleScript::addObstacles(WorldDef& def) {
    struct Disc {
        Vec2 centre;
        double radius;
    };
    std::vector<Disc> discs;
    for (std::int32_t tries = 0; tries < 1000 * def_.obstacles; ++tries) {
        if (std::cmp_equal(discs.size(), def_.obstacles)) break;
        const Vec2 at = somewhere(0.7);
        const double width = random_.uniform(3.0, 12.0), height = random_.uniform(3.0, 12.0);
        const bool round = random_.uniform() < 0.3;
        const double radius = 0.5 * (round ? width : std::sqrt(width * width + height * height));
        const bool free = std::none_of(discs.begin(), discs.end(), [&](const Disc& other) {
            return distance(other.centre, at) < other.radius + radius + kObstacleGap;
        });
        const double angle = random_.uniform() < 0.5 ? 0.0 : random_.uniform(0.0, kPi);
        if (!free) continue;
        discs.push_back({at, radius});
        if (round) {
            def.obstacles.push_back({.centre = at, .radius = 0.5 * width});
        } else {
            def.obstacles.push_back(block(at, width, height, angle));
        }
    }
}

// Of five groups of a side two are on foot, one is mounted, one has guns in its rear, one has all three.
GroupDef BattleScript::group(std::int32_t side, std::int32_t number) {
    GroupDef group{.name = (side == 0 ? "West " : "East ") + std::to_string(number),
                   .count = 30 + static_cast<std::int32_t>(random_.below(31))};
    const double lanes = std::max(1, def_.groups / 2), lane = 0.9 * def_.side / lanes;
    group.position = {(side == 0 ? -0.425 : 0.425) * def_.side, (number - 0.5 * (lanes - 1.0)) * lane};
    group.angle = side == 0 ? 0.0 : kPi;
    group.formation.kind = number % 3 == 1 ? FormationKind::Wedge : FormationKind::Square;
    const std::int32_t mix = number % 5;
    group.formation.spacing = mix == 2 ? 1.8 : mix == 4 ? 1.6 : 1.3;
    for (std::int32_t k = 0; k < group.count; ++k) {
        const double share = (k + 0.5) / group.count;
        const std::uint8_t unitClass = mix < 2    ? 1
                                       : mix == 2 ? 2
                                       : mix == 3 ? (share < 2.0 / 3.0 ? 1 : 3)
                                                  : (share < 0.5    ? 1
                                                     : share < 0.75 ? 2
                                                                    : 3);
        group.bodies.push_back(bodyOf(unitClass));
    }
    if (mix >= 3) group.roles.push_back({RoleArea::Rear, 3});
    if (mix == 4) group.roles.push_back({RoleArea::Flanks, 2});
    return group;
}

WorldDef BattleScript::world() {
    WorldDef def;
    const Vec2 half{0.5 * def_.side, 0.5 * def_.side};
    def.box = {-half, half};
    def.cell = 0.5;
    def.parameters.character.radius = 0.3;
    def.parameters.character.maxSpeed = def.parameters.place.speed = 3.0;
    addObstacles(def);
    for (std::int32_t side = 0; side < 2; ++side)
        for (std::int32_t k = 0; k < def_.groups / 2; ++k) {
            def.groups.push_back(group(side, k));
            characters_ += static_cast<std::size_t>(def.groups.back().count);
        }
    return def;
}

std::vector<std::size_t> BattleScript::groupsOf(const World& world, std::int32_t side) const {
    std::vector<std::size_t> groups;
    for (std::size_t k = 0; k < world.groupCount(); ++k)
        if (sideOf_[world.group(k).id.value] == side) groups.push_back(k);
    return groups;
}

// Directs one group.
CommandBody BattleScript::order(const World& world, std::size_t group, std::int32_t side) {
    const GroupId id = world.group(group).id;
    const double kind = random_.uniform();
    const Vec2 to = somewhere(0.92);
    if (kind < 0.66) {
        Order order = random_.uniform() < 0.8 ? Order::move(to) : Order::go(to);
        if (random_.uniform() < 0.3) order.facing = random_.uniform(-kPi, kPi);
        if (random_.uniform() < 0.2) order.turn = Turn::Reverse;
        return GiveOrder{id, kind < 0.56 ? QueueMode::Replace : QueueMode::Append, 0, order};
    }
    if (kind < 0.74) {
        const double angle = random_.uniform(-kPi, kPi);
        const Vec2 half = Vec2{cosine(angle), sine(angle)} * random_.uniform(3.0, 10.0);
        return GiveOrder{id, QueueMode::Replace, 0, Order::moveToLine(to - half, to + half)};
    }
    const std::vector<std::size_t> others = groupsOf(world, 1 - side);
    if (kind < 0.82 && !others.empty()) {
        const std::size_t other = others[random_.below(static_cast<std::uint32_t>(others.size()))];
        return GiveOrder{id, QueueMode::Replace, 0, Order::follow(world.group(other).id, {-8.0, 0.0})};
    }
    if (kind < 0.88) return EditQueue{id, QueueEdit::Stop, 0};
    if (kind < 0.94) {
        const auto stance = static_cast<Stance>(random_.below(3));
        return ChangeGroup{
            .group = id,
            .conduct = Conduct{stance, random_.uniform(), random_.uniform(), random_.uniform() < 0.3}};
    }
    return GiveOrder{id, QueueMode::Replace, 0, Order::face(random_.uniform(-kPi, kPi))};
}

// Changes the shape or the members of one group.
CommandBody BattleScript::regroup(const World& world, std::size_t group, std::int32_t side) {
    const GroupId id = world.group(group).id;
    const std::vector<std::size_t> own = groupsOf(world, side);
    const std::uint32_t kind = random_.below(3);
    const bool many = world.groupCount() >= kMostGroups * static_cast<std::size_t>(def_.groups);
    if (kind == 0 && world.group(group).count > 20 && !many)
        return SplitGroup{.group = id,
                          .by = SplitBy::Shares,
                          .shares = {1, 1},
                          .abreast = random_.below(2) == 0,
                          .shape = PartShape::Smaller};
    const std::size_t other = own[random_.below(static_cast<std::uint32_t>(own.size()))];
    if (kind == 1 && other != group && own.size() > 6)
        return MergeGroups{{id, world.group(other).id}, PartShape::Smaller};
    FormationDef formation = world.groupDef(group).formation;
    formation.kind = static_cast<FormationKind>(random_.below(6));
    return ChangeGroup{.group = id, .formation = formation};
}

CommandBody BattleScript::fallen(const World& world) {
    TransferCharacters remove;
    const auto ids = world.characters().id;
    for (int k = 0; k < 3; ++k)
        remove.ids.push_back(ids[random_.below(static_cast<std::uint32_t>(ids.size()))]);
    std::sort(remove.ids.begin(), remove.ids.end());
    remove.ids.erase(std::unique(remove.ids.begin(), remove.ids.end()), remove.ids.end());
    return remove;
}

CommandBody BattleScript::joiners(const World& world, std::int32_t side) {
    const std::vector<std::size_t> own = groupsOf(world, side);
    AddCharacters add{.group = world.group(own[random_.below(static_cast<std::uint32_t>(own.size()))]).id};
    const Vec2 camp{(side == 0 ? -0.425 : 0.425) * def_.side, 0.0};
    for (int k = 0; k < kJoiners; ++k)
        add.positions.push_back(camp + 1.3 * Vec2{static_cast<double>(k % 4), std::floor(k / 4.0)});
    add.bodies = {bodyOf(1)};
    return add;
}

Status BattleScript::submit(World& world, CommandBody body) {
    return world.submit({world.stepCount(), 1, sequence_++, std::move(body)});
}

Status BattleScript::before(World& world) {
    const std::uint32_t step = world.stepCount();
    if (step == 0)
        for (std::size_t k = 0; k < world.groupCount(); ++k) {
            sideOf_.resize(std::max<std::size_t>(sideOf_.size(), world.group(k).id.value + 1));
            sideOf_[world.group(k).id.value] = std::cmp_less(k, def_.groups / 2) ? 0 : 1;
        }
    for (std::int32_t side = 0; side < 2; ++side) {
        const std::vector<std::size_t> own = groupsOf(world, side);
        if (own.empty()) continue;
        if (step % kOrderSteps == 0) {
            const std::size_t group = own[random_.below(static_cast<std::uint32_t>(own.size()))];
            ++orders_;
            ordered_ += world.group(group).count;
            const bool regroups = random_.uniform() < 0.12;
            const CommandBody body = regroups ? regroup(world, group, side) : order(world, group, side);
            if (Status status = submit(world, body); !status.ok()) return status;
        }
        if (step % kJoinSteps == 120)
            if (Status status = submit(world, joiners(world, side)); !status.ok()) return status;
    }
    if (step % kFallSteps == 15 && 4 * world.characters().size() > 3 * characters_)
        if (Status status = submit(world, fallen(world)); !status.ok()) return status;
    if (step % kBuildingSteps == 60) {
        const double width = random_.uniform(3.0, 10.0), height = random_.uniform(3.0, 10.0);
        lastBuilding_ = step;
        const Vec2 at = somewhere(0.75);
        const PutThing building = putThing(block(at, width, height, random_.uniform(0.0, kPi)));
        if (Status status = submit(world, building); !status.ok()) return status;
    }
    if (step % kBuildingSteps == 150 && buildings_.size() > kBuildings) {
        const ObstacleId oldest = buildings_.front();
        buildings_.erase(buildings_.begin());
        return submit(world, removeThing(oldest));
    }
    return {};
}

void BattleScript::after(const World& world) {
    for (const Event& event : world.events()) {
        if (event.kind != EventKind::GroupAdded) continue;
        sideOf_.resize(std::max<std::size_t>(sideOf_.size(), event.subject + 1));
        if (event.value < sideOf_.size()) sideOf_[event.subject] = sideOf_[event.value];
    }
    if (world.stepCount() != lastBuilding_ + 1 || lastBuilding_ == 0) return;
    const auto ids = world.obstacleIds();
    if (!ids.empty()) buildings_.push_back(ids.back());
}

}  // namespace muster::scale
