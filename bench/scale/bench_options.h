// The command line of muster-bench.
#pragma once

#include <string>
#include <vector>

#include "scale/battle.h"
#include "scale/bench_commands.h"
#include "scale/case.h"
#include "scale/led_ground.h"
#include "scale/orders.h"
#include "scale/people_cost.h"
#include "scale/rewind.h"

namespace muster::scale {

/// Options of the program.
struct Options {
    std::string command;   ///< The subcommand: "scale", "ground", "orders", "commands", "rewind" or "battle".
    LedGroundDef ground;   ///< Of `muster-bench ground`; its first part where nobody is led.
    bool lead = false;     ///< `muster-bench ground --lead`.
    CommandsDef commands;  ///< Of `muster-bench commands`.
    OrdersDef orders;      ///< Of `muster-bench orders`; the rest is of `muster-bench scale`.
    RewindDef rewind;      ///< Of `muster-bench rewind`.
    BattleDef battle;      ///< Of `muster-bench battle`.
    PeopleCostDef people;  ///< Of `muster-bench people`.
    std::vector<std::string> scenes;
    std::vector<std::string> regimes;
    std::vector<std::int32_t> counts;
    std::vector<std::string> plans;
    std::vector<std::int32_t> threads;
    std::vector<std::uint64_t> seeds;
    double seconds = 0.0;
    std::int32_t gapEvery = 0;
    bool quick = false;
    bool json = false;
    bool exact = false;
    bool noGap = false;
    bool markdown = false;
    std::string maps = "../shared/maps";
};

/// Reads the command line; returns -1 to go on with `options`, else the exit code (help 0, wrong 2).
int readOptions(int argc, const char* const* argv, Options& options);

/// All requested cases, in the order of the table. Fails with one sentence naming the culprit.
Result<std::vector<CaseDef>> casesOf(const Options& options);

}  // namespace muster::scale
