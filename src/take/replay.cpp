#include "muster/take/take.h"

#include <string>

namespace muster {
namespace {

Status submitAgain(World& world, const Command& command) {
    return world.submit(command).within("command of client " + std::to_string(command.client) + " for step " +
                                        std::to_string(command.step));
}

}  // namespace

Result<ReplayReport> replayTake(const Take& take, std::int32_t threads,
                                const std::function<bool(const World&)>& observe) {
    auto world = World::create(take.def, threads);
    if (!world.ok()) return world.status();
    ReplayReport report;
    std::size_t next = 0;  // Command.
    for (const HashMark& mark : take.marks) {
        // Commands still waiting are state too, so none is submitted before its turn in the file.
        for (; next < mark.commands; ++next) {
            if (Status s = submitAgain(*world, take.commands[next]); !s.ok()) return s;
        }
        bool go = true;
        while (go && world->stepCount() < mark.step) {
            world->step();
            if (observe) go = observe(*world);
        }
        report.steps = world->stepCount();
        if (!go) break;
        report.hash = world->hash();
        if (report.hash != mark.hash) {
            return Status(StatusCode::Corrupt, "step " + std::to_string(mark.step) + ": found the hash " +
                                                   toHex(report.hash) + ", expected " + toHex(mark.hash) +
                                                   (report.compared == 0 ? "" : " (all marks before it match)"));
        }
        ++report.compared;
    }
    return report;
}

}  // namespace muster
