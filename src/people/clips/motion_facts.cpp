#include "people/clips/motion_facts.h"

#include <algorithm>
#include <cmath>

#include "people/clips/retarget.h"

namespace muster {
namespace {

constexpr float kLeastMotion = 1e-6f;  // Difference of positions up to which a joint does not move [m].

/// Global position of a joint in a frame.
Vec3 positionOf(const BvhMotion& motion, std::size_t joint, std::size_t frame) {
    const auto local = motion.frame(frame);
    Vec3 position = local[joint].translation;
    for (std::int32_t up = motion.joints[joint].parent; up >= 0; up = motion.joints[up].parent)
        position = local[up].apply(position);
    return position;
}

/// The first joint whose position channels move it; else the first joint.
std::size_t rootOf(const BvhMotion& motion) {
    if (isOwnSkeleton(motion)) return 0;
    for (std::size_t j = 0; j < motion.joints.size(); ++j) {
        if (!motion.joints[j].moves) continue;
        for (std::size_t f = 1; f < motion.frames; ++f)
            if (distance(motion.frame(f)[j].translation, motion.frame(0)[j].translation) > kLeastMotion)
                return j;
    }
    return 0;
}

}  // namespace

RootPath rootPath(const BvhMotion& motion) {
    const std::size_t root = rootOf(motion);
    const Vec3 displacement = positionOf(motion, root, motion.frames - 1) - positionOf(motion, root, 0);
    RootPath path;
    path.length = std::sqrt(static_cast<double>(displacement.x) * displacement.x +
                            static_cast<double>(displacement.y) * displacement.y);
    path.duration = motion.duration();
    return path;
}

MotionFacts factsOf(const Clip& clip) {
    MotionFacts facts;
    facts.frames = clip.poses.size() + (clip.cyclic ? 1 : 0);
    facts.rate = clip.rate;
    facts.duration = clip.duration();
    facts.length = clip.length();
    facts.speed = clip.speed();
    facts.cyclic = clip.cyclic;
    facts.contacts = clip.contacts;
    return facts;
}

MotionFacts factsOf(const BvhMotion& motion) {
    MotionFacts facts;
    const auto clip = retarget(motion);
    if (clip.ok()) facts = factsOf(*clip);
    const RootPath path = rootPath(motion);
    facts.frames = motion.frames;
    facts.rate = motion.rate;
    facts.duration = path.duration;
    facts.length = path.length;
    facts.speed = path.duration > 0.0 ? path.length / path.duration : 0.0;
    return facts;
}

double speedRatio(double speed, double runSpeed) {
    return std::max(kLeastRatio, runSpeed > 0.0 ? speed / runSpeed : 0.0);
}

}  // namespace muster
