// The same scenes by other programs, and recorded figures of them.
#pragma once

#include <string>

#include "lab/verify/verify.h"

namespace muster {

/// A table of scenes that a verification has run, beside JuPedSim where `python3` finds its package, and
/// beside recorded figures that can be cited.
std::string besideOthers(const Verification& verification);

}  // namespace muster
