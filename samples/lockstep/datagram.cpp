#include "datagram.h"

#include <string>

namespace lockstep {
namespace {

constexpr std::uint32_t kMagic = 0x314b4c4d;  // "MLK1"; its last digit is the version of the format.
constexpr std::size_t kCheckBytes = 8;

/// FNV-1a: tells bytes that were damaged or are of another program.
std::uint64_t checksum(ByteSpan bytes) {
    std::uint64_t sum = 0xcbf29ce484222325u;
    for (const std::uint8_t byte : bytes) sum = (sum ^ byte) * 0x100000001b3u;
    return sum;
}

Bytes encodeInput(const Input& input) {
    Bytes bytes;
    put(bytes, static_cast<std::uint8_t>(input.size()));
    for (const muster::Command& command : input) {
        const Bytes encoded = muster::encodeCommand(command);
        put(bytes, static_cast<std::uint16_t>(encoded.size()));
        put(bytes, encoded);
    }
    return bytes;
}

muster::Status damaged(const std::string& what) {
    return {muster::StatusCode::ParseError, "a datagram " + what};
}

muster::Status decodeInput(ByteReader& reader, std::uint32_t step, std::uint32_t player, Input& input) {
    const std::uint8_t count = reader.get<std::uint8_t>();
    for (std::uint8_t i = 0; i < count && reader.ok(); ++i) {
        const std::uint16_t size = reader.get<std::uint16_t>();
        muster::Result<muster::Command> command = muster::decodeCommand(reader.take(size));
        if (!command.ok()) return command.status().within("a datagram");
        if (command->step != step || command->client != player)
            return damaged("holds a command of another step or player");
        input.push_back(std::move(*command));
    }
    return reader.ok() ? muster::Status() : damaged("is cut short");
}

}  // namespace

std::size_t encodedSize(const Input& input) {
    return encodeInput(input).size();
}

Bytes encode(const Datagram& datagram) {
    Bytes bytes;
    put(bytes, kMagic);
    put(bytes, datagram.now);
    put(bytes, static_cast<std::uint32_t>(datagram.ahead));
    put(bytes, datagram.received);
    put(bytes, datagram.confirmed);
    put(bytes, datagram.firstHash);
    put(bytes, static_cast<std::uint8_t>(datagram.hashes.size()));
    for (const std::uint64_t hash : datagram.hashes) put(bytes, hash);
    put(bytes, datagram.firstInput);

    Bytes inputs;
    std::uint8_t count = 0;
    for (const Input& input : datagram.inputs) {
        const Bytes encoded = encodeInput(input);
        if (bytes.size() + 1 + inputs.size() + encoded.size() + kCheckBytes > kMostBytes) break;
        if (count == kMostInputs) break;
        put(inputs, encoded);
        ++count;
    }
    put(bytes, count);
    put(bytes, inputs);
    put(bytes, checksum(bytes));
    return bytes;
}

muster::Result<Datagram> decode(ByteSpan bytes, std::uint32_t player) {
    if (bytes.size() > kMostBytes) return damaged("is too long");
    if (bytes.size() < kCheckBytes) return damaged("is too short");
    const ByteSpan body = bytes.first(bytes.size() - kCheckBytes);
    if (ByteReader(bytes.last(kCheckBytes)).get<std::uint64_t>() != checksum(body))
        return damaged("has a wrong checksum");
    ByteReader reader(body);
    if (reader.get<std::uint32_t>() != kMagic) return damaged("is of another program or version");
    Datagram datagram;
    datagram.now = reader.get<std::uint32_t>();
    datagram.ahead = static_cast<std::int32_t>(reader.get<std::uint32_t>());
    datagram.received = reader.get<std::uint32_t>();
    datagram.confirmed = reader.get<std::uint32_t>();
    datagram.firstHash = reader.get<std::uint32_t>();
    datagram.hashes.resize(reader.get<std::uint8_t>());
    if (datagram.hashes.size() > kMostHashes) return damaged("holds too many hashes");
    for (std::uint64_t& hash : datagram.hashes) hash = reader.get<std::uint64_t>();
    datagram.firstInput = reader.get<std::uint32_t>();
    datagram.inputs.resize(reader.get<std::uint8_t>());
    if (datagram.inputs.size() > kMostInputs) return damaged("holds too many inputs");
    std::uint32_t step = datagram.firstInput;
    for (Input& input : datagram.inputs)
        if (muster::Status status = decodeInput(reader, step++, player, input); !status.ok()) return status;
    if (!reader.atEnd()) return damaged("has a wrong length");
    return datagram;
}

}  // namespace lockstep
