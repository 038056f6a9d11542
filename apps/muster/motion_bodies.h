// Bodies as files.
#pragma once

#include <string>

#include "muster/base/status.h"

namespace muster {

/// Writes body-1.glb, body-1-far.glb, body-2.glb and body-2-far.glb into `folder`, which is made where there is none.
/// Fails with IoError.
Status writeBodies(const std::string& folder);

}  // namespace muster
