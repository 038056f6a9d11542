#include "scale/bench_options.h"
#include "muster/parameter_table.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

namespace muster::scale {
namespace {

constexpr int kGoOn = -1;
constexpr int kWrong = 2;

void describe(CLI::App& scale, Options& o) {
    scale.add_flag("--quick", o.quick, "160 and 1,000 characters, one seed, short runs, few gaps");
    scale.add_flag("--json", o.json, "One JSON object a line");
    scale.add_flag("--markdown", o.markdown, "The table in Markdown, for docs/performance.md");
    scale.add_option("--scene", o.scenes, "Scenes (all)")->delimiter(',');
    scale.add_option("--regime", o.regimes, "far, tracking, reversing (all)")->delimiter(',');
    scale.add_option("--n", o.counts, "Characters (160,1000,10000)")->delimiter(',');
    scale.add_option("--plan", o.plans, "exact, fast (fast where the build has it)")->delimiter(',');
    scale.add_option("--threads", o.threads, "Threads of the world (1)")->delimiter(',');
    scale.add_option("--seed", o.seeds, "Seeds (1,2,3)")->delimiter(',');
    scale.add_option("--seconds", o.seconds, "World time of a run at most [s] (20; far: until all arrived)");
    scale.add_option("--gap-every", o.gapEvery,
                     "Steps between gaps (30; quick: 120); more for large crowds, see docs/performance.md");
    scale.add_flag("--exact", o.exact, "The exact plan beside each case of at most 1,000 characters");
    scale.add_flag("--no-gap", o.noGap, "No judge");
    scale.add_option("--maps", o.maps, "Folder with the city's map (../shared/maps)");
}

void describeGround(CLI::App& ground, Options& o) {
    LargeGroundDef& def = o.ground.ground;
    ground.add_option("--side", def.side, "Edge of the world [m] (1000)");
    ground.add_option("--obstacles", def.obstacles, "Number of obstacles (2000)");
    ground.add_option("--cell", def.cell, "Ground cell [m] (0.25)");
    ground.add_option("--n", def.characters, "Characters (60)");
    ground.add_option("--away", def.away, "Length of the order [m] (500)");
    ground.add_option("--steps", def.steps, "Steps after the order (300)");
    ground.add_option("--seed", def.seed, "Seed of the obstacles (1)");
    ground.add_option("--map", def.map, "A MovingAI map instead of a made world");
    ground.add_option("--caves", def.caves, "Width and height of a made map of caves [cells]")
        ->check(CLI::Range(16, 4096));
    ground.add_option("--metres", def.metres, "Metres per cell of the map (1)")
        ->check(CLI::Range(0.05, 100.0));
    ground.add_flag("--lead", o.lead, "Leads the group from one end of the map to the other instead");
    ground.add_option("--stride", o.ground.stride, "Between two poses [m] (10); 0 for one order to the end");
    ground.add_option("--speed", o.ground.speed, "Of the poses [m/s] (1.5)")->check(CLI::Range(0.1, 100.0));
    ground.add_option("--length", o.ground.length, "Of the way, at most [m]");
    ground.add_option("--seconds", o.ground.seconds, "World time, at most [s] (3600)");
}

void describeCommands(CLI::App& commands, CommandsDef& def) {
    commands.add_option("--n", def.count, "Characters (360)")->check(CLI::Range(16, 20000));
    commands.add_option("--obstacles", def.obstacles, "Discs of 0.5 m (100)")->check(CLI::Range(0, 20000));
    commands.add_option("--side", def.side, "Side of the ground [m] (200)")->check(CLI::Range(50.0, 1000.0));
    commands.add_option("--rounds", def.rounds, "Commands of each kind (6)")->check(CLI::Range(1, 100));
    commands.add_option("--runs", def.runs, "Equal runs; a step's time is its least over them (5)")
        ->check(CLI::Range(1, 50));
    commands.add_flag("--formations", def.formations, "Also asks for other formations");
    commands.add_flag("--free", def.free, "Each walks by the shortest way; else the formation marches");
}

void describeOrders(CLI::App& orders, OrdersDef& def) {
    orders.add_option("--groups", def.groups, "Groups (2)")->check(CLI::Range(1, 1000));
    orders.add_option("--n", def.count, "Characters of all groups (1500)")->check(CLI::Range(8, 100000));
    orders.add_option("--obstacles", def.obstacles, "Discs of 0.5 m strewn over the square (0)")
        ->check(CLI::Range(0, 100000));
    orders.add_option("--gaps", def.gaps, "Gaps in a wall through which all walk (0: no wall)")
        ->check(CLI::Range(0, 100));
    orders.add_flag("--moves", def.moves, "Orders to march there instead of poses");
    orders.add_flag("--weights", def.weights, "Supplies and demands at random, 0.25 to 3 units");
    orders.add_option("--runs", def.runs, "Equal runs; a step's time is its least over them (5)")
        ->check(CLI::Range(1, 50));
    orders.add_option("--seconds", def.seconds, "World time of a run [s] (10)")
        ->check(CLI::Range(0.1, 120.0));
    orders.add_option("--seed", def.seed, "Seed of the obstacles (1)");
}

void describeRewind(CLI::App& rewind, RewindDef& def) {
    rewind.add_option("--scene", def.scene.name, "Scene (" + def.scene.name + ")")
        ->check(CLI::IsMember(sceneNames()));
    rewind.add_option("--n", def.scene.count, "Characters (360)")->check(CLI::Range(4, 100000));
    rewind.add_option("--seed", def.scene.seed, "Seed of the scene (1)");
    rewind.add_option("--seconds", def.seconds, "World time [s] (12)")->check(CLI::Range(3.0, 600.0));
    rewind.add_option("--maps", def.scene.maps, "Folder with the city's map (../shared/maps)");
    rewind.add_flag("--edits", def.edits, "A building is added in the fourth of each eight steps");
}

void describeBattle(CLI::App& battle, BattleDef& def) {
    battle.add_option("--groups", def.groups, "Groups of both sides (20)")->check(CLI::Range(2, 200));
    battle.add_option("--obstacles", def.obstacles, "Blocks and discs (60)")->check(CLI::Range(0, 5000));
    battle.add_option("--side", def.side, "Of the ground [m] (200)")->check(CLI::Range(100.0, 4000.0));
    battle.add_option("--seconds", def.seconds, "World time before the stop [s] (60)")
        ->check(CLI::Range(1.0, 3600.0));
    battle.add_option("--seed", def.seed, "Seed of everything (1)");
}

void describePeople(CLI::App& people, PeopleCostDef& def) {
    people.add_option("--count", def.counts, "Characters, one or more (1000 10000 100000)")
        ->check(CLI::Range(100, 200000));
    people.add_option("--density", def.densities, "Characters per square metre, one or more (0.5 4)")
        ->check(CLI::Range(0.05, 4.5));
    people.add_option("--rounds", def.rounds, "Turns of each law (5)")->check(CLI::Range(1, 1000));
}

template <class T>
void orElse(std::vector<T>& values, std::vector<T> defaults) {
    if (values.empty()) values = std::move(defaults);
}

bool hasFastPlan() {
    Parameters parameters;
    return setParameter(parameters, "plan.solver", 1.0).ok();
}

Status check(const Options& o) {
    const auto among = [](const char* what, const std::vector<std::string>& found,
                          const std::vector<std::string>& known) {
        std::string all;
        for (const std::string& name : known) all.append(all.empty() ? "" : ", ").append(name);
        for (const std::string& name : found)
            if (std::find(known.begin(), known.end(), name) == known.end())
                return invalidArgument(std::string("found ")
                                           .append(what)
                                           .append(" '")
                                           .append(name)
                                           .append("', expected one of ")
                                           .append(all));
        return Status();
    };
    if (Status status = among("scene", o.scenes, sceneNames()); !status.ok()) return status;
    if (Status status = among("regime", o.regimes, {"far", "tracking", "reversing"}); !status.ok())
        return status;
    if (Status status = among("plan", o.plans, {"exact", "fast"}); !status.ok()) return status;
    for (const std::int32_t n : o.counts)
        if (n < 4 || n > 100000)
            return invalidArgument("found n " + std::to_string(n) + ", expected 4 to 100000");
    for (const std::int32_t t : o.threads)
        if (t < 1 || t > 256)
            return invalidArgument("found threads " + std::to_string(t) + ", expected 1 to 256");
    if (!(o.seconds >= 0.0 && o.seconds <= 3600.0)) return invalidArgument("--seconds: expected 0 to 3600");
    if (o.gapEvery < 0) return invalidArgument("--gap-every: expected at least 1");
    if (o.json && o.markdown) return invalidArgument("found --json and --markdown, expected one of them");
    return {};
}

}  // namespace

int readOptions(int argc, const char* const* argv, Options& options) {
    CLI::App app("Measures Muster's steps at scale.", "muster-bench");
    app.require_subcommand(1);
    CLI::App* scale = app.add_subcommand("scale",
                                         "Scenes, regimes and sizes: time of a step, gap, swaps, memory");
    describe(*scale, options);
    describeGround(*app.add_subcommand(
                       "ground", "A large world: creating it, an order, an edit, a restore; time and memory"),
                   options);
    describeOrders(
        *app.add_subcommand("orders", "Groups cross, one gets a new pose each 0.5 s: time of a step"),
        options.orders);
    describeCommands(*app.add_subcommand("commands", "Orders, deaths, splits...: time above a plain step"),
                     options.commands);
    describeBattle(*app.add_subcommand("battle",
                                       "Two sides of many groups, as a strategy game directs them: "
                                       "time of a step, and how everybody fares"),
                   options.battle);
    describePeople(*app.add_subcommand("people", "The law of people beside that of units: time of a step"),
                   options.people);
    describeRewind(*app.add_subcommand("rewind", "Eight steps, back, and the same again: time of both"),
                   options.rewind);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "muster-bench: %s (see muster-bench scale --help)\n", error.what());
        return kWrong;
    }
    options.command = app.get_subcommands().front()->get_name();
    if (const Status status = check(options); !status.ok()) {
        std::fprintf(stderr, "muster-bench: %s\n", status.message().c_str());
        return kWrong;
    }
    if (options.gapEvery == 0) options.gapEvery = options.quick ? 120 : 30;
    return kGoOn;
}

Result<std::vector<CaseDef>> casesOf(const Options& asked) {
    Options o = asked;
    if (Status status = check(o); !status.ok()) return status;
    orElse(o.scenes, sceneNames());
    orElse(o.regimes, {"far", "tracking", "reversing"});
    orElse(o.counts,
           o.quick ? std::vector<std::int32_t>{160, 1000} : std::vector<std::int32_t>{160, 1000, 10000});
    orElse(o.plans, {hasFastPlan() ? "fast" : "exact"});
    orElse(o.threads, {1});
    orElse(o.seeds, o.quick ? std::vector<std::uint64_t>{1} : std::vector<std::uint64_t>{1, 2, 3});
    std::vector<CaseDef> cases;
    for (const std::int32_t n : o.counts)
        for (const std::string& scene : o.scenes)
            for (const Regime regime : {Regime::Far, Regime::Tracking, Regime::Reversing})
                for (const std::string& plan : o.plans)
                    for (const std::int32_t threads : o.threads)
                        for (const std::uint64_t seed : o.seeds) {
                            if (std::find(o.regimes.begin(), o.regimes.end(), regimeName(regime)) ==
                                o.regimes.end())
                                continue;
                            const double quick = regime == Regime::Far ? 10.0 : 5.0;
                            const double seconds = o.seconds > 0.0 ? o.seconds : (o.quick ? quick : 0.0);
                            cases.push_back({{scene, regime, n, seed, o.maps}, plan, threads, seconds});
                        }
    return cases;
}

}  // namespace muster::scale
