// ZIP archives of files that are stored as they are.
#pragma once

#include <string>

#include "muster/status.h"

namespace muster {

/// Writes `path` as a ZIP archive of the files directly in `folder`, in the order of their names, none of
/// them compressed. Nothing is left behind where it fails. Fails with IoError, or with LimitExceeded beyond
/// 65,000 files or 4 GB.
Status zipFolder(const std::string& folder, const std::string& path);

}  // namespace muster
