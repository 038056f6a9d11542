#include <cstring>

#include "base/text_file.h"
#include "engine/state/command_archive.h"
#include "files/take/take_format.h"
#include "files/take/take_frames.h"
#include "muster/scenario.h"
#include "muster/take.h"

namespace muster {
namespace {

constexpr std::size_t kMaxTakeBytes = 1u << 30;

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t offset) {
    std::uint32_t word = 0;
    for (int i = 3; i >= 0; --i) word = word << 8 | bytes[offset + static_cast<std::size_t>(i)];
    return word;
}

/// Iterates over the records of a take.
class TakeParser {
public:
    TakeParser(std::span<const std::uint8_t> bytes, std::string source)
        : bytes_(bytes), source_(std::move(source)) {}

    Result<Take> parse() {
        if (bytes_.size() < kTakeHeaderBytes || std::memcmp(bytes_.data(), kTakeMagic.data(), 8) != 0) {
            return Status(StatusCode::ParseError,
                          source_ + ": found no take, expected one to begin with MUSTAKE");
        }
        version_ = wordAt(bytes_, 8);
        if (version_ < kOldestTakeVersion || version_ > kTakeVersion) {
            return Status(StatusCode::Unsupported, source_ + ": found a take of version " +
                                                       std::to_string(version_) + ", expected version " +
                                                       std::to_string(kOldestTakeVersion) + " to " +
                                                       std::to_string(kTakeVersion));
        }
        offset_ = kTakeHeaderBytes;
        while (offset_ < bytes_.size()) {
            bool torn = false;
            if (Status s = record(torn); !s.ok()) return s;
            if (torn) break;
        }
        take_.tornBytes = bytes_.size() - offset_;
        if (!haveScenario_) {
            return Status(StatusCode::ParseError,
                          source_ + ": found the end of the file, expected the whole scenario");
        }
        return std::move(take_);
    }

private:
    Status corrupt(const std::string& what) const {
        return {StatusCode::Corrupt,
                source_ + ": " + what + " in the record at offset " + std::to_string(offset_)};
    }

    /// Reads one record; sets `torn` where the file ends within it.
    Status record(bool& torn) {
        const std::size_t left = bytes_.size() - offset_;
        torn = left < kRecordHeadBytes;
        if (torn) return {};
        const auto head = bytes_.subspan(offset_, 5);
        if (crc32(head) != wordAt(bytes_, offset_ + 5)) return corrupt("found a damaged head");
        const std::uint32_t length = wordAt(bytes_, offset_);
        if (length > kMaxRecordBytes) return corrupt("found an impossible length");
        torn = left < kRecordHeadBytes + length + kRecordTailBytes;
        if (torn) return {};
        const auto payload = bytes_.subspan(offset_ + kRecordHeadBytes, length);
        if (crc32(payload) != wordAt(bytes_, offset_ + kRecordHeadBytes + length)) {
            return corrupt("found contents that do not match their checksum");
        }
        const auto kind = static_cast<RecordKind>(head[4]);
        if (take_.finished && kind != RecordKind::About) return corrupt("found more after the end");
        if (Status s = accept(kind, payload); !s.ok()) return s;
        offset_ += kRecordHeadBytes + length + kRecordTailBytes;
        return {};
    }

    Status accept(RecordKind kind, std::span<const std::uint8_t> payload) {
        if (haveScenario_ == (kind == RecordKind::Scenario))
            return corrupt("found the scenario out of its turn");
        switch (kind) {
            case RecordKind::Scenario:
                return scenario(payload);
            case RecordKind::Command:
                return command(payload);
            case RecordKind::Event:
                return event(payload);
            case RecordKind::About:
                return about(payload);
            case RecordKind::Frames:
                return frames(payload);
            case RecordKind::Mark:
            case RecordKind::End:
                take_.finished = kind == RecordKind::End;
                return mark(payload);
        }
        return {StatusCode::Unsupported, source_ + ": found a record of unknown kind " +
                                             std::to_string(static_cast<int>(kind)) + " at offset " +
                                             std::to_string(offset_)};
    }

    Status scenario(std::span<const std::uint8_t> payload) {
        take_.scenario.assign(payload.begin(), payload.end());
        auto def = parseScenario(take_.scenario, source_ + " (scenario)", {});
        if (!def.ok()) return def.status();
        take_.def = std::move(def).value();
        haveScenario_ = true;
        return {};
    }

    Status command(std::span<const std::uint8_t> payload) {
        Reader reader(payload, version_);
        auto command = decodeCommand(reader);
        if (!command.ok()) return corrupt(command.status().message());
        if (reader.remaining() > 0) return corrupt("found bytes too many");
        take_.commands.push_back(std::move(command).value());
        return {};
    }

    Status event(std::span<const std::uint8_t> payload) {
        Reader reader(payload);
        TakeEvent raised;
        reader(raised.step, raised.event);
        if (!reader.ok() || reader.remaining() > 0) return corrupt("found an event of the wrong size");
        if (!isOrderEvent(raised.event.kind)) return corrupt("found an event of unknown kind");
        if (!take_.events.empty() && raised.step < take_.events.back().step)
            return corrupt("found an earlier event");
        take_.events.push_back(raised);
        return {};
    }

    Status frames(std::span<const std::uint8_t> payload) {
        const Status read = unpackFrames(payload, take_.frames);
        return read.ok() ? read : corrupt(read.message());
    }

    Status about(std::span<const std::uint8_t> payload) {
        auto said = readTakeAbout({reinterpret_cast<const char*>(payload.data()), payload.size()},
                                  source_ + " (about)");
        if (!said.ok()) return corrupt(said.status().message());
        take_.about = std::move(said).value();
        return {};
    }

    Status mark(std::span<const std::uint8_t> payload) {
        Reader reader(payload);
        HashMark mark;
        reader(mark.step, mark.hash);
        if (!reader.ok() || reader.remaining() > 0) return corrupt("found a mark of the wrong size");
        if (!take_.marks.empty() && mark.step < take_.marks.back().step)
            return corrupt("found an earlier mark");
        mark.commands = static_cast<std::uint32_t>(take_.commands.size());
        take_.marks.push_back(mark);
        return {};
    }

    std::span<const std::uint8_t> bytes_;
    std::string source_;
    Take take_;
    std::size_t offset_ = 0;
    std::uint32_t version_ = 0;
    bool haveScenario_ = false;
};

}  // namespace

Result<Take> readTake(const std::string& path) {
    const auto text = readTextFile(path, kMaxTakeBytes);
    if (!text.ok()) return text.status();
    return parseTake({reinterpret_cast<const std::uint8_t*>(text->data()), text->size()}, path);
}

Result<Take> parseTake(std::span<const std::uint8_t> bytes, const std::string& sourceName) {
    return TakeParser(bytes, sourceName).parse();
}

}  // namespace muster
