// Checks of several options together.
#pragma once

#include <string>
#include <vector>

#include "muster/status.h"

namespace muster {

/// Fails where a file to be written is one of those read, or is named twice. Empty names are left out.
Status differentFiles(const std::vector<std::string>& read, const std::vector<std::string>& written);

}  // namespace muster
