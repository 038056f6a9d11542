// Edits of people in a take: their checks, and as JSON in what is said about the take (docs/take-format.md).
#pragma once

#include <string>
#include <vector>

#include "muster/take.h"

namespace muster {

class Json;

/// Least time between two pins, and between two points of a clock [s].
inline constexpr double kLeastPinGap = 0.1;
/// How fast an own clock may run between two of its points.
inline constexpr double kFastestClock = 8.0;
/// How slowly it may run at its first and last piece, so that its speed does not jump there.
inline constexpr double kSlowestEnd = 1.0 / 3.0;

/// Fails with InvalidArgument, naming the value, where the edits are not as described.
Status checkEdits(const std::vector<TakeEdit>& edits);
/// Fails with InvalidArgument where an edit names a clip that is not among these names, which it tells.
Status checkClips(const std::vector<TakeEdit>& edits, const std::vector<std::string>& names);
/// The edits as an array.
Json describeEdits(const std::vector<TakeEdit>& edits);
/// Reads them back. Unknown keys are ignored. Fails with ParseError.
Status readEdits(const Json& list, std::vector<TakeEdit>& edits);

}  // namespace muster
