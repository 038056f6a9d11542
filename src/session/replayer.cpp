#include "session/replayer.h"

#include <string>

#include "base/hash.h"

namespace muster {

Status Replayer::feed(World& world) {
    while (nextMark_ < take_.marks.size() && take_.marks[nextMark_].step <= world.stepCount()) ++nextMark_;
    // Behind the last mark of an unfinished take there may be commands still.
    const bool marked = nextMark_ < take_.marks.size();
    const std::size_t until = marked ? take_.marks[nextMark_].commands : take_.commands.size();
    for (; nextCommand_ < until; ++nextCommand_) {
        const Status status = world.submit(take_.commands[nextCommand_]);
        if (!status.ok()) return status.within("command " + std::to_string(nextCommand_) + " of the take");
    }
    return {};
}

Status Replayer::compare(World& world) {
    for (; nextMark_ < take_.marks.size() && take_.marks[nextMark_].step == world.stepCount(); ++nextMark_) {
        const HashMark& mark = take_.marks[nextMark_];
        // Commands still waiting are state too: those recorded before the mark were given before it was made.
        for (; nextCommand_ < mark.commands; ++nextCommand_) {
            const Status status = world.submit(take_.commands[nextCommand_]);
            if (!status.ok())
                return status.within("command " + std::to_string(nextCommand_) + " of the take");
        }
        if (const std::uint64_t hash = world.hash(); hash != mark.hash) {
            return {StatusCode::Corrupt, "step " + std::to_string(mark.step) + ": found the hash " +
                                             toHex(hash) + ", expected " + toHex(mark.hash)};
        }
    }
    return {};
}

}  // namespace muster
