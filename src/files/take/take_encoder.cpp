#include <cstring>

#include "engine/state/command_archive.h"
#include "files/take/take_encoder.h"
#include "files/take/take_format.h"
#include "files/take/take_frames.h"
#include "muster/scenario.h"
#include "muster/take.h"

namespace muster {
namespace {

void putWord(std::vector<std::uint8_t>& bytes, std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(word >> shift));
}

/// Appends one record: u32 length, u8 kind, u32 checksum of both, payload, u32 checksum of the payload.
void putRecord(std::vector<std::uint8_t>& bytes, RecordKind kind, std::span<const std::uint8_t> payload) {
    const std::size_t start = bytes.size();
    putWord(bytes, static_cast<std::uint32_t>(payload.size()));
    bytes.push_back(static_cast<std::uint8_t>(kind));
    putWord(bytes, crc32(std::span(bytes).subspan(start, 5)));
    bytes.insert(bytes.end(), payload.begin(), payload.end());
    putWord(bytes, crc32(payload));
}

std::vector<std::uint8_t> markRecord(RecordKind kind, const HashMark& mark) {
    Writer writer;
    writer(mark.step, mark.hash);
    std::vector<std::uint8_t> bytes;
    putRecord(bytes, kind, writer.bytes());
    return bytes;
}

}  // namespace

std::vector<std::uint8_t> TakeEncoder::begin(const WorldDef& def) {
    std::vector<std::uint8_t> bytes(kTakeMagic.begin(), kTakeMagic.end());
    putWord(bytes, kTakeVersion);
    const std::string text = writeScenario(def);
    std::vector<std::uint8_t> payload(text.begin(), text.end());
    putRecord(bytes, RecordKind::Scenario, payload);
    return bytes;
}

std::vector<std::uint8_t> TakeEncoder::command(const Command& command) {
    Writer writer;
    encodeCommand(writer, command);
    std::vector<std::uint8_t> bytes;
    putRecord(bytes, RecordKind::Command, writer.bytes());
    return bytes;
}

std::vector<std::uint8_t> TakeEncoder::event(const TakeEvent& raised) {
    Writer writer;
    writer(raised.step, raised.event);
    std::vector<std::uint8_t> bytes;
    putRecord(bytes, RecordKind::Event, writer.bytes());
    return bytes;
}

std::vector<std::uint8_t> TakeEncoder::events(const World& world) {
    std::vector<std::uint8_t> bytes;
    for (const Event& one : world.events()) {
        if (!isOrderEvent(one.kind)) continue;
        const std::vector<std::uint8_t> record = event({world.stepCount(), one});
        bytes.insert(bytes.end(), record.begin(), record.end());
    }
    return bytes;
}

std::vector<std::uint8_t> TakeEncoder::about(const TakeAbout& about) {
    const std::string text = writeTakeAbout(about);
    const std::vector<std::uint8_t> payload(text.begin(), text.end());
    std::vector<std::uint8_t> bytes;
    putRecord(bytes, RecordKind::About, payload);
    return bytes;
}

std::vector<std::uint8_t> TakeEncoder::frames(std::span<const TakeFrame> frames) {
    std::vector<std::uint8_t> bytes;
    if (!frames.empty()) putRecord(bytes, RecordKind::Frames, packFrames(frames));
    return bytes;
}

std::vector<std::uint8_t> TakeEncoder::mark(const HashMark& mark) {
    return markRecord(RecordKind::Mark, mark);
}

std::vector<std::uint8_t> TakeEncoder::end(const HashMark& mark) {
    return markRecord(RecordKind::End, mark);
}

std::vector<std::uint8_t> TakeEncoder::whole(const Take& take, const TakeAbout& said) {
    std::vector<std::uint8_t> bytes = begin(take.def);
    const auto append = [&](const std::vector<std::uint8_t>& record) {
        bytes.insert(bytes.end(), record.begin(), record.end());
    };
    std::size_t next = 0, raised = 0;
    for (const HashMark& one : take.marks) {
        for (; raised < take.events.size() && take.events[raised].step <= one.step; ++raised)
            append(event(take.events[raised]));
        for (; next < one.commands; ++next) append(command(take.commands[next]));
        if (&one != &take.marks.back()) append(mark(one));
    }
    append(frames(take.frames));
    append(about(said));
    if (!take.marks.empty()) append(end(take.marks.back()));
    return bytes;
}

}  // namespace muster
