#include "people/generator/clip_maker.h"

#include <algorithm>

namespace muster::generator {

Clip makeClip(ClipDef plan) {
    Clip clip;
    clip.name = std::move(plan.name);
    clip.motion = std::move(plan.motion);
    clip.rate = kFrameRate;
    clip.cyclic = plan.cyclic;
    clip.contacts = std::move(plan.contacts);
    clip.entryPhase = plan.entryPhase;
    clip.exitPhase = plan.exitPhase;
    clip.obstacle = plan.obstacle;
    const int poses = plan.frames + (plan.cyclic ? 0 : 1);
    for (int frame = 0; frame < poses; ++frame) clip.poses.push_back(poseOf(plan.figure(frame / kFrameRate)));
    for (int frame = 0; frame <= plan.frames; ++frame) {
        const Placement place = plan.travel(frame / kFrameRate);
        clip.travel.push_back(
            {static_cast<float>(place.x), static_cast<float>(place.y), static_cast<float>(place.yaw)});
    }
    std::stable_sort(clip.contacts.begin(), clip.contacts.end(),
                     [](const Contact& a, const Contact& b) { return a.begin < b.begin; });
    return clip;
}

void addContacts(std::vector<Contact>& contacts, std::size_t side, const std::vector<Step>& steps,
                 double duration, bool cyclic) {
    const Limb limb = side == 0 ? Limb::LeftFoot : Limb::RightFoot;
    for (const Step& step : steps) {
        if (cyclic) {
            if (step.begin > -1e-9 && step.begin < duration - 1e-9)
                contacts.push_back({limb, std::max(0.0, step.begin), step.end, step.anchor});
            continue;
        }
        const double begin = std::max(0.0, step.begin), end = std::min(duration, step.end);
        if (end > begin + 1e-6) contacts.push_back({limb, begin, end, step.anchor});
    }
}

}  // namespace muster::generator
