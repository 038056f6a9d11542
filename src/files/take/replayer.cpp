#include "files/take/replayer.h"

#include <algorithm>
#include <string>

#include "base/hash.h"
#include "files/take/take_frames.h"

namespace muster {
namespace {

constexpr std::uint32_t kFramesClient = 0xffffffff;  // Who puts characters where stored frames say.

}  // namespace

Status Replayer::submitUntil(World& world, std::size_t end) {
    for (; nextCommand_ < end; ++nextCommand_) {
        const Command& command = take_->commands[nextCommand_];
        // What an older Muster took and this one refuses is left out where frames are shown.
        if (Status s = world.submit(command); !s.ok() && !stored_)
            return s.within("command of client " + std::to_string(command.client) + " for step " +
                            std::to_string(command.step));
    }
    return {};
}

Status Replayer::submit(World& world) {
    // Marks may precede the first step.
    if (Status s = compare(world); !s.ok()) return s;
    // An unfinished take may have commands after its last mark.
    const bool marked = nextMark_ < take_->marks.size();
    const std::size_t end = marked ? take_->marks[nextMark_].commands : take_->commands.size();
    if (Status s = submitUntil(world, end); !s.ok()) return s;
    return stored_ ? putCharacters(world) : Status();
}

// Commands of a client of its own, which come after all others of the step.
Status Replayer::putCharacters(World& world) {
    std::vector<std::uint32_t> ids;
    std::vector<Vec2> positions;
    if (!FrameCurve(*take_).at(world.stepCount() + 1, ids, positions)) return {};
    const CharactersView characters = world.characters();
    std::vector<std::uint32_t> fresh;
    WriteMotion put;
    for (std::size_t k = 0, i = 0; k < ids.size(); ++k) {
        while (i < characters.id.size() && characters.id[i] < ids[k]) ++i;
        if (i >= characters.id.size() || characters.id[i] != ids[k]) continue;
        if (characters.driver[i] != Driver::Outside) fresh.push_back(ids[k]);
        put.ids.push_back(ids[k]);
        put.positions.push_back(positions[k]);
    }
    std::uint32_t sequence = 0;
    const auto give = [&](CommandBody body) {
        return world.submit({world.stepCount(), kFramesClient, sequence++, std::move(body)});
    };
    if (!fresh.empty())
        if (Status s = give(ChangeCharacters{std::move(fresh), {}, Driver::Outside}); !s.ok()) return s;
    return put.ids.empty() ? Status() : give(std::move(put));
}

// The world may raise more events than the take holds, which may be older than these events.
Status Replayer::compareEvents(const World& world) {
    const auto& events = take_->events;
    for (; nextEvent_ < events.size() && events[nextEvent_].step <= world.stepCount(); ++nextEvent_) {
        const TakeEvent& raised = events[nextEvent_];
        const auto now = world.events();
        if (raised.step == world.stepCount() && std::find(now.begin(), now.end(), raised.event) != now.end())
            continue;
        return {StatusCode::Corrupt, "step " + std::to_string(raised.step) + ": found no event '" +
                                         eventKindName(raised.event.kind) + "' of " +
                                         std::to_string(raised.event.subject) + " with " +
                                         std::to_string(raised.event.value) + ", expected it as recorded"};
    }
    return {};
}

Status Replayer::compare(World& world) {
    if (!stored_)
        if (Status s = compareEvents(world); !s.ok()) return s;
    const auto& marks = take_->marks;
    for (; nextMark_ < marks.size() && marks[nextMark_].step == world.stepCount(); ++nextMark_) {
        const HashMark& mark = marks[nextMark_];
        // Waiting commands are part of the state, so the hash covers exactly the commands recorded before the
        // mark.
        if (Status s = submitUntil(world, mark.commands); !s.ok()) return s;
        if (stored_) continue;
        lastHash_ = world.hash();
        if (marked_ != nullptr) marked_->marks[nextMark_].hash = lastHash_;
        if (lastHash_ != mark.hash) {
            return {StatusCode::Corrupt, "step " + std::to_string(mark.step) + ": found the hash " +
                                             toHex(lastHash_) + ", expected " + toHex(mark.hash) +
                                             (compared_ == 0 ? "" : " (all marks before it match)")};
        }
        ++compared_;
    }
    return {};
}

}  // namespace muster
