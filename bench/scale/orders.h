// What an order costs: groups cross, and one of them gets a new pose again and again.
#pragma once

#include <cstdint>
#include <string>

#include "muster/status.h"

namespace muster::scale {

/// How the orders are measured.
struct OrdersDef {
    std::int32_t groups = 2;     ///< Every second one walks east, the others north; 1 to 1,000.
    std::int32_t count = 1500;   ///< Characters of all groups together, 8 to 100,000.
    std::int32_t obstacles = 0;  ///< Discs of 0.5 m strewn over the square, 0 or more.
    std::int32_t gaps = 0;       ///< In a wall through which all walk east, 0 for no wall; up to 100.
    bool moves = false;          ///< Orders to march there instead of poses.
    bool weights = false;        ///< Supplies and demands at random, from a quarter to three units.
    std::int32_t runs = 5;       ///< Equal runs; the time of a step is its least over them, 1 to 50.
    double seconds = 10.0;       ///< World time of a run [s], up to 120.
    std::uint64_t seed = 1;      ///< Of the obstacles.
};

/// Times of the steps, each the least over all runs.
struct OrdersRow {
    double first = 0.0;          ///< The first step [ms].
    double worst = 0.0;          ///< The slowest step [ms].
    std::int32_t worstStep = 0;  ///< Its number.
    double p50 = 0.0;            ///< Median [ms].
    double p95 = 0.0;            ///< 95th percentile [ms].
    double above = 0.0;  ///< Most by which a step with an order exceeds the median of the 24 round it [ms].
    double longestWait = 0.0;  ///< Longest that a character which is not arrived stood still [s].
    std::uint64_t hash = 0;    ///< Of the last state, the same in all runs.
    std::string worstStages;   ///< Stages of the slowest step that took 0.5 ms and more.
};

/// Runs the case. Fails where the world is refused or runs differ.
Result<OrdersRow> measureOrders(const OrdersDef& def);

}  // namespace muster::scale
