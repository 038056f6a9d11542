// Checks of options that CLI11 has none for.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "muster/status.h"

namespace muster {

/// A number from `low` to `high`; unlike CLI::Range it lets no "nan" pass.
CLI::Validator numberIn(double low, double high);

/// Fails where a file to be written is one of those read, or is named twice. Empty names are left out.
Status differentFiles(const std::vector<std::string>& read, const std::vector<std::string>& written);

}  // namespace muster
