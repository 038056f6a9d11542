// Skinning weights: the joints that move each vertex, and smooth transitions between neighbouring joints.
#include <algorithm>

#include "people/bodies/mesh_builder.h"

namespace muster::bodies {
namespace {

using Loads = std::array<float, kJointCount>;

/// A smooth step from 0 at `from` to 1 at `to`; `from` may be the larger.
float smoothStep(float x, float from, float to) {
    const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

void transferWeight(Loads& loads, JointRole from, JointRole to, float share) {
    float& source = loads[index(from)];
    loads[index(to)] += source * share;
    source *= 1.0f - share;
}

JointRole sided(JointRole left, bool isLeft) {
    return isLeft ? left : static_cast<JointRole>(index(left) + 4);
}

/// Adds the weights of back, shoulders and neck.
void loadTrunk(Vec3 p, Loads& loads) {
    transferWeight(loads, JointRole::Hips, JointRole::Spine, smoothStep(p.z, 0.98f, 1.14f));
    transferWeight(loads, JointRole::Spine, JointRole::Chest, smoothStep(p.z, 1.14f, 1.30f));
    const bool left = p.y > 0.0f;
    const float y = std::abs(p.y);
    transferWeight(loads, JointRole::Chest, JointRole::Neck,
                   smoothStep(p.z, 1.455f, 1.51f) * smoothStep(y, 0.10f, 0.06f));
    transferWeight(loads, JointRole::Neck, JointRole::Head,
                   smoothStep(p.z, 1.53f, 1.58f) * smoothStep(y, 0.10f, 0.06f));
    const float out = smoothStep(y, 0.18f, 0.22f);
    const float high = std::max(out, smoothStep(p.z, 1.24f, 1.37f));
    transferWeight(loads, JointRole::Chest, sided(JointRole::LeftShoulder, left),
                   0.85f * high * smoothStep(y, 0.05f, 0.15f));
    const JointRole shoulder = sided(JointRole::LeftShoulder, left);
    const float arm = smoothStep(y, 0.115f, 0.265f) * std::max(out, smoothStep(p.z, 1.27f, 1.36f));
    transferWeight(loads, shoulder, sided(JointRole::LeftArm, left), arm);
    transferWeight(loads, JointRole::Chest, sided(JointRole::LeftArm, left), arm);
}

/// Share of the legs' weight that belongs to the leg at positive `y`; at least `down` for a vertex on its
/// side.
float legShare(float y, float down) {
    return std::max(smoothStep(y, -0.02f, 0.035f), y > 0.0f ? down : 0.0f);
}

/// Adds the weights of thigh and shin. The transition is shorter on the outer side of a bend than on the
/// inner side, so that knees do not shrink.
void loadLeg(Vec3 p, Loads& loads) {
    // The fold of the hip runs from the crotch up to the outer side. At the back the buttock widens it.
    const float fold = 0.775f + 0.165f * std::clamp(std::abs(p.y) / 0.17f, 0.0f, 1.0f);
    const float behind = smoothStep(p.x, 0.02f, -0.08f);
    const float hips = loads[index(JointRole::Hips)];
    const float thigh = hips *
                        smoothStep(p.z, fold + 0.075f + 0.03f * behind, fold - 0.075f - 0.04f * behind);
    const float down = smoothStep(p.z, 0.80f, 0.74f);
    const float half = 0.045f + 0.03f * smoothStep(p.x, 0.02f, -0.04f);
    const float shin = smoothStep(p.z, 0.49f + half, 0.49f - half);
    for (const bool left : {true, false}) {
        const float load = thigh * legShare(left ? p.y : -p.y, down);
        loads[index(JointRole::Hips)] -= load;
        loads[index(sided(JointRole::LeftUpLeg, left))] += load * (1.0f - shin);
        loads[index(sided(JointRole::LeftLeg, left))] += load * shin;
    }
}

void loadArm(Vec3 p, Loads& loads) {
    const bool left = p.y > 0.0f;
    const float y = std::abs(p.y);
    // Elbows bend forward, so the back is the outer side.
    const float half = 0.035f + 0.025f * smoothStep(p.x, -0.02f, 0.03f);
    transferWeight(loads, sided(JointRole::LeftArm, left), sided(JointRole::LeftForeArm, left),
                   smoothStep(y, 0.46f - half, 0.46f + half));
    transferWeight(loads, sided(JointRole::LeftForeArm, left), sided(JointRole::LeftHand, left),
                   smoothStep(y, 0.68f, 0.74f));
}

void loadShoe(Vec3 p, Loads& loads) {
    const bool left = p.y > 0.0f;
    transferWeight(loads, JointRole::Hips, sided(JointRole::LeftFoot, left), 1.0f);
    transferWeight(loads, sided(JointRole::LeftFoot, left), sided(JointRole::LeftToeBase, left),
                   smoothStep(p.x, 0.10f, 0.16f));
}

/// Stores the four largest weights in descending order, normalised to sum 1.
void keepFour(const Loads& loads, BodyVertex& vertex) {
    std::array<std::uint8_t, kJointCount> order;
    for (std::size_t j = 0; j < kJointCount; ++j) order[j] = static_cast<std::uint8_t>(j);
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return loads[a] > loads[b]; });
    float sum = 0.0f;
    for (std::size_t k = 0; k < 4; ++k) sum += loads[order[k]] > 0.002f ? loads[order[k]] : 0.0f;
    for (std::size_t k = 0; k < 4; ++k) {
        const float load = loads[order[k]] > 0.002f ? loads[order[k]] : 0.0f;
        vertex.joints[k] = load > 0.0f ? order[k] : std::uint8_t{0};
        vertex.weights[k] = load / sum;
    }
}

}  // namespace

void setWeights(Part part, BodyVertex& vertex) {
    Loads loads{};
    loads[index(part == Part::Head ? JointRole::Head : JointRole::Hips)] = 1.0f;
    const Vec3 p = vertex.position;
    switch (part) {
        case Part::Trunk:
            loadTrunk(p, loads), loadLeg(p, loads);
            break;
        case Part::Leg:
            loadLeg(p, loads);
            break;
        case Part::Arm:
            loadTrunk(p, loads), loadArm(p, loads);
            break;
        case Part::Shoe:
            loadShoe(p, loads);
            break;
        case Part::Head:
            break;
    }
    keepFour(loads, vertex);
}

}  // namespace muster::bodies
