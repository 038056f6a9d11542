#include "studio/session/takes/run_again.h"

#include <algorithm>

#include "engine/state/command_order.h"

namespace muster {

void runAgain(Take& take, std::uint32_t steps) {
    std::stable_sort(take.commands.begin(), take.commands.end(), comesBefore);
    std::erase_if(take.commands, [&](const Command& command) { return command.step >= steps; });
    take.marks.clear();
    take.events.clear();
    take.frames.clear();
    std::size_t commands = 0;
    for (std::uint32_t step = kTakeMarkSpacing;; step += kTakeMarkSpacing) {
        const std::uint32_t at = std::min(step, steps);
        while (commands < take.commands.size() && take.commands[commands].step < at) ++commands;
        take.marks.push_back({at, 0, static_cast<std::uint32_t>(commands)});
        if (at == steps) break;
    }
    take.finished = true;
    take.tornBytes = 0;
}

}  // namespace muster
