#include <array>
#include <cmath>
#include <vector>

#include "base/maths.h"
#include "character/clips/forward.h"
#include "character/clips/hips_path.h"
#include "character/clips/retarget.h"

namespace muster {
namespace {

constexpr double kCloseGap = 0.55;   // Of the way limbs swing: so far may the last frame be from the first.
constexpr double kSway = 0.17;       // Sine of half the turn that hips make in a step.
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
        const Vec3 p = joints[joint].translation, h = joints[hips].translation;
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

/// The way the hips face, by both hip joints [rad].
double facingAt(const BvhMotion& motion, std::size_t frame, const RoleJoints& roles) {
    std::vector<Transform> joints;
    globalTransforms(motion, frame, joints);
    const auto place = [&](JointRole role) { return joints[roles[index(role)]].translation; };
    const Vec3 left = place(JointRole::LeftUpLeg) - place(JointRole::RightUpLeg);
    return arcTangent2(-left.x, left.y);
}

/// How limbs move on the whole.
struct Swing {
    double width = 0.0;  ///< Root of the mean squared distance from where they are in the mean [m].
    double speed = 0.0;  ///< Mean way from frame to frame [m].
};

Swing swingOf(const std::vector<std::vector<Vec3>>& shapes) {
    const auto count = static_cast<double>(shapes.size());
    std::vector<Vec3> mean(shapes.front().size());
    for (const auto& shape : shapes)
        for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += shape[i] * static_cast<float>(1.0 / count);
    Swing swing;
    double squares = 0.0;
    for (std::size_t f = 0; f < shapes.size(); ++f) {
        const double off = apart(shapes[f], mean);
        squares += off * off / count;
        if (f > 0) swing.speed += apart(shapes[f], shapes[f - 1]) / (count - 1.0);
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
    // A cycle may turn, but a small turn belongs to the sway of the hips.
    const double turn = facingAt(motion, last, roles) - facingAt(motion, 0, roles);
    const bool turns = std::fabs(sine(0.5 * turn)) > kSway;
    const double gap = apart(shapes.front(), shapeOf(motion, last, roles, turns ? turn : 0.0));
    const double atEnds = 0.5 * (apart(shapes[1], shapes[0]) + apart(shapes[last], shapes[last - 1]));
    return gap < kCloseGap * swing.width && atEnds > kSeamMotion * swing.speed;
}

}  // namespace muster
