#include "script.h"

#include <algorithm>
#include <array>

#include "battlefield.h"

namespace lockstep {
namespace {

using muster::GroupView;
using muster::Order;
using muster::Vec2;
using muster::World;

constexpr double kStepTime = 1.0 / 60.0;
constexpr std::size_t kMostGroups = 4;       // Of one player.
constexpr std::size_t kMostBarricades = 12;  // Obstacles of the field.
constexpr std::size_t kMostNew = 12;         // People who come at once.

}  // namespace

Vec2 Script::spot() {
    return {random_.between(-28.0, 28.0), random_.between(-20.0, 20.0)};
}

std::vector<muster::CommandBody> Script::commands(const World& world) {
    Commands commands;
    if (dragSteps_ > 0) {
        drag(world, commands);
    } else if (rest_ > 0) {
        --rest_;
    } else {
        rest_ = 10 + random_.below(100);
        act(world, commands);
    }
    return commands;
}

void Script::act(const World& world, Commands& commands) {
    const std::vector<std::size_t> groups = groupsOf(world, player_);
    if (groups.empty()) return;
    const GroupView group = world.group(groups[random_.below(static_cast<std::uint32_t>(groups.size()))]);
    switch (random_.below(8)) {
        case 0:
        case 1:
        case 2:
            return order(world, group, commands);
        case 3:
            return divide(world, group, commands);
        case 4:
            return people(world, group, commands);
        case 5:
            return shape(group, commands);
        case 6:
            return barricade(world, commands);
        default:
            return beginDrag(world, group, commands);
    }
}

void Script::order(const World& world, const GroupView& group, Commands& commands) {
    muster::GiveOrder give;
    give.group = group.id;
    const Vec2 target = spot();
    switch (random_.below(8)) {
        case 0:
            give.order = Order::move(target);
            break;
        case 1:
            give.order = Order::move(target, random_.between(-3.0, 3.0));
            break;
        case 2:
            give.order = Order::go(target);
            break;
        case 3:
            give.order = Order::moveToLine(target, target + Vec2{random_.between(4.0, 9.0), 3.0});
            break;
        case 4:
            give.order = Order::face(random_.between(-3.0, 3.0));
            break;
        case 5:
            give.order = Order::guard(target, {2.0, 1.0}, 0.0);
            break;
        case 6:
            give.order = Order::follow(world.group(0).id, {-6.0, 0.0});
            break;
        default: {
            const auto edits = std::to_array({muster::QueueEdit::Hold, muster::QueueEdit::Resume,
                                              muster::QueueEdit::Patrol, muster::QueueEdit::Stop});
            commands.push_back(muster::EditQueue{group.id, edits[random_.below(4)], 0});
            return;
        }
    }
    if (random_.chance(0.3)) give.mode = muster::QueueMode::Append;
    commands.push_back(give);
}

void Script::divide(const World& world, const GroupView& group, Commands& commands) {
    const std::vector<std::size_t> groups = groupsOf(world, player_);
    if (groups.size() >= kMostGroups || (groups.size() > 1 && random_.chance(0.4))) {
        muster::MergeGroups merge;
        for (const std::size_t g : groups) merge.groups.push_back(world.group(g).id);
        commands.push_back(merge);
        return;
    }
    muster::SplitGroup split;
    split.group = group.id;
    if (random_.chance(0.5)) {
        split.by = muster::SplitBy::Line;
        const Vec2 middle = group.pose.position;
        split.points = {middle, middle + Vec2{random_.between(-1.0, 1.0), 1.5}};
    } else {
        split.by = muster::SplitBy::Shares;
        split.shares = {1.0, random_.between(0.5, 2.0)};
        split.abreast = random_.chance(0.5);
    }
    commands.push_back(split);
}

/// Deaths, and reinforcement for them.
void Script::people(const World& world, const GroupView& group, Commands& commands) {
    std::size_t own = 0;
    for (const muster::Body& body : world.characters().body) own += body.unitClass == player_ + 1;
    if (own + 8 < people_) {
        muster::AddCharacters add;
        add.group = group.id;
        for (std::size_t i = own; i < people_ && i < own + kMostNew; ++i)
            add.positions.push_back(
                {(player_ == 0 ? -30.0 : 30.0), -10.0 + 1.2 * static_cast<double>(i - own)});
        muster::Body body;
        body.unitClass = static_cast<std::uint8_t>(player_ + 1);
        add.bodies = {body};
        commands.push_back(add);
        return;
    }
    muster::TransferCharacters deaths;  // To no group.
    const std::uint32_t count = 1 + random_.below(4);
    for (std::uint32_t i = 0; i < count && i < group.members.size(); ++i)
        deaths.ids.push_back(world.characters().id[group.members[group.members.size() - 1 - i]]);
    commands.push_back(deaths);
}

void Script::shape(const GroupView& group, Commands& commands) {
    if (random_.chance(0.3)) {
        muster::Conduct conduct;
        conduct.cohesion = random_.between(0.0, 1.0);
        conduct.avoids = random_.chance(0.5);
        commands.push_back(muster::ChangeGroup{.group = group.id, .conduct = conduct});
        return;
    }
    using enum muster::FormationKind;
    const auto kinds = std::to_array({Square, Line, Column, Wedge, Ring, Circle, Crescent});
    muster::FormationDef formation;
    formation.kind = kinds[random_.below(static_cast<std::uint32_t>(kinds.size()))];
    formation.spacing = random_.between(0.9, 1.3);
    commands.push_back(muster::ChangeGroup{.group = group.id, .formation = formation});
}

void Script::barricade(const World& world, Commands& commands) {
    const auto ids = world.obstacleIds();
    if (ids.size() >= kMostBarricades) {
        commands.push_back(muster::removeThing(ids.back()));
        return;
    }
    muster::ObstacleDef def;
    def.centre = spot();
    def.radius = random_.between(0.4, 1.0);
    commands.push_back(muster::putThing(def));
}

/// A finger takes hold of the mesh and draws an arc for up to a second and a half.
void Script::beginDrag(const World& world, const GroupView& group, Commands& commands) {
    if (group.finalMesh.empty()) return;
    finger_ = group.finalMesh[random_.below(static_cast<std::uint32_t>(group.finalMesh.size()))];
    fingerVelocity_ = Vec2{random_.between(-4.0, 4.0), random_.between(-4.0, 4.0)};
    dragSteps_ = 20 + random_.below(70);
    commands.push_back(muster::Touch{muster::TouchPhase::Down, ++touch_, finger_, world.time(), group.id});
}

void Script::drag(const World& world, Commands& commands) {
    if (--dragSteps_ == 0) {
        commands.push_back(muster::Touch{muster::TouchPhase::Up, touch_, {}, world.time(), {}});
        return;
    }
    fingerVelocity_ += 0.02 * muster::perpendicular(fingerVelocity_);
    finger_ += kStepTime * fingerVelocity_;
    finger_ = {std::clamp(finger_.x, -30.0, 30.0), std::clamp(finger_.y, -22.0, 22.0)};
    commands.push_back(muster::Touch{muster::TouchPhase::Move, touch_, finger_, world.time(), {}});
}

}  // namespace lockstep
