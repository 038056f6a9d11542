// Writes bodies to files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "muster/status.h"

namespace muster {

/// A body in the form of a file.
struct BodyFile {
    std::string name;   ///< For example "body-1.glb" or "body-1-far.glb".
    std::string bytes;  ///< Binary glTF.
};
/// The bytes of the body of that file name; nothing where there is none.
std::optional<std::string> bodyFile(std::string_view name);
/// All bodies at all levels of detail.
std::vector<BodyFile> bodyFiles();
/// Writes them into `folder`, which is created where it does not exist. Fails with IoError.
Status writeBodies(const std::string& folder);

}  // namespace muster
