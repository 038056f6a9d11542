#include "people/clips/bvh_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "people/clips/forward.h"
#include "people/clips/retarget.h"

namespace muster {
namespace {

constexpr double kTypicalExtent = 1.65;  // Largest extent of an adult with arms spread or down [m].
// Factor by which the extent of a body may be off for it to be a person.
constexpr double kFarFromTypical = 4.0;

std::vector<Vec3> posedPositions(std::span<const BvhJoint> joints, std::span<const Transform> frame) {
    std::vector<Transform> posed;
    std::vector<Vec3> positions;
    for (std::size_t j = 0; j < joints.size(); ++j) {
        const std::int32_t parent = joints[j].parent;
        posed.push_back(parent < 0 ? frame[j] : posed[parent] * frame[j]);
        positions.push_back(posed.back().translation);
    }
    return positions;
}

/// The signed axis nearest to a direction; zero if none is near.
Vec3 nearestAxis(Vec3 v) {
    const float x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z), all = length(v);
    if (!(all > 0.0f) || std::max({x, y, z}) < 0.75f * all) return {};
    if (x >= y && x >= z) return {v.x > 0.0f ? 1.0f : -1.0f, 0.0f, 0.0f};
    if (y >= z) return {0.0f, v.y > 0.0f ? 1.0f : -1.0f, 0.0f};
    return {0.0f, 0.0f, v.z > 0.0f ? 1.0f : -1.0f};
}

/// Direction from the feet, or the knees, to the hips; zero without legs.
Vec3 upward(const RoleJoints& roles, const std::vector<Vec3>& positions) {
    const auto at = [&](JointRole role) { return positions[roles[index(role)]]; };
    if (!hasBody(roles).ok()) return {};
    return at(JointRole::Hips) - 0.5f * (at(JointRole::LeftFoot) + at(JointRole::RightFoot));
}

Vec3 leftward(const RoleJoints& roles, const std::vector<Vec3>& positions, Vec3 up) {
    if (!hasBody(roles).ok()) return {};
    const Vec3 across = positions[roles[index(JointRole::LeftUpLeg)]] -
                        positions[roles[index(JointRole::RightUpLeg)]];
    return nearestAxis(across - dot(across, up) * up);
}

}  // namespace

AxisMap guessAxes(std::span<const BvhJoint> joints, std::span<const Transform> frame) {
    const RoleJoints roles = findRoles(joints);
    const std::vector<Vec3> rest = restPositions(joints), posed = posedPositions(joints, frame);
    const auto standing = [](Vec3 up) { return up.y > 0.5f || up.z > 0.5f; };
    Vec3 up = nearestAxis(upward(roles, rest)), left;
    if (standing(up)) left = leftward(roles, rest, up);
    if (!standing(up)) {
        up = nearestAxis(upward(roles, posed));
        if (!standing(up)) up = {0.0f, 1.0f, 0.0f};
    }
    if (length(left) == 0.0f) left = leftward(roles, posed, up);
    // As in Blender, the body faces +Z if Y is up, else -Y; in both cases +X is to the left.
    if (length(left) == 0.0f) left = {1.0f, 0.0f, 0.0f};
    return {cross(left, up), left, up};
}

Result<double> guessUnit(std::span<const BvhJoint> joints) {
    static constexpr std::array kUnits{1.0, 0.3048, 0.0254 / 0.45, 0.0254, 0.01, 0.001};
    Vec3 low{1e9f, 1e9f, 1e9f}, high = -low;
    const auto include = [&](Vec3 p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    };
    const std::vector<Vec3> positions = restPositions(joints);
    for (std::size_t j = 0; j < joints.size(); ++j) {
        if (joints[j].parent >= 0) include(positions[j]);
        for (const Vec3 end : joints[j].ends) include(positions[j] + end);
    }
    const Vec3 extent = high - low;
    const double size = std::max({extent.x, extent.y, extent.z});
    double best = 0.0, least = kFarFromTypical;
    for (const double unit : kUnits) {
        const double ratio = size * unit / kTypicalExtent, off = std::max(ratio, 1.0 / ratio);
        if (!(off < least)) continue;
        least = off;
        best = unit;
    }
    if (best > 0.0) return best;
    char text[160];
    std::snprintf(
        text, sizeof(text),
        "found a skeleton %.4g units large, expected the size of a person in a usual unit; name the unit",
        std::max(size, 0.0));
    return Status(StatusCode::Unsupported, text);
}

}  // namespace muster
