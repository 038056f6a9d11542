// The files of the built page.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace muster {

/// A file with its HTTP properties.
struct StaticFile {
    std::string type;   ///< MIME type.
    std::string cache;  ///< Value of Cache-Control.
    std::string body;
};

/// Cache-Control of files whose address changes with their contents.
inline constexpr const char* kKeptForever = "public, max-age=31536000, immutable";

/// The MIME type of a file by the ending of its name.
std::string typeOfFile(const std::string& path);
/// The path of a request target; "/" becomes "/index.html". Nothing for targets other than plain absolute
/// paths, that is with escapes, backslashes, parent folders or hidden names.
std::optional<std::string> plainPath(std::string_view target);
/// Reads a file of `folder`; nothing where it does not exist, is no regular file or lies outside through a
/// link.
std::optional<StaticFile> readStaticFile(const std::string& folder, std::string_view target);

}  // namespace muster
