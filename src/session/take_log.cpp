#include "session/take_log.h"

#include <utility>

#include "io/take/take_encoder.h"

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
}

void TakeLog::append(const std::vector<std::uint8_t>& record) {
    if (full_) return;
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
}

void TakeLog::observe(const World& world) {
    if (const auto events = TakeEncoder::events(world); !events.empty()) append(events);
    if (world.stepCount() % kTakeMarkSpacing != 0 || full_) return;
    append(TakeEncoder::mark({world.stepCount(), world.hash()}));
}

std::vector<std::uint8_t> TakeLog::bytes(const World& world) const {
    std::vector<std::uint8_t> all = bytes_;
    if (full_) return all;
    const auto end = TakeEncoder::end({world.stepCount(), world.hash()});
    all.insert(all.end(), end.begin(), end.end());
    return all;
}

Status TakeLog::attach(std::unique_ptr<TakeSink> sink) {
    Status status = sink->append(bytes_);
    if (status.ok()) sink_ = std::move(sink);
    return status;
}

Status TakeLog::detach(const World& world) {
    if (!sink_) return {};
    Status status;
    if (!full_) status = sink_->append(TakeEncoder::end({world.stepCount(), world.hash()}));
    const Status finished = sink_->finish();
    sink_.reset();
    return status.ok() ? finished : status;
}

}  // namespace muster
