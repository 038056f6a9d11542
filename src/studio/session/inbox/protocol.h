// Messages between the studio's page and its server, as bytes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.h"
#include "muster/status.h"
#include "studio/session/inbox/generated/protocol_client.h"
#include "studio/session/inbox/generated/protocol_server.h"

namespace muster::protocol {

/// "Touches"... for reports.
const char* messageName(const ClientMessage& message);
/// "Frame"... for reports.
const char* messageName(const ServerMessage& message);

/// Reads a message. Fails with ParseError where the number is unknown, the bytes are short or too many, or a
/// flag or enumeration has no such value.
Result<ClientMessage> decodeClient(std::span<const std::uint8_t> bytes);
/// As decodeClient.
Result<ServerMessage> decodeServer(std::span<const std::uint8_t> bytes);

/// Appends a message's bytes.
template <class Message>
void encode(Writer& writer, const Message& message) {
    const std::uint8_t number = Message::kNumber;
    writer(number, message);
}
/// A message's bytes.
template <class Message>
std::vector<std::uint8_t> encode(const Message& message) {
    Writer writer;
    encode(writer, message);
    return writer.take();
}

}  // namespace muster::protocol
