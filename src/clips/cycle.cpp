#include <array>
#include <cmath>
#include <vector>

#include "clips/forward.h"
#include "clips/hips_path.h"
#include "muster/clips/retarget.h"

namespace muster {
namespace {

constexpr double kCloseGap = 0.55;   // Of the way limbs swing: so far may the last frame be from the first.
constexpr double kSeamMotion = 0.6;  // Of the mean speed of limbs: so fast must they be at the ends.

/// Where limbs are about the hips in one frame, turned by where the motion faces there [m].
std::vector<Vec3> shapeOf(const BvhMotion& motion, std::size_t frame, const RoleJoints& roles,
                          double facing) {
    std::vector<Transform> joints;
    globalTransforms(motion, frame, joints);
    std::vector<Vec3> shape;
    const auto hips = static_cast<std::size_t>(roles[0]);
    const Quat back = yawTurn(-facing);
    for (const std::int32_t joint : roles) {
        if (joint < 0) continue;
        const Vec3 p = joints[static_cast<std::size_t>(joint)].translation, h = joints[hips].translation;
        shape.push_back(rotate(back, p - Vec3{h.x, h.y, 0.0f}));
    }
    return shape;
}

/// Root of the mean squared distance [m].
double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(lengthSquared(a[i] - b[i]));
    return std::sqrt(sum / static_cast<double>(a.size()));
}

}  // namespace

bool isCyclic(const BvhMotion& motion) {
    const RoleJoints roles = findRoles(motion.joints);
    if (motion.frames < 6 || !hasBody(roles).ok()) return false;
    std::vector<HipsAt> facing;
    std::vector<Transform> joints;
    for (const std::size_t f : {std::size_t{0}, motion.frames - 1}) {
        globalTransforms(motion, f, joints);
        facing.push_back({0.0, 0.0, facingOf(joints[static_cast<std::size_t>(roles[0])].rotation)});
    }
    const double turn = facing[1].facing - facing[0].facing;
    std::vector<std::vector<Vec3>> shapes;
    for (std::size_t f = 0; f < motion.frames; ++f) shapes.push_back(shapeOf(motion, f, roles, 0.0));
    // A cycle may turn, but a small turn belongs to the sway of the hips.
    const bool turns = std::fabs(sine(0.5 * turn)) > 0.17;
    const std::vector<Vec3> last = shapeOf(motion, motion.frames - 1, roles, turns ? turn : 0.0);
    std::vector<Vec3> mean(last.size());
    for (const auto& shape : shapes)
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] += shape[i] * (1.0f / static_cast<float>(shapes.size()));
    double swing = 0.0, speed = 0.0;
    for (std::size_t f = 0; f < shapes.size(); ++f) {
        const double off = apart(shapes[f], mean);
        swing += off * off / static_cast<double>(shapes.size());
        if (f > 0) speed += apart(shapes[f], shapes[f - 1]) / static_cast<double>(shapes.size() - 1);
    }
    const double gap = apart(shapes.front(), last) / std::sqrt(std::max(swing, 1e-12));
    const double begin = apart(shapes[1], shapes[0]) / speed,
                 end = apart(shapes[shapes.size() - 1], shapes[shapes.size() - 2]) / speed;
    return gap < kCloseGap && begin + end > 2.0 * kSeamMotion;
}

}  // namespace muster
