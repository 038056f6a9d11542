// Skeleton and poses; BVH files.
#include <limits>

#include "bindings/c/c_motion/libraries.h"
#include "bindings/c/c_world/handle_table.h"
#include "bindings/c/c_world/layout.h"

namespace muster::c_api {

template <class M>
void fields(M& m, C<M, MusterBvhJoint>& c, P<M, BvhJoint>& p) {
    m.text(c.name, p.name);
    m.plain(c.parent, p.parent);
    m.plain(c.offset, p.offset);
    m.list(c.ends, c.endCount, p.ends, "ends");
    m.plain(c.moves, p.moves);
}

namespace {

static_assert(sizeof(MusterJoint) == sizeof(Joint) &&
              offsetof(MusterJoint, offset) == offsetof(Joint, offset) &&
              offsetof(MusterJoint, tip) == offsetof(Joint, tip));
static_assert(sizeof(MusterTravel) == sizeof(Travel));

struct BvhThing {
    BvhMotion motion;
    Arena arena;
    MusterBvh written{};
};

using BvhFiles = HandleTable<MusterBvhId, BvhThing>;

BvhFiles& bvhFiles() {
    static BvhFiles& table = *new BvhFiles("BVH file");
    return table;
}

/// Takes what `read` gives and gives its handle; none where it fails.
template <class Read>
MusterStatus addBvh(MusterBvhId* outBvh, double unit, Read&& read) noexcept {
    return call([&]() -> Status {
        if (outBvh == nullptr) return nullArgument("outBvh");
        *outBvh = {0, 0};
        if (!(unit == 0.0 || (unit >= 1e-6 && unit <= 1e3)))
            return invalidArgument("unit: found no number from 1e-6 to 1e3 and not 0");
        Result<BvhMotion> motion = read(BvhOptions{unit});
        if (!motion.ok()) return motion.status();
        auto thing = std::make_unique<BvhThing>();
        thing->motion = *std::move(motion);
        const BvhMotion& file = thing->motion;
        MusterBvh& out = thing->written;
        out.structVersion = StructVersion<MusterBvh>::kValue;
        out.joints = writeAll<MusterBvhJoint>(file.joints, thing->arena, out.jointCount);
        ToC(thing->arena).list(out.values, out.valueCount, file.values, "values");
        out.frames = static_cast<std::int32_t>(file.frames);
        out.rate = file.rate;
        out.unit = file.unit;
        out.duration = file.duration();
        *outBvh = bvhFiles().add(std::move(thing));
        return {};
    });
}

}  // namespace
}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

const MusterJoint* muster_skeleton(void) {
    return reinterpret_cast<const MusterJoint*>(skeleton().data());
}

float muster_character_size(uint32_t character) {
    return characterSize(character);
}

MusterBodyPose muster_rest_pose(void) {
    return poseOf(restPose());
}

MusterStatus muster_joint_transforms(const MusterBodyPose* pose, const MusterTransform* root,
                                     MusterTransform* outJoints) {
    return call([&]() -> Status {
        const Status given = needPointers({"pose", "root", "outJoints"}, pose, root, outJoints);
        if (!given.ok()) return given;
        Transform from;
        std::memcpy(static_cast<void*>(&from), root, sizeof(from));
        JointTransforms joints;
        jointTransforms(poseOf(*pose), from, joints);
        giveJoints(joints, outJoints);
        return {};
    });
}

MusterStatus muster_blend_poses(const MusterBodyPose* a, const MusterBodyPose* b, float t,
                                MusterBodyPose* outPose) {
    return call([&]() -> Status {
        if (const Status given = needPointers({"a", "b", "outPose"}, a, b, outPose); !given.ok())
            return given;
        if (!(t >= 0.0f && t <= 1.0f)) return invalidArgument("t: found no number from 0 to 1");
        BodyPose pose;
        blend(poseOf(*a), poseOf(*b), t, pose);
        *outPose = poseOf(pose);
        return {};
    });
}

const char* muster_limb_name(MusterLimb limb) {
    return limb < MUSTER_LIMB_COUNT ? limbName(static_cast<Limb>(limb)) : nullptr;
}

MusterJointRole muster_limb_joint(MusterLimb limb) {
    return limb < MUSTER_LIMB_COUNT ? static_cast<MusterJointRole>(limbJoint(static_cast<Limb>(limb)))
                                    : static_cast<MusterJointRole>(MUSTER_JOINT_COUNT);
}

MusterTravel muster_travel_compose(MusterTravel first, MusterTravel then) {
    const Travel travel = Travel{first.x, first.y, first.yaw} * Travel{then.x, then.y, then.yaw};
    return {travel.x, travel.y, travel.yaw};
}

MusterBvh muster_default_bvh(void) {
    MusterBvh none{};
    none.structVersion = StructVersion<MusterBvh>::kValue;
    return none;
}

MusterStatus muster_bvh_parse(const char* text, size_t size, const char* sourceName, double unit,
                              MusterBvhId* outBvh) {
    return addBvh(outBvh, unit, [&](const BvhOptions& options) -> Result<BvhMotion> {
        if (const Status given = needPointers({"text", "sourceName"}, text, sourceName); !given.ok())
            return given;
        return parseBvh({text, size}, sourceName, options);
    });
}

MusterStatus muster_bvh_read(const char* path, double unit, MusterBvhId* outBvh) {
    return addBvh(outBvh, unit, [&](const BvhOptions& options) -> Result<BvhMotion> {
        return path == nullptr ? nullArgument("path") : readBvh(path, options);
    });
}

MusterStatus muster_bvh_get(MusterBvhId bvh, MusterBvh* outFile) {
    return call([&]() -> Status {
        if (const Status fits = needStruct(outFile, "outFile"); !fits.ok()) return fits;
        const Result<BvhThing*> found = bvhFiles().find(bvh);
        if (!found.ok()) return found.status();
        *outFile = (*found)->written;
        return {};
    });
}

MusterStatus muster_bvh_destroy(MusterBvhId bvh) {
    return call([&] { return bvhFiles().destroy(bvh); });
}
