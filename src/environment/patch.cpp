#include "muster/environment/patch.h"

namespace muster {
namespace {

ClipFacts clip(const char* name, double speed, double metres, double seconds, bool cyclic, double transition) {
    ClipFacts facts;
    facts.name = name;
    facts.speed = speed;
    facts.length = metres;
    facts.duration = seconds;
    facts.cyclic = cyclic;
    facts.transitionTime = transition;
    return facts;
}

}  // namespace

std::vector<ClipFacts> defaultClipFacts() {
    // Lengths and durations agree with the speeds for running at 3.5 m/s.
    return {clip("run", 1.0, 2.45, 0.7, true, 0.0),   clip("walk", 0.4, 1.4, 1.0, true, 0.0),
            clip("duck", 0.4, 1.4, 1.0, true, 0.4),   clip("crawl", 0.2, 0.7, 1.0, true, 1.0),
            clip("swim", 0.3, 1.05, 1.0, true, 0.8),  clip("jump", 0.8, 2.1, 0.75, false, 0.0),
            clip("climb", 0.15, 1.05, 2.0, false, 0.0), clip("idle", 1.0, 0.0, 2.0, true, 0.0)};
}

}  // namespace muster
