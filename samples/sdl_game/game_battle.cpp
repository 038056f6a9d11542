#include "game_battle.h"

#include <algorithm>
#include <cstdio>

namespace game {
namespace {

muster::ObstacleDef house(double left, double bottom, double right, double top) {
    muster::ObstacleDef def;
    def.polygon = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    return def;
}

muster::ObstacleDef disc(Vec2 centre, double radius) {
    muster::ObstacleDef def;
    def.centre = centre;
    def.radius = radius;
    return def;
}

muster::WorldDef field() {
    muster::WorldDef def;
    def.box = {{-24.0, -15.0}, {24.0, 15.0}};
    def.obstacles = {house(-6.0, 3.0, 0.0, 8.0), house(-4.5, -9.0, 0.5, -4.5), disc({7.0, -1.5}, 1.4),
                     disc({4.0, 11.0}, 0.9),     disc({9.5, -10.5}, 1.0),      disc({-11.0, 11.5}, 1.1),
                     disc({-12.5, -12.0}, 0.8),  disc(kTower, kTowerRadius)};
    for (const double y : {5.0, -5.0}) {
        muster::GroupDef group;
        group.count = 50;
        group.formation.files = 10;
        group.position = {-18.0, y};
        def.groups.push_back(group);
    }
    return def;
}

}  // namespace

muster::Result<Battle> Battle::create(const muster::TaskRunner& runner) {
    muster::Result<muster::World> world = muster::World::create(field(), runner);
    if (!world.ok()) return world.status();
    return Battle(std::move(*world));
}

Battle::Battle(muster::World world) : world_(std::move(world)) {
    keepPoses();
    before_ = now_;
}

void Battle::send(muster::CommandBody body) {
    const muster::Status status = world_.submit({world_.stepCount(), 1, sequence_++, std::move(body)});
    if (!status.ok()) std::fprintf(stderr, "%s\n", status.message().c_str());
}

void Battle::step() {
    for (const PendingOrder& pending : pending_)
        if (world_.stepCount() >= pending.step) carryOut(pending);
    std::erase_if(pending_, [&](const PendingOrder& p) { return world_.stepCount() >= p.step; });
    shoot();
    world_.step();
    for (const muster::Rejection& rejection : world_.rejections())
        std::fprintf(stderr, "%s\n", rejection.status.message().c_str());
    std::erase_if(fallen_, [&](const Fallen& f) { return world_.time() > f.time + kFallenSeconds; });
    keepPoses();
}

void Battle::keepPoses() {
    before_.swap(now_);
    now_.clear();
    const muster::CharactersView characters = world_.characters();
    for (std::size_t i = 0; i < characters.size(); ++i)
        now_.push_back({characters.id[i], world_.group(characters.group[i]).id.value, characters.position[i],
                        characters.heading[i]});
}

std::vector<UnitPose> Battle::poses(double share) const {
    std::vector<UnitPose> poses = now_;
    auto old = before_.begin();
    for (UnitPose& pose : poses) {
        while (old != before_.end() && old->id < pose.id) ++old;
        if (old == before_.end() || old->id != pose.id) continue;  // It is new.
        pose.position = muster::lerp(old->position, pose.position, share);
        pose.heading = muster::normalized(muster::lerp(old->heading, pose.heading, share), pose.heading);
    }
    return poses;
}

Ids Battle::unitsIn(Vec2 corner, Vec2 opposite) const {
    constexpr double kReach = 0.3;  // About the radius of a body [m].
    const Vec2 low{std::min(corner.x, opposite.x) - kReach, std::min(corner.y, opposite.y) - kReach};
    const Vec2 high{std::max(corner.x, opposite.x) + kReach, std::max(corner.y, opposite.y) + kReach};
    Ids ids;
    for (const UnitPose& pose : now_)
        if (pose.position.x >= low.x && pose.position.x <= high.x && pose.position.y >= low.y &&
            pose.position.y <= high.y)
            ids.insert(pose.id);
    return ids;
}

Ids Battle::membersOf(const muster::GroupView& group) const {
    Ids ids;
    for (const std::int32_t member : group.members) ids.insert(world_.characters().id[member]);
    return ids;
}

void Battle::order(const Ids& units, muster::Order order) {
    if (units.empty()) return;
    bool splits = false;
    for (std::size_t g = 0; g < world_.groupCount(); ++g) {
        const Ids members = membersOf(world_.group(g));
        muster::SplitGroup leave;
        leave.group = world_.group(g).id;
        leave.shape = muster::PartShape::Smaller;
        std::set_intersection(members.begin(), members.end(), units.begin(), units.end(),
                              std::back_inserter(leave.ids));
        if (leave.ids.empty() || leave.ids.size() == members.size()) continue;
        send(leave);
        splits = true;
    }
    // New groups have their ids after the step that splits them off.
    pending_.push_back({units, std::move(order), world_.stepCount() + (splits ? 1 : 0)});
}

void Battle::carryOut(const PendingOrder& pending) {
    std::vector<muster::GroupId> groups;
    for (std::size_t g = 0; g < world_.groupCount(); ++g) {
        const Ids members = membersOf(world_.group(g));
        if (!members.empty() &&
            std::includes(pending.units.begin(), pending.units.end(), members.begin(), members.end()))
            groups.push_back(world_.group(g).id);
    }
    if (groups.empty()) return;
    if (groups.size() > 1) send(muster::MergeGroups{groups});
    send(muster::GiveOrder{groups.front(), muster::QueueMode::Replace, 0, pending.order});
}

void Battle::split(const Ids& units) {
    for (std::size_t g = 0; g < world_.groupCount(); ++g) {
        const Ids members = membersOf(world_.group(g));
        if (members.size() < 2 || !std::includes(units.begin(), units.end(), members.begin(), members.end()))
            continue;
        muster::SplitGroup halves;
        halves.group = world_.group(g).id;
        halves.by = muster::SplitBy::Shares;
        halves.shares = {1.0, 1.0};
        halves.abreast = true;
        send(halves);
    }
}

void Battle::fall(const Ids& units) {
    muster::TransferCharacters deaths;  // To no group.
    for (const UnitPose& pose : now_) {
        if (!units.contains(pose.id)) continue;
        deaths.ids.push_back(pose.id);
        fallen_.push_back({pose.position, world_.time()});
    }
    std::erase_if(now_, [&](const UnitPose& pose) { return units.contains(pose.id); });
    if (!deaths.ids.empty()) send(deaths);
}

/// The tower hits whoever is nearest.
void Battle::shoot() {
    if (world_.time() < nextShot_) return;
    const UnitPose* nearest = nullptr;
    for (const UnitPose& pose : now_)
        if (muster::distance(pose.position, kTower) <= kTowerReach &&
            (nearest == nullptr ||
             muster::distance(pose.position, kTower) < muster::distance(nearest->position, kTower)))
            nearest = &pose;
    if (nearest == nullptr) return;
    nextShot_ = world_.time() + kReload;
    lastShot_ = Fallen{nearest->position, world_.time()};
    fall(Ids{nearest->id});
}

}  // namespace game
