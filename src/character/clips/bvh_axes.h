// Which way a file's axes point and how long its unit is, judged by the body.
#pragma once

#include <span>

#include "muster/clip.h"

namespace muster {

/// A turn of axes by quarter turns: rows are our forward, left and up in the file's axes.
struct AxisMap {
    Vec3 forward, left, up;

    Vec3 apply(Vec3 p) const { return {dot(forward, p), dot(left, p), dot(up, p)}; }
    Quat apply(Quat q) const {
        const Vec3 v = apply(Vec3{q.x, q.y, q.z});
        return {v.x, v.y, v.z, q.w};
    }
};

/// Judges by the rest pose, or by `frame` where nobody stands in the rest pose; Y up and facing +Z where in
/// doubt.
AxisMap guessAxes(std::span<const BvhJoint> joints, std::span<const Transform> frame);

/// One unit [m] by the largest extent of the rest pose: metres, centimetres, millimetres, inches, feet or
/// those of CMU's recordings (0.45 of them to the inch). Fails with Unsupported where no body is that large.
Result<double> guessUnit(std::span<const BvhJoint> joints);

}  // namespace muster
