#include <array>
#include <cmath>
#include <vector>

#include "base/maths.h"
#include "people/clips/forward.h"
#include "people/clips/hips_path.h"
#include "people/clips/retarget.h"

namespace muster {
namespace {

// Largest distance of the last frame from the first, as a share of the limbs' swing.
constexpr double kCloseGap = 0.55;
constexpr double kSway = 0.17;       // Sine of half the yaw by which hips sway in a step.
constexpr double kSeamMotion = 0.6;  // Least speed of the limbs at both ends, as a share of their mean speed.

/// Positions of the joints relative to the hips in one frame, rotated back by `facing` [m].
std::vector<Vec3> shapeOf(const BvhMotion& motion, std::size_t frame, const RoleJoints& roles,
                          double facing) {
    std::vector<Transform> joints;
    globalTransforms(motion, frame, joints);
    std::vector<Vec3> shape;
    const auto hips = static_cast<std::size_t>(roles[0]);
    const Quat back = yawTurn(-facing);
    for (const std::int32_t joint : roles) {
        if (joint < 0) continue;
        const Vec3 p = joints[joint].translation, h = joints[hips].translation;
        shape.push_back(rotate(back, p - Vec3{h.x, h.y, 0.0f}));
    }
    return shape;
}

/// Root mean square distance of two shapes [m].
double rmsDistance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(lengthSquared(a[i] - b[i]));
    return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Facing of the hips, from both hip joints [rad].
double facingAt(const BvhMotion& motion, std::size_t frame, const RoleJoints& roles) {
    std::vector<Transform> joints;
    globalTransforms(motion, frame, joints);
    const auto jointPosition = [&](JointRole role) { return joints[roles[index(role)]].translation; };
    const Vec3 left = jointPosition(JointRole::LeftUpLeg) - jointPosition(JointRole::RightUpLeg);
    return arcTangent2(-left.x, left.y);
}

/// Amplitude and speed of the limbs over a whole motion.
struct Swing {
    double width = 0.0;  ///< Root mean square distance from the mean shape [m].
    double speed = 0.0;  ///< Mean distance from frame to frame [m].
};

Swing swingOf(const std::vector<std::vector<Vec3>>& shapes) {
    const auto count = static_cast<double>(shapes.size());
    std::vector<Vec3> mean(shapes.front().size());
    for (const auto& shape : shapes)
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += shape[i] * static_cast<float>(1.0 / count);
    Swing swing;
    double squares = 0.0;
    for (std::size_t f = 0; f < shapes.size(); ++f) {
        const double off = rmsDistance(shapes[f], mean);
        squares += off * off / count;
        if (f > 0) swing.speed += rmsDistance(shapes[f], shapes[f - 1]) / (count - 1.0);
    }
    swing.width = std::sqrt(squares);
    return swing;
}

}  // namespace

bool isCyclic(const BvhMotion& motion) {
    const RoleJoints roles = findRoles(motion.joints);
    if (motion.frames < 6 || !hasBody(roles).ok()) return false;
    std::vector<std::vector<Vec3>> shapes;
    for (std::size_t f = 0; f < motion.frames; ++f) shapes.push_back(shapeOf(motion, f, roles, 0.0));
    const Swing swing = swingOf(shapes);
    if (!(swing.width > 0.0 && swing.speed > 0.0)) return false;
    const std::size_t last = motion.frames - 1;
    // A cycle may turn, but a small rotation is sway of the hips.
    const double turn = facingAt(motion, last, roles) - facingAt(motion, 0, roles);
    const bool turns = std::fabs(sine(0.5 * turn)) > kSway;
    const double gap = rmsDistance(shapes.front(), shapeOf(motion, last, roles, turns ? turn : 0.0));
    const double atEnds = 0.5 *
                          (rmsDistance(shapes[1], shapes[0]) + rmsDistance(shapes[last], shapes[last - 1]));
    return gap < kCloseGap * swing.width && atEnds > kSeamMotion * swing.speed;
}

}  // namespace muster
