#include "muster/own_clips.h"

#include "people/generator/crawl.h"
#include "people/generator/gait.h"
#include "people/generator/other_clips.h"
#include "people/generator/transitions.h"

namespace muster {
namespace {

using namespace generator;

void addGaits(std::vector<Clip>& clips) {
    clips.push_back(gaitClip("walk", "run", walkGait()));
    clips.push_back(gaitClip("jog", "run", jogGait()));
    clips.push_back(gaitClip("run", "run", runGait()));
    clips.push_back(gaitClip("sprint", "run", sprintGait()));
    clips.push_back(gaitClip("duck", "duck", duckGait()));
    clips.push_back(gaitClip("walk-left", "run", bent(walkGait(), 2.0)));
    clips.push_back(gaitClip("walk-right", "run", bent(walkGait(), -2.0)));
    clips.push_back(gaitClip("jog-left", "run", bent(jogGait(), 2.5)));
    clips.push_back(gaitClip("jog-right", "run", bent(jogGait(), -2.5)));
    clips.push_back(gaitClip("run-left", "run", bent(runGait(), 3.0)));
    clips.push_back(gaitClip("run-right", "run", bent(runGait(), -3.0)));
}

ClipLibrary makeAll() {
    ClipLibrary library;
    library.clips.push_back(idleClip());
    addGaits(library.clips);
    addTransitions(library.clips);
    library.clips.push_back(crawlClip());
    addCrawlTransitions(library.clips);
    library.clips.push_back(swimClip());
    addSwimTransitions(library.clips);
    addJumps(library.clips);
    library.clips.push_back(climbClip());
    addMotionSets(library.clips);
    return library;
}

}  // namespace

const ClipLibrary& ownClips() {
    static const ClipLibrary kLibrary = makeAll();
    return kLibrary;
}

}  // namespace muster
