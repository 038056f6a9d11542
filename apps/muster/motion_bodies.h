// Bodies as files.
#pragma once

#include <string>
#include <vector>

#include "muster/status.h"

namespace muster {

/// A body as a file.
struct BodyFile {
    std::string name;   ///< "body-1.glb", "body-1-far.glb"...
    std::string bytes;  ///< Binary glTF.
};
/// All bodies at all levels.
std::vector<BodyFile> bodyFiles();
/// Writes them into `folder`, which is made where there is none. Fails with IoError.
Status writeBodies(const std::string& folder);

}  // namespace muster
