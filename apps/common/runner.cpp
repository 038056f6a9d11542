#include "runner.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "muster/take.h"
#include "report.h"
#include "trajectory.h"

namespace muster {
namespace {

constexpr double kMostSteps = 4294967295.0;  // Largest number of steps that a step counter can represent.

/// The files that are written while a world runs.
struct Recorders {
    std::optional<TakeWriter> take;
    std::optional<TrajectoryWriter> trajectory;
    std::uint32_t every = 1;

    Status open(const WorldDef& def, const RunDef& run) {
        if (!run.takePath.empty()) {
            auto writer = TakeWriter::create(run.takePath, def);
            if (!writer.ok()) return writer.status();
            take.emplace(std::move(writer).value());
        }
        if (!run.trajectoryPath.empty()) {
            auto writer = TrajectoryWriter::create(run.trajectoryPath);
            if (!writer.ok()) return writer.status();
            trajectory.emplace(std::move(writer).value());
            every = static_cast<std::uint32_t>(run.every);
        }
        return {};
    }
    Status observe(const World& world) {
        if (trajectory && world.stepCount() % every == 0) trajectory->add(world);
        return take && world.stepCount() > 0 ? take->observe(world) : Status();
    }
    Status finish(const World& world) {
        if (take) {
            if (Status s = take->finish(world); !s.ok()) return s;
        }
        return trajectory ? trajectory->close() : Status();
    }
};

}  // namespace

Result<RunOutcome> runWorld(World world, const WorldDef& def, const std::vector<Command>& commands,
                            const RunDef& run) {
    Recorders recorders;
    if (Status s = recorders.open(def, run); !s.ok()) return s;
    std::uint32_t lastCommand = 0;
    for (const Command& command : commands) {
        if (Status s = world.submit(command); !s.ok()) return s;
        if (recorders.take) {
            if (Status s = recorders.take->command(command); !s.ok()) return s;
        }
        lastCommand = std::max(lastCommand, command.step);
    }
    const double stepTime = def.parameters.stepTime;
    const bool open = run.seconds < 0.0;
    const double wanted = open ? lastCommand * stepTime + run.longest : run.seconds;
    const auto steps = static_cast<std::uint32_t>(
        std::clamp(std::floor(wanted / stepTime + 0.5), 0.0, kMostSteps));
    const auto second = static_cast<std::uint32_t>(std::ceil(1.0 / stepTime));
    RunMetrics metrics(world);
    Progress progress(run.label.empty() ? "simulating" : run.label);
    if (Status s = recorders.observe(world); !s.ok()) return s;
    while (world.stepCount() < steps) {
        world.step();
        metrics.observe(world);
        if (Status s = recorders.observe(world); !s.ok()) return s;
        for (const Rejection& rejection : world.rejections())
            std::fprintf(stderr, "muster: step %u: %s was refused: %s\n", rejection.command.step,
                         commandName(rejection.command), rejection.status.message().c_str());
        progress.show(static_cast<double>(world.stepCount()) / steps);
        const bool due = open && world.stepCount() > lastCommand + 2 * second &&
                         world.stepCount() % (second / 2) == 0;
        if (due && metrics.settled(world)) break;
    }
    if (Status s = recorders.finish(world); !s.ok()) return s;
    RunOutcome outcome{metrics.figures(world, run.pathRatio), open && !metrics.settled(world), {}};
    const std::vector<StandingCounts> counts = countStandings(world);
    for (std::size_t g = 0; g < counts.size(); ++g)
        outcome.standings.push_back({groupTitle(world.group(g)), counts[g]});
    return outcome;
}

}  // namespace muster
