// Recordings on disk.
#pragma once

#include <memory>
#include <string>

#include "muster/session.h"

namespace muster {

/// Begins `folder`/NAME-DATE-TIME.take, making the folder; never overwrites. Fails with IoError.
Result<std::unique_ptr<TakeSink>> openTakeFile(const std::string& folder, const std::string& name);

}  // namespace muster
