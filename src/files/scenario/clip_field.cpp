#include "files/scenario/clip_field.h"

#include <algorithm>
#include <cmath>

#include "files/scenario/gestures_field.h"
#include "people/clips/motion_facts.h"
#include "people/clips/retarget.h"

namespace muster {
namespace {

constexpr double kGrain = 1e-6;  // Figures taken from files are rounded to this [m, s].

double rounded(double value) {
    return std::floor(value / kGrain + 0.5) * kGrain;
}

}  // namespace

void takeOwnFacts(ClipFacts& clip) {
    for (const ClipFacts& own : defaultClipFacts())
        if (own.name == clip.name) clip = own;
}

double runSpeed(const std::vector<ClipFacts>& clips) {
    if (clips.empty() || !(clips[0].length > 0.0 && clips[0].duration > 0.0)) return kUsualRun;
    return clips[0].length / clips[0].duration;
}

void readClipFile(FieldReader& v, ClipFacts& clip, const std::string& folder, double run) {
    if (v.failed() || clip.file.empty()) return;
    // The file is read even where the object gives all figures, because bodies move by it.
    if (!staysInside(clip.file)) return v.fail("file", describeJson(clip.file), kInsideExpected);
    const bool cyclicKnown = v.find("cyclic") != nullptr;
    if (v.find("speed") && v.find("length") && v.find("duration") && cyclicKnown) return;
    if (folder.empty()) {
        return v.fail("file", describeJson(clip.file),
                      "speed, length, duration and cyclic beside it, since files are not read here");
    }
    const auto motion = readBvh(folder + (folder.back() == '/' ? "" : "/") + clip.file);
    if (!motion.ok()) return v.fail("file", motion.status().message(), "a BVH file");
    const RootPath path = rootPath(*motion);
    clip.length = rounded(path.length);
    clip.duration = rounded(path.duration);
    if (!cyclicKnown) clip.cyclic = isCyclic(*motion);
    const double speed = clip.duration > 0.0 ? clip.length / clip.duration : 0.0;
    clip.speed = run > 0.0 ? std::clamp(speedRatio(speed, run), kLeastRatio, 100.0) : 1.0;
}

}  // namespace muster
