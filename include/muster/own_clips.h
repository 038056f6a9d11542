// Muster's own motion clips, which are generated at run time.
#pragma once

#include "muster/clip.h"

namespace muster {

/// All of Muster's own clips, made once at the first call (a tenth of a second): idle, walk, jog, run, turns,
/// starts, stops, duck, crawl, swim, jump, climb, and the transitions into and out of duck, crawl and swim.
const ClipLibrary& ownClips();

}  // namespace muster
