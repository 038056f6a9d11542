#include "engine/formation/mesh/rigid_fit.h"

#include "muster/assert.h"

namespace muster {

Pose bestRigidFit(std::span<const Vec2> rest, std::span<const Vec2> vertices) {
    MUSTER_ASSERT(rest.size() == vertices.size());
    Pose pose;
    if (rest.empty()) return pose;
    Vec2 restMean;
    Vec2 mean;
    for (const Vec2 p : rest) restMean += p;
    for (const Vec2 p : vertices) mean += p;
    restMean = restMean / static_cast<double>(rest.size());
    mean = mean / static_cast<double>(rest.size());
    Vec2 sum;
    for (std::size_t k = 0; k < rest.size(); ++k)
        sum += complexProduct(complexConjugate(rest[k] - restMean), vertices[k] - mean);
    const double l = length(sum);
    if (l > 1e-300) pose.rotation = {sum.x / l, sum.y / l};
    pose.position = mean - pose.rotation.apply(restMean);
    return pose;
}

}  // namespace muster
