#include "studio/session/inbox/protocol.h"

#include <array>
#include <string>
#include <utility>

namespace muster::protocol {
namespace {

template <class Any, class Message>
Result<Any> decodeAs(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes.subspan(1));
    Message message;
    reader(message);
    const std::string name = messageName(Any(Message{}));
    if (!reader.ok()) return Status(StatusCode::ParseError, name + ": short or invalid bytes");
    if (reader.remaining() > 0)
        return Status(StatusCode::ParseError,
                      name + ": " + std::to_string(reader.remaining()) + " bytes too many");
    return Any(std::move(message));
}

/// Reads the message whose number is the first byte.
template <class Any, std::size_t... Number>
Result<Any> decodeAny(std::span<const std::uint8_t> bytes, std::index_sequence<Number...>) {
    using Decoder = Result<Any> (*)(std::span<const std::uint8_t>);
    static constexpr std::array<Decoder, sizeof...(Number)> kDecoders{
        decodeAs<Any, std::variant_alternative_t<Number, Any>>...};
    if (bytes.empty()) return Status(StatusCode::ParseError, "An empty message");
    if (bytes[0] >= kDecoders.size())
        return Status(StatusCode::ParseError, "Message number " + std::to_string(bytes[0]) +
                                                  " is unknown, expected 0 to " +
                                                  std::to_string(kDecoders.size() - 1));
    return kDecoders[bytes[0]](bytes);
}

template <class Any>
Result<Any> decodeAny(std::span<const std::uint8_t> bytes) {
    return decodeAny<Any>(bytes, std::make_index_sequence<std::variant_size_v<Any>>());
}

}  // namespace

Result<ClientMessage> decodeClient(std::span<const std::uint8_t> bytes) {
    return decodeAny<ClientMessage>(bytes);
}

Result<ServerMessage> decodeServer(std::span<const std::uint8_t> bytes) {
    return decodeAny<ServerMessage>(bytes);
}

}  // namespace muster::protocol
