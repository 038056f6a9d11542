// Bytes as text.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace muster {

/// Base64 (RFC 4648) with its padding.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace muster
