// Clips between running and what is done with hands: crawling, swimming.
#pragma once

#include <vector>

#include "muster/clip.h"

namespace muster::generator {

/// "crawl-enter" and "crawl-exit".
void addCrawlPassages(std::vector<Clip>& clips);
/// "swim-enter" and "swim-exit".
void addSwimPassages(std::vector<Clip>& clips);

}  // namespace muster::generator
