// The built page's files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace muster {

/// A file as it is served.
struct StaticFile {
    std::string type;   ///< MIME type.
    std::string cache;  ///< Cache-Control.
    std::string body;
};

/// The path part of a request target, "/" completed to "/index.html"; none for anything that is not a plain
/// absolute path: escapes, backslashes, parent folders, hidden names.
std::optional<std::string> plainPath(std::string_view target);
/// Reads a file of `folder`; none where it does not exist, is no plain file or lies (by a link) outside.
std::optional<StaticFile> readStaticFile(const std::string& folder, std::string_view target);

}  // namespace muster
