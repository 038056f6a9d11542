#include "muster/ground.h"

namespace muster {
namespace {

ClipFacts clip(const char* name, double speed, double metres, double seconds, bool cyclic, double transition,
               double ahead = 0.0, double behind = 0.0) {
    ClipFacts facts;
    facts.name = name;
    facts.speed = speed;
    facts.length = metres;
    facts.duration = seconds;
    facts.cyclic = cyclic;
    facts.transitionTime = transition;
    facts.reachAhead = ahead;
    facts.reachBehind = behind;
    return facts;
}

}  // namespace

std::vector<ClipFacts> defaultClipFacts() {
    // Lengths, durations and the speed of walking are those of Muster's own clips, which run at 2.6 m/s. A
    // patch with the clip "idle" does not stop characters for ever, so it has a small speed.
    // Reaches are those of hips and head in these clips.
    return {clip("run", 1.0, 1.95, 0.75, true, 0.0),
            clip("walk", 0.48, 1.333, 1.067, true, 0.0),
            clip("duck", 0.4, 0.936, 0.9, true, 0.4, 0.42, 0.11),
            clip("crawl", 0.2, 0.555, 1.067, true, 1.0, 0.42, 0.26),
            clip("swim", 0.3, 1.248, 1.6, true, 0.8, 0.52, 0.18),
            clip("jump", 0.8, 2.1, 1.01, false, 0.0),
            clip("climb", 0.15, 1.2, 3.08, false, 0.0, 0.5, 0.0),
            clip("idle", 0.02, 0.0, 4.0, true, 0.0)};
}

}  // namespace muster
