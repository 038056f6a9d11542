// Clips between running and what is done with hands: crawling, swimming.
#pragma once

#include <vector>

#include "character/generator/leg_track.h"
#include "muster/clip.h"

namespace muster::generator {

/// The same step moved to `begin` [s], outside the clip: for a leg that comes from or goes to something that
/// is no step.
Step stepOutside(Step step, double begin);

/// "crawl-enter" and "crawl-exit".
void addCrawlTransitions(std::vector<Clip>& clips);
/// "swim-enter" and "swim-exit".
void addSwimTransitions(std::vector<Clip>& clips);

}  // namespace muster::generator
