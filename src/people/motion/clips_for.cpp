#include "people/motion/clips_for.h"

#include <algorithm>
#include <filesystem>

#include "muster/clip.h"
#include "muster/own_clips.h"
#include "people/clips/retarget.h"

namespace muster {
namespace {

Result<Clip> clipOf(const ClipFacts& fact, const std::string& folder, const Clip* own) {
    const auto file = readBvh((std::filesystem::path(folder) / fact.file).string());
    if (!file.ok()) return file.status();
    RetargetOptions options;
    options.name = fact.name;
    options.motion = own != nullptr ? own->motion : fact.name;
    options.cyclic = fact.cyclic;
    auto clip = retarget(*file, options);
    if (clip.ok() && own != nullptr) clip->set = own->set;
    return clip;
}

}  // namespace

bool namesClipFiles(std::span<const ClipFacts> facts) {
    return std::any_of(facts.begin(), facts.end(), [](const ClipFacts& fact) { return !fact.file.empty(); });
}

Result<ClipLibrary> clipsFor(std::span<const ClipFacts> facts, const std::string& folder) {
    ClipLibrary library = ownClips();
    for (const ClipFacts& fact : facts) {
        if (fact.file.empty()) continue;
        const std::int32_t own = library.indexOf(fact.name);
        auto clip = clipOf(fact, folder, own < 0 ? nullptr : &library.clips[own]);
        if (!clip.ok()) return clip.status().within("motion \"" + fact.name + "\"");
        if (own >= 0) {
            library.clips[own] = std::move(clip).value();
        } else {
            library.clips.push_back(std::move(clip).value());
        }
    }
    return library;
}

}  // namespace muster
