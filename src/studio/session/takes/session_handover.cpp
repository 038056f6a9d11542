// A world goes from one session to another: from a server that is lost to the engine beside the page.
#include <algorithm>

#include "muster/scenario.h"
#include "muster/take.h"
#include "studio/session/session_state.h"

namespace muster {
namespace {

constexpr const char* kHandoverName = "the handover of a world";

/// The step after the last touch of the demonstration; 0 for none.
std::uint32_t endOfDemonstration(const Take& take) {
    std::uint32_t end = 0;
    for (const Command& command : take.commands)
        if (command.client >= 1 && command.client <= kLastDemonstrator) end = std::max(end, command.step + 1);
    return end;
}

}  // namespace

Result<std::vector<std::uint8_t>> Session::handover(std::uint32_t world, std::uint64_t takeBytes) const {
    const Impl& session = *impl_;
    if (!session.world) return Status(StatusCode::NotFound, "there is no world yet");
    Handover handover;
    handover.world = session.worldNumber;
    handover.name = session.name;
    handover.open = session.player != nullptr;
    handover.playing = session.playing;
    handover.speed = session.speed;
    handover.step = session.world->stepCount();
    const std::vector<std::uint8_t>& take = handover.open ? session.takenBytes : session.log.records();
    const bool known = world == session.worldNumber && takeBytes <= take.size();
    handover.takeFrom = known ? takeBytes : 0;
    handover.take.assign(take.begin() + static_cast<std::ptrdiff_t>(handover.takeFrom), take.end());
    if (handover.open) return handover.bytes();
    handover.complete = !session.log.full();
    handover.recording = session.recordedFrom >= 0.0;
    handover.recordedFrom = session.recordedAbout.from;
    handover.snapshot = session.world->snapshot();
    if (session.editor.place().edited()) {
        auto place = scenario();
        if (!place.ok()) return place.status();
        handover.place = std::move(place).value();
    }
    return handover.bytes();
}

Status Session::takeOver(std::span<const std::uint8_t> bytes) {
    const auto handover = Handover::parse(bytes);
    if (!handover.ok()) return handover.status();
    if (handover->takeFrom > 0)
        return invalidArgument(std::string(kHandoverName) + ": the first " +
                               std::to_string(handover->takeFrom) + " bytes of its take are missing");
    const Status taken = handover->open ? impl_->openTake(handover->take, kHandoverName, {})
                                        : impl_->takeOverWorld(*handover);
    if (!taken.ok()) return taken;
    if (handover->open) impl_->player->want(handover->step);
    impl_->playing = handover->playing;
    impl_->speed = handover->speed;
    impl_->touchState();
    return {};
}

Status Session::Impl::takeOverWorld(const Handover& handover) {
    auto take = parseTake(handover.take, kHandoverName);
    if (!take.ok()) return take.status();
    auto restored = World::restore(handover.snapshot, def.threads);
    if (!restored.ok()) return restored.status().within(kHandoverName);
    if (restored->stepCount() != handover.step)
        return invalidArgument(std::string(kHandoverName) + ": found a world of step " +
                               std::to_string(restored->stepCount()) + ", expected " +
                               std::to_string(handover.step));
    WorldDef place = take->def;
    if (!handover.place.empty()) {
        auto edited = parseScenario(handover.place, kHandoverName, "");
        if (!edited.ok()) return edited.status();
        place = std::move(edited).value();
    }
    beginWith(std::move(restored).value(), handover.name, place);
    log.resume(*take, handover.step, take->commands.size(), false, def.limits.takeBytes);
    if (!handover.complete) log.close();
    demonstratedUntil = endOfDemonstration(*take);
    renumberClients(*take);
    liftRecorded(*take, handover.step, demonstrating() ? kLastDemonstrator : 0);
    if (handover.recording) beginRecording(handover.recordedFrom, {}, nullptr);
    refreshScene();
    return {};
}

}  // namespace muster
