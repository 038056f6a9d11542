#include "muster/own_clips.h"

#include "people/generator/crawl.h"
#include "people/generator/gait.h"
#include "people/generator/other_clips.h"
#include "people/generator/transitions.h"

namespace muster {
namespace {

using namespace generator;

void addGaits(std::vector<Clip>& clips) {
    clips.push_back(gaitClip("walk", "run", gaitOf(GaitKind::Walk)));
    clips.push_back(gaitClip("jog", "run", gaitOf(GaitKind::Jog)));
    clips.push_back(gaitClip("run", "run", gaitOf(GaitKind::Run)));
    clips.push_back(gaitClip("sprint", "run", gaitOf(GaitKind::Sprint)));
    clips.push_back(gaitClip("duck", "duck", gaitOf(GaitKind::Duck)));
    clips.push_back(gaitClip("walk-left", "run", bent(gaitOf(GaitKind::Walk), 2.0)));
    clips.push_back(gaitClip("walk-right", "run", bent(gaitOf(GaitKind::Walk), -2.0)));
    clips.push_back(gaitClip("jog-left", "run", bent(gaitOf(GaitKind::Jog), 2.5)));
    clips.push_back(gaitClip("jog-right", "run", bent(gaitOf(GaitKind::Jog), -2.5)));
    clips.push_back(gaitClip("run-left", "run", bent(gaitOf(GaitKind::Run), 3.0)));
    clips.push_back(gaitClip("run-right", "run", bent(gaitOf(GaitKind::Run), -3.0)));
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
