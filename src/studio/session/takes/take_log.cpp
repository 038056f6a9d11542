#include "studio/session/takes/take_log.h"

#include <algorithm>
#include <utility>

#include "files/take/take_encoder.h"

namespace muster {
namespace {

constexpr std::size_t kEndBytes = 64;  // Space reserved for the end record.

}  // namespace

void TakeLog::begin(const WorldDef& def, std::size_t limit) {
    sink_.reset();
    failure_ = Status();
    bytes_ = TakeEncoder::begin(def);
    limit_ = limit;
    full_ = false;
    commands_ = 0;
    storesFrames_ = false;
    frames_ = {};
}

// Commands and events stand before the first mark at or after their step. A mark whose hash covers a dropped
// command holds no more and is left out.
void TakeLog::resume(const Take& take, std::uint32_t step, std::size_t commands, bool drop,
                     std::size_t limit) {
    begin(take.def, limit);
    bool holds = true;
    std::size_t next = 0, nextEvent = 0;
    const auto submitUntil = [&](std::size_t end) {
        for (; next < std::min(end, commands); ++next) {
            const bool dropped = drop && take.commands[next].step >= step;
            holds = holds && !dropped;
            if (!dropped) command(take.commands[next]);
        }
    };
    const auto raiseUntil = [&](std::uint32_t last) {
        for (; nextEvent < take.events.size() && take.events[nextEvent].step <= last; ++nextEvent)
            append(TakeEncoder::event(take.events[nextEvent]));
    };
    for (const HashMark& mark : take.marks) {
        if (mark.step > step) break;
        raiseUntil(mark.step);
        submitUntil(mark.commands);
        if (holds) append(TakeEncoder::mark(mark));
    }
    raiseUntil(step);
    submitUntil(commands);
    const auto later = std::find_if(take.frames.begin(), take.frames.end(),
                                    [&](const TakeFrame& frame) { return frame.step > step; });
    const auto count = static_cast<std::size_t>(later - take.frames.begin());
    append(TakeEncoder::frames(std::span(take.frames).first(count)));
}

void TakeLog::storeFrames(bool on) {
    flushFrames();
    storesFrames_ = on;
}

void TakeLog::flushFrames() {
    append(TakeEncoder::frames(frames_.take()));
}

void TakeLog::append(const std::vector<std::uint8_t>& record) {
    if (full_ || record.empty()) return;
    if (bytes_.size() + record.size() + kEndBytes > limit_) {
        full_ = true;
        return;
    }
    bytes_.insert(bytes_.end(), record.begin(), record.end());
    if (!sink_) return;
    // A file that cannot be written is detached; the log in memory stays complete.
    failure_ = sink_->append(record);
    if (!failure_.ok()) sink_.reset();
}

Status TakeLog::takeFailure() {
    return std::exchange(failure_, Status());
}

void TakeLog::command(const Command& command) {
    append(TakeEncoder::command(command));
    ++commands_;
}

void TakeLog::observe(const World& world) {
    if (const auto events = TakeEncoder::events(world); !events.empty()) append(events);
    if (storesFrames_ && frames_.observe(world)) flushFrames();
    if (world.stepCount() % kTakeMarkSpacing != 0 || full_) return;
    append(TakeEncoder::mark({world.stepCount(), world.hash()}));
}

std::vector<std::uint8_t> TakeLog::bytes(const World& world) const {
    std::vector<std::uint8_t> all = bytes_;
    if (full_) return all;
    const auto frames = TakeEncoder::frames(frames_.waiting());
    all.insert(all.end(), frames.begin(), frames.end());
    const auto end = TakeEncoder::end({world.stepCount(), world.hash()});
    all.insert(all.end(), end.begin(), end.end());
    return all;
}

Status TakeLog::attach(std::unique_ptr<TakeSink> sink, const TakeAbout& about) {
    Status status = sink->append(bytes_);
    if (status.ok()) status = sink->append(TakeEncoder::about(about));
    if (status.ok()) sink_ = std::move(sink);
    return status;
}

Status TakeLog::discard() {
    if (!sink_) return {};
    const Status discarded = sink_->discard();
    sink_.reset();
    return discarded;
}

Status TakeLog::detach(const World& world, const TakeAbout& about) {
    flushFrames();
    if (!sink_) return {};
    Status status = sink_->append(TakeEncoder::about(about));
    if (status.ok() && !full_) status = sink_->append(TakeEncoder::end({world.stepCount(), world.hash()}));
    const Status finished = sink_->finish();
    sink_.reset();
    return status.ok() ? finished : status;
}

}  // namespace muster
