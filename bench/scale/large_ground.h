// A large world with many obstacles: what creating it, an order, an edit and a restore cost.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "muster/world.h"

namespace muster::scale {

/// A made world: buildings and trees over a square, and one group that is ordered from one side to the other.
struct LargeGroundDef {
    double side = 1000.0;                 ///< Edge of the world [m], at least 100.
    std::int32_t obstacles = 2000;        ///< Number of obstacles.
    double cell = 0.25;                   ///< Edge of a ground cell [m].
    std::int32_t characters = 60;         ///< Size of the group.
    double away = 500.0;                  ///< Length of the order [m], less than the side.
    std::int32_t steps = 300;             ///< Steps after that with the order.
    std::uint64_t seed = 1;               ///< Seed of the obstacles.
    std::string map;                      ///< A MovingAI map instead of the made world; empty for none.
    std::array<std::int32_t, 2> caves{};  ///< Width and height of a made map of caves [cells]; 0 for none.
    double metres = 1.0;                  ///< Edge of a cell of the map [m], above 0.
};

/// What was measured: CPU times of the thread [ms], memory [MB].
struct LargeGroundRow {
    LargeGroundDef def;
    double create = 0.0;         ///< World::create, with the import of the map.
    double createMemory = 0.0;   ///< Peak after it.
    double first = 0.0;          ///< The first step.
    double standing = 0.0;       ///< Median step of the group that stands.
    double order = 0.0;          ///< The step with the order.
    double p50 = 0.0;            ///< Median of the steps after it.
    double p95 = 0.0;            ///< Their 95th percentile.
    double most = 0.0;           ///< The longest of them.
    std::vector<double> edits;   ///< Steps with an edit: a building added, moved, removed.
    double afterEdit = 0.0;      ///< The longest of the eight steps after each edit.
    double memory = 0.0;         ///< Peak after all that.
    double restore = 0.0;        ///< World::restore of a snapshot.
    double firstRestored = 0.0;  ///< The first step after it.
    std::uint64_t hash = 0;      ///< Of the world at the end.
};

/// The definition of the world. Fails where the map cannot be read.
Result<WorldDef> largeWorld(const LargeGroundDef& def);
/// Makes the world and measures it on one thread. Fails where it cannot be made.
Result<LargeGroundRow> runLargeGround(const LargeGroundDef& def);
/// The row in words, one value per line.
std::string largeGroundText(const LargeGroundRow& row);

}  // namespace muster::scale
