// What is said about a take, as text (docs/take-format.md).
#pragma once

#include <span>
#include <string>

#include "muster/take.h"

namespace muster {

/// The JSON text of an about record.
std::string writeTakeAbout(const TakeAbout& about);
/// Reads one back. Unknown keys are ignored, so that later versions may add some. Fails with ParseError, or
/// as TakeAbout::check() does.
Result<TakeAbout> readTakeAbout(std::string_view text, const std::string& sourceName);

}  // namespace muster
