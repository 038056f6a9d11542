#include <algorithm>

#include "files/take/replayer.h"

#include "base/hash.h"

namespace muster {
std::uint32_t Take::steps() const {
    std::uint32_t steps = markedSteps();
    if (finished) return steps;
    constexpr std::uint32_t kLast = 0xffffffff;
    for (std::size_t i = marks.empty() ? 0 : marks.back().commands; i < commands.size(); ++i)
        steps = std::max(steps, std::min(commands[i].step, kLast - 1) + 1);
    return steps;
}

bool simulatesAlike(const Take& take, std::int32_t threads) {
    const auto first = std::find_if(take.marks.begin(), take.marks.end(),
                                    [](const HashMark& mark) { return mark.step > 0; });
    if (first == take.marks.end()) return true;
    bool more = true;
    const auto report = replayTake(take, threads, [&](const World& world) {
        // The mark itself is compared after this.
        more = world.stepCount() <= first->step;
        return more;
    });
    return report.ok();
}

Result<ReplayReport> replayTake(const Take& take, std::int32_t threads,
                                const std::function<bool(const World&)>& observe, ReplayFrom from) {
    if (from == ReplayFrom::Frames && take.frames.empty())
        return Status(StatusCode::Unsupported, "the take holds no stored frames");
    auto world = World::create(take.def, threads);
    if (!world.ok()) return world.status();
    Replayer replayer = from == ReplayFrom::Frames ? Replayer::stored(take) : Replayer(take);
    const auto report = [&] {
        return ReplayReport{world->stepCount(), replayer.compared(), 0, replayer.lastHash()};
    };
    if (Status s = replayer.compare(*world); !s.ok()) return s;
    while (!replayer.atEnd(*world)) {
        if (Status s = replayer.submit(*world); !s.ok()) return s;
        world->step();
        if (observe && !observe(*world)) return report();
        if (Status s = replayer.compare(*world); !s.ok()) return s;
    }
    ReplayReport all = report();
    if (from == ReplayFrom::Frames) return all;
    all.unmarked = replayer.unmarked();
    if (all.unmarked > 0) all.hash = world->hash();
    return all;
}

}  // namespace muster
