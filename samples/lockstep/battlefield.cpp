#include "battlefield.h"

namespace lockstep {
namespace {

muster::ObstacleDef house(double left, double bottom, double right, double top) {
    muster::ObstacleDef def;
    def.polygon = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    return def;
}

muster::ObstacleDef pillar(muster::Vec2 centre, double radius) {
    muster::ObstacleDef def;
    def.centre = centre;
    def.radius = radius;
    return def;
}

/// Drives up and down the street between the houses, 40 m in 40 s.
muster::ObstacleDef cart() {
    muster::ObstacleDef def = house(-1.0, -18.0, 1.0, -15.0);
    def.path.waypoints = {{0.0, {0.0, 0.0}, 0.0}, {20.0, {0.0, 32.0}, 0.0}, {40.0, {0.0, 0.0}, 0.0}};
    def.path.loop = true;
    return def;
}

}  // namespace

muster::Result<muster::World> makeBattlefield(std::int32_t people) {
    muster::WorldDef def;
    def.name = "Lockstep";
    def.box = {{-32.0, -24.0}, {32.0, 24.0}};
    def.obstacles = {house(-10.0, -8.0, -5.0, 2.0), house(5.0, -2.0, 10.0, 8.0), pillar({-6.0, 12.0}, 1.5),
                     pillar({6.0, -12.0}, 1.5), cart()};
    for (std::uint32_t player = 0; player < 2; ++player) {
        muster::GroupDef group;
        group.name = player == 0 ? "West" : "East";
        group.count = people;
        group.position = {player == 0 ? -22.0 : 22.0, 0.0};
        group.angle = player == 0 ? 0.0 : 3.141592653589793;
        muster::Body body;
        body.unitClass = static_cast<std::uint8_t>(player + 1);
        group.bodies = {body};
        def.groups.push_back(group);
    }
    return muster::World::create(def);
}

std::vector<std::size_t> groupsOf(const muster::World& world, std::uint32_t player) {
    std::vector<std::size_t> groups;
    const muster::CharactersView characters = world.characters();
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const auto members = world.group(g).members;
        if (!members.empty() && characters.body[members.front()].unitClass == player + 1) groups.push_back(g);
    }
    return groups;
}

}  // namespace lockstep
