// Files of recordings.
#pragma once

#include <memory>
#include <string>

#include "muster/session.h"

namespace muster {

/// Creates `folder`/NAME-DATE-TIME.take and the folder; never overwrites a file. Fails with IoError.
Result<std::unique_ptr<TakeSink>> openTakeFile(const std::string& folder, const std::string& name);

}  // namespace muster
