#include "studio/session/takes/handover.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "base/archive.h"

namespace muster {
namespace {

constexpr std::array<std::uint8_t, 8> kHandoverMagic{'M', 'U', 'S', 'T', 'H', 'A', 'N', 'D'};
constexpr std::uint32_t kHandoverVersion = 1;

/// The first 32 bytes, which pages read, too.
struct HandoverHead {
    std::array<std::uint8_t, 8> magic = kHandoverMagic;
    std::uint32_t version = kHandoverVersion;
    std::uint32_t world = 0;
    std::uint64_t takeFrom = 0;
    std::uint32_t takeBytes = 0;
    std::uint32_t restBytes = 0;

    static constexpr std::size_t kBytes = 32;

    template <class Archive>
    void visit(Archive& archive) {
        archive(magic, version, world, takeFrom, takeBytes, restBytes);
    }
};

template <class Archive, class HandoverType>
void visitRest(Archive& archive, HandoverType& handover) {
    archive(handover.name, handover.place, handover.open, handover.complete, handover.playing, handover.speed,
            handover.step, handover.recording, handover.recordedFrom, handover.snapshot);
}

Status damaged(const std::string& what) {
    return {StatusCode::ParseError, "the handover of a world: " + what};
}

}  // namespace

std::vector<std::uint8_t> Handover::bytes() const {
    Writer rest;
    visitRest(rest, *this);
    HandoverHead head;
    head.world = world;
    head.takeFrom = takeFrom;
    head.takeBytes = static_cast<std::uint32_t>(take.size());
    head.restBytes = static_cast<std::uint32_t>(rest.bytes().size());
    Writer first;
    first(head);
    std::vector<std::uint8_t> all = first.take();
    all.insert(all.end(), take.begin(), take.end());
    all.insert(all.end(), rest.bytes().begin(), rest.bytes().end());
    return all;
}

Result<Handover> Handover::parse(std::span<const std::uint8_t> bytes) {
    HandoverHead head;
    Reader first(bytes.first(std::min(bytes.size(), HandoverHead::kBytes)));
    first(head);
    if (!first.ok() || head.magic != kHandoverMagic) return damaged("found other bytes");
    if (head.version != kHandoverVersion)
        return Status(StatusCode::Unsupported, "the handover of a world: found version " +
                                                   std::to_string(head.version) + ", expected " +
                                                   std::to_string(kHandoverVersion));
    const std::span<const std::uint8_t> body = bytes.subspan(HandoverHead::kBytes);
    if (body.size() != std::size_t{head.takeBytes} + head.restBytes)
        return damaged("found " + std::to_string(body.size()) + " bytes, expected " +
                       std::to_string(std::size_t{head.takeBytes} + head.restBytes));
    Handover handover;
    handover.world = head.world;
    handover.takeFrom = head.takeFrom;
    handover.take.assign(body.begin(), body.begin() + head.takeBytes);
    Reader rest(body.subspan(head.takeBytes));
    visitRest(rest, handover);
    if (!rest.ok() || rest.remaining() > 0) return damaged("its end cannot be read");
    if (!(handover.speed > 0.0 && handover.speed <= 100.0)) return damaged("its speed is out of range");
    return handover;
}

}  // namespace muster
