// Draws clips as pictures.
#pragma once

#include <string>
#include <vector>

#include "muster/clip.h"
#include "muster/status.h"

namespace muster {

/// Draws each clip as a strip of poses into `folder`/NAME.svg. The folder is created where it does not exist.
/// Fails with IoError.
Status writeStrips(const std::vector<Clip>& clips, const std::string& folder);

}  // namespace muster
