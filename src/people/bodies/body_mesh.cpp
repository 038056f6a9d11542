#include "people/bodies/body_mesh.h"

#include "people/bodies/sculptor.h"

namespace muster {

const char* bodyRegionName(BodyRegion region) {
    static constexpr const char* kNames[kBodyRegionCount] = {"skin", "shirt", "trousers", "hair", "shoes"};
    return kNames[static_cast<std::size_t>(region)];
}

BodyMesh makeBody(BodyKind kind, BodyLevel level) {
    using namespace bodies;
    return Sculptor(kind == BodyKind::Broad ? broadShape() : narrowShape(),
                    level == BodyLevel::Near ? kFine : kCoarse)
        .make();
}

Vec3 skinned(const BodyVertex& vertex, const JointTransforms& joints) {
    static const JointTransforms kRest = [] {
        JointTransforms rest;
        jointTransforms(restPose(), {}, rest);
        return rest;
    }();
    Vec3 sum;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 local = vertex.position - kRest[vertex.joints[k]].translation;
        sum += joints[vertex.joints[k]].apply(local) * vertex.weights[k];
    }
    return sum;
}

}  // namespace muster
