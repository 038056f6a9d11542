#include "engine/state/world_archive.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "base/archive.h"
#include "base/hash.h"

namespace muster {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic{'M', 'U', 'S', 'T', 'S', 'N', 'A', 'P'};
// With these bytes the snapshots of version 2 began, which named no version.
constexpr std::array<std::uint8_t, 4> kMagicOfVersion2{'2', 'P', 'S', 'M'};

/// Hash of the bytes, eight at a time.
std::uint64_t checksumOf(std::span<const std::uint8_t> bytes) {
    Hash hash;
    std::size_t at = 0;
    for (; at + 8 <= bytes.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + at, 8);
        hash.addWord(word);
    }
    for (; at < bytes.size(); ++at) hash.add(bytes[at]);
    return hash.value();
}

bool beginsWith(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> magic) {
    return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin());
}

Status otherVersion(std::uint32_t version) {
    return {StatusCode::Unsupported, "snapshot: found version " + std::to_string(version) +
                                         ", expected version " + std::to_string(kSnapshotVersion) +
                                         ", which this Muster writes"};
}

}  // namespace

void sealSnapshot(std::vector<std::uint8_t>& bytes) {
    const auto state = std::span(bytes).subspan(kSnapshotHeadBytes);
    std::uint32_t version = kSnapshotVersion;
    std::uint64_t length = state.size(), checksum = checksumOf(state);
    Writer head;
    for (std::uint8_t byte : kMagic) head(byte);
    head(version, length, checksum);
    const std::vector<std::uint8_t> written = head.take();
    std::copy(written.begin(), written.end(), bytes.begin());
}

Result<std::span<const std::uint8_t>> openSnapshot(std::span<const std::uint8_t> bytes) {
    if (beginsWith(bytes, kMagicOfVersion2)) return otherVersion(2);
    if (!beginsWith(bytes, kMagic))
        return Status(StatusCode::ParseError,
                      "snapshot: found another kind of data, expected a world's snapshot");
    if (bytes.size() < kSnapshotHeadBytes)
        return Status(StatusCode::ParseError, "snapshot: found " + std::to_string(bytes.size()) +
                                                  " bytes, expected a whole head of " +
                                                  std::to_string(kSnapshotHeadBytes));
    Reader reader(bytes.subspan(kMagic.size()));
    std::uint32_t version = 0;
    std::uint64_t length = 0, checksum = 0;
    reader(version, length, checksum);
    if (version != kSnapshotVersion) return otherVersion(version);
    const auto state = bytes.subspan(kSnapshotHeadBytes);
    if (length != state.size())
        return Status(StatusCode::ParseError, "snapshot: found " + std::to_string(state.size()) +
                                                  " bytes of state, expected " + std::to_string(length));
    if (checksum != checksumOf(state))
        return Status(
            StatusCode::ParseError,
            "snapshot: found bytes that do not match their checksum, expected them as they were saved");
    return state;
}

}  // namespace muster
