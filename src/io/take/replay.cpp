#include "muster/take.h"

#include <algorithm>
#include <string>

#include "base/hash.h"

namespace muster {
namespace {

Status submitAgain(World& world, const Command& command) {
    return world.submit(command).within("command of client " + std::to_string(command.client) + " for step " +
                                        std::to_string(command.step));
}

}  // namespace

std::uint32_t Take::steps() const {
    std::uint32_t steps = markedSteps();
    if (finished) return steps;
    constexpr std::uint32_t kLast = 0xffffffff;
    for (std::size_t i = marks.empty() ? 0 : marks.back().commands; i < commands.size(); ++i)
        steps = std::max(steps, std::min(commands[i].step, kLast - 1) + 1);
    return steps;
}

Result<ReplayReport> replayTake(const Take& take, std::int32_t threads,
                                const std::function<bool(const World&)>& observe) {
    auto world = World::create(take.def, threads);
    if (!world.ok()) return world.status();
    ReplayReport report;
    std::size_t next = 0;  // Command.
    bool go = true;
    const auto advance = [&](std::uint32_t step) {
        while (go && world->stepCount() < step) {
            world->step();
            if (observe) go = observe(*world);
        }
        report.steps = world->stepCount();
    };
    for (const HashMark& mark : take.marks) {
        // Commands still waiting are state too, so none is submitted before its turn in the file.
        for (; next < mark.commands; ++next) {
            if (Status s = submitAgain(*world, take.commands[next]); !s.ok()) return s;
        }
        advance(mark.step);
        if (!go) return report;
        report.hash = world->hash();
        if (report.hash != mark.hash) {
            return Status(StatusCode::Corrupt,
                          "step " + std::to_string(mark.step) + ": found the hash " + toHex(report.hash) +
                              ", expected " + toHex(mark.hash) +
                              (report.compared == 0 ? "" : " (all marks before it match)"));
        }
        ++report.compared;
    }
    if (take.steps() == take.markedSteps()) return report;
    // A killed writer's last commands, given after the last mark: nothing says what came of them.
    for (; next < take.commands.size(); ++next) {
        if (Status s = submitAgain(*world, take.commands[next]); !s.ok()) return s;
    }
    advance(take.steps());
    report.unmarked = report.steps - take.markedSteps();
    report.hash = world->hash();
    return report;
}

}  // namespace muster
