// How edits of one gesture become one step of a history.
#pragma once

#include <vector>

#include "studio/session/history/place_edit.h"

namespace muster {

/// True where the edit that waits need not be carried out, because the later one does the same to the same
/// things.
bool overtakes(const std::vector<PlaceChange>& later, const std::vector<PlaceChange>& waiting);
/// Puts the changes of a later edit into the step, so that both are taken back together. What is as it was
/// before the step is left out.
void join(PlaceStep& step, std::vector<PlaceChange> later);

}  // namespace muster
