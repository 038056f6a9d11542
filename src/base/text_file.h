// Reading and writing of whole files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "muster/status.h"

namespace muster {

inline constexpr std::size_t kMaxTextBytes = 64u << 20;  ///< Default limit of readTextFile().

/// Reads a whole file. Fails with IoError, or LimitExceeded beyond `limit` bytes.
Result<std::string> readTextFile(const std::string& path, std::size_t limit = kMaxTextBytes);
/// Creates or replaces a file. Fails with IoError.
Status writeTextFile(const std::string& path, std::string_view text);

}  // namespace muster
