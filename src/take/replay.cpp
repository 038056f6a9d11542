#include "muster/take/take.h"

namespace muster {

Result<ReplayReport> replayTake(const Take& take, std::int32_t threads,
                                const std::function<bool(const World&)>& observe) {
    auto world = World::create(take.def, threads);
    if (!world.ok()) return world.status();
    for (const Command& command : take.commands) {
        if (command.step >= take.steps()) continue;
        if (Status s = world->submit(command); !s.ok()) {
            return s.within("command of client " + std::to_string(command.client) + " at step " +
                            std::to_string(command.step));
        }
    }
    ReplayReport report;
    for (const HashMark& mark : take.marks) {
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
