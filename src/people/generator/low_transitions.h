// Transition clips between running and motions that use the hands: crawling and swimming.
#pragma once

#include <vector>

#include "muster/clip.h"
#include "people/generator/leg_track.h"

namespace muster::generator {

/// The same step moved to `begin` [s], outside the clip, for a leg that comes from or goes to another motion
/// than a step.
Step stepOutside(Step step, double begin);

/// Adds "crawl-enter" and "crawl-exit".
void addCrawlTransitions(std::vector<Clip>& clips);
/// Adds "swim-enter" and "swim-exit".
void addSwimTransitions(std::vector<Clip>& clips);

}  // namespace muster::generator
