#include "people/motion/two_bone.h"

#include <algorithm>

#include "base/maths.h"

namespace muster {

float softReach(float distance, float reach) {
    const float soft = kSoftReach * reach, rest = 0.9998f * reach - soft;
    if (distance <= soft) return distance;
    // x / (1 + x) approximates 1 - exp(-x): it has slope 1 at 0 and limit 1.
    const float x = (distance - soft) / rest;
    return soft + rest * (x / (1.0f + x));
}

TwoBoneRotation reach(const TwoBones& limb, Vec3 target, Vec3 pole) {
    const Vec3 toTarget = target - limb.root;
    const float far = length(toTarget);
    const Vec3 along = far > 1e-6f ? toTarget * (1.0f / far) : Vec3{0.0f, 0.0f, -1.0f};
    const float nearest = std::fabs(limb.upper - limb.lower) + 0.02f * (limb.upper + limb.lower);
    const float d = softReach(std::max(far, nearest), limb.upper + limb.lower);
    Vec3 side = pole - along * dot(pole, along);
    const float sideLength = length(side);
    if (sideLength > 1e-4f) {
        side *= 1.0f / sideLength;
    } else {
        side = normalized(
            cross(std::fabs(along.x) < 0.9f ? Vec3{1.0f, 0.0f, 0.0f} : Vec3{0.0f, 1.0f, 0.0f}, along));
    }
    // Law of cosines at the root.
    const float cosine = (limb.upper * limb.upper + d * d - limb.lower * limb.lower) /
                         (2.0f * limb.upper * d);
    const float c = std::clamp(cosine, -1.0f, 1.0f);
    const float s = std::sqrt(std::max(0.0f, 1.0f - c * c));
    const Vec3 upperNow = along * c + side * s;
    const Vec3 end = limb.root + along * d;
    const Vec3 middle = limb.root + upperNow * limb.upper;
    TwoBoneRotation turn;
    turn.upper = shortestArc((limb.middle - limb.root) * (1.0f / limb.upper), upperNow);
    const Vec3 carried = rotate(turn.upper, (limb.end - limb.middle) * (1.0f / limb.lower));
    turn.lower = shortestArc(carried, (end - middle) * (1.0f / limb.lower)) * turn.upper;
    turn.end = end;
    return turn;
}

float middleCosine(const TwoBones& limb, float distance) {
    const float cosine = (limb.upper * limb.upper + limb.lower * limb.lower - distance * distance) /
                         (2.0f * limb.upper * limb.lower);
    return std::clamp(cosine, -1.0f, 1.0f);
}

Vec3 pacedTarget(const TwoBones& limb, Vec3 target, float before, float most) {
    const Vec3 toTarget = target - limb.root;
    const float far = length(toTarget);
    if (far < 1e-6f) return target;
    // Sine and cosine of a small angle by Taylor series.
    const float q = most * most;
    const float s = most * (1.0f - q / 6.0f * (1.0f - q / 20.0f)), c = 1.0f - q / 2.0f * (1.0f - q / 12.0f);
    const float sineBefore = std::sqrt(std::max(0.0f, 1.0f - before * before));
    const float straighter = before < -c ? -1.0f : before * c - sineBefore * s;
    const float closer = before > c ? 1.0f : before * c + sineBefore * s;
    const float wanted = middleCosine(limb, far), paced = std::clamp(wanted, straighter, closer);
    if (paced == wanted) return target;
    const float distance = std::sqrt(std::max(
        0.0f, limb.upper * limb.upper + limb.lower * limb.lower - 2.0f * limb.upper * limb.lower * paced));
    return limb.root + toTarget * (distance / far);
}

}  // namespace muster
