// Checks that concern several options.
#pragma once

#include <string>
#include <vector>

#include "muster/status.h"

namespace muster {

/// Fails where a file would be both read and written, or written twice. Empty names are ignored.
Status differentFiles(const std::vector<std::string>& read, const std::vector<std::string>& written);

}  // namespace muster
