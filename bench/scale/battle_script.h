// What happens in a battle: where all begin, and who is ordered what.
#pragma once

#include <cstdint>
#include <vector>

#include "base/random.h"
#include "muster/world.h"
#include "scale/battle.h"

namespace muster::scale {

/// Gives each side an order every 0.3 s: marches, lines, queues, pursuits, formations, splits, merges, stops;
/// characters fall and join, buildings are put up and torn down. It reads the world, so a battle repeats bit
/// by bit only with the same program.
class BattleScript {
public:
    explicit BattleScript(const BattleDef& def);

    /// Ground, obstacles and groups at the beginning.
    WorldDef world();
    /// Submits the commands of the coming step.
    Status before(World& world);
    /// Follows the events of a step: new groups belong to the side of those they came from.
    void after(const World& world);

    std::int32_t orders() const { return orders_; }  ///< So far.
    /// Sum over orders of the members of their groups.
    std::int64_t ordered() const { return ordered_; }
    std::uint32_t lastBuilding() const { return lastBuilding_; }  ///< Step in which the last one was put up.

private:
    void addObstacles(WorldDef& def);
    GroupDef group(std::int32_t side, std::int32_t number);
    std::vector<std::size_t> groupsOf(const World& world, std::int32_t side) const;
    Vec2 somewhere(double share);
    CommandBody order(const World& world, std::size_t group, std::int32_t side);
    CommandBody regroup(const World& world, std::size_t group, std::int32_t side);
    CommandBody fallen(const World& world);
    CommandBody joiners(const World& world, std::int32_t side);
    Status submit(World& world, CommandBody body);

    BattleDef def_;
    Random random_;
    std::vector<std::uint8_t> sideOf_;  // By group id.
    std::vector<ObstacleId> buildings_;
    std::size_t characters_ = 0;
    std::uint32_t sequence_ = 0, lastBuilding_ = 0;
    std::int32_t orders_ = 0;
    std::int64_t ordered_ = 0;
};

}  // namespace muster::scale
