// Estimates the axes and the unit of length of a BVH file from the body in it.
#pragma once

#include <span>

#include "muster/clip.h"

namespace muster {

/// A rotation of axes by quarter turns. Its rows are Muster's forward, left and up in the file's axes.
struct AxisMap {
    Vec3 forward, left, up;

    Vec3 apply(Vec3 p) const { return {dot(forward, p), dot(left, p), dot(up, p)}; }
    Quat apply(Quat q) const {
        const Vec3 v = apply(Vec3{q.x, q.y, q.z});
        return {v.x, v.y, v.z, q.w};
    }
};

/// Estimates the axes from the rest pose, or from `frame` if the rest pose does not stand. Y up and facing +Z
/// is the default.
AxisMap guessAxes(std::span<const BvhJoint> joints, std::span<const Transform> frame);

/// Length of one unit [m], estimated from the largest extent of the rest pose: metres, centimetres,
/// millimetres, inches, feet or the unit of CMU's recordings (1 inch is 0.45 units). Fails with Unsupported
/// if none gives a plausible body.
Result<double> guessUnit(std::span<const BvhJoint> joints);

}  // namespace muster
