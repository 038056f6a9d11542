// The motion of crowds.
#include "bindings/c/c_motion/libraries.h"
#include "bindings/c/c_world/handle_table.h"
#include "bindings/c/c_world/layout.h"
#include "bindings/c/c_world/world_handle.h"
#include "muster/motion.h"

namespace muster::c_api {
namespace {

static_assert(sizeof(MusterMotionState) == sizeof(MotionState) &&
              offsetof(MusterMotionState, fade) == offsetof(MotionState, fade) &&
              offsetof(MusterMotionState, position) == offsetof(MotionState, position) &&
              offsetof(MusterMotionState, size) == offsetof(MotionState, size));

/// A motion, and the clips that it plays.
struct MotionThing {
    MotionThing(std::shared_ptr<const ClipLibrary> library, bool allNear)
        : clips(std::move(library)), motion(*clips, {allNear}) {}

    std::shared_ptr<const ClipLibrary> clips;
    CrowdMotion motion;
};
/// A moment, and the clips of its motion.
struct MomentThing {
    std::shared_ptr<const ClipLibrary> clips;
    std::shared_ptr<const CrowdMotionState> state;
};

using Motions = HandleTable<MusterMotionId, MotionThing>;
using Moments = HandleTable<MusterMotionMomentId, MomentThing>;

Motions& motions() {
    static Motions& table = *new Motions("motion");
    return table;
}
Moments& moments() {
    static Moments& table = *new Moments("moment");
    return table;
}

/// Calls `work` with a motion.
template <class Work>
MusterStatus withMotion(MusterMotionId id, Work&& work) noexcept {
    return call([&]() -> Status {
        const Result<MotionThing*> found = motions().find(id);
        return found.ok() ? work(**found) : found.status();
    });
}
/// Calls `work` with a motion and the index of a body that has a whole pose.
template <class Work>
MusterStatus withBody(MusterMotionId id, std::int32_t k, const void* out, const char* name,
                      Work&& work) noexcept {
    return withMotion(id, [&](MotionThing& thing) -> Status {
        if (out == nullptr) return nullArgument(name);
        const std::size_t count = thing.motion.near().size();
        if (k < 0 || static_cast<std::size_t>(k) >= count)
            return invalidArgument("k: found " + std::to_string(k) + ", expected one below " +
                                   std::to_string(count));
        work(thing.motion, static_cast<std::size_t>(k));
        return {};
    });
}

}  // namespace
}  // namespace muster::c_api

using namespace muster;
using namespace muster::c_api;

MusterStatus muster_motion_create(MusterClipLibraryId library, bool allNear, MusterMotionId* outMotion) {
    return call([&]() -> Status {
        if (outMotion == nullptr) return nullArgument("outMotion");
        *outMotion = {0, 0};
        const Result<LibraryThing*> found = findLibrary(library);
        if (!found.ok()) return found.status();
        *outMotion = motions().add(std::make_unique<MotionThing>((*found)->clips, allNear));
        return {};
    });
}

MusterStatus muster_motion_destroy(MusterMotionId motion) {
    return call([&] { return motions().destroy(motion); });
}

MusterStatus muster_motion_restart(MusterMotionId motion) {
    return withMotion(motion, [](MotionThing& thing) -> Status {
        thing.motion.restart();
        return {};
    });
}

MusterStatus muster_motion_update(MusterMotionId motion, MusterWorldId world) {
    return withMotion(motion, [&](MotionThing& thing) -> Status {
        const Result<WorldHandle*> found = findWorld(world);
        if (!found.ok()) return found.status();
        thing.motion.update((*found)->world());
        return {};
    });
}

MusterStatus muster_motion_set_near(MusterMotionId motion, const MusterCharacterId* ids, int32_t idCount) {
    return withMotion(motion, [&](MotionThing& thing) -> Status {
        std::vector<std::uint32_t> wanted;
        FromC reader;
        reader.list(ids, idCount, wanted, "ids");
        if (reader.status().ok()) thing.motion.setNear(wanted);
        return reader.status();
    });
}

MusterStatus muster_motion_states(MusterMotionId motion, const MusterMotionState** outStates,
                                  int32_t* outCount) {
    return withMotion(motion, [&](MotionThing& thing) {
        return giveSpan(thing.motion.states(), outStates, "outStates", outCount);
    });
}

MusterStatus muster_motion_near(MusterMotionId motion, const uint32_t** outIndices, int32_t* outCount) {
    return withMotion(motion, [&](MotionThing& thing) {
        return giveSpan(thing.motion.near(), outIndices, "outIndices", outCount);
    });
}

MusterStatus muster_motion_pose(MusterMotionId motion, int32_t k, MusterBodyPose* outPose) {
    return withBody(motion, k, outPose, "outPose",
                    [&](const CrowdMotion& crowd, std::size_t body) { *outPose = poseOf(crowd.pose(body)); });
}

MusterStatus muster_motion_near_id(MusterMotionId motion, int32_t k, MusterCharacterId* outCharacter) {
    return withBody(motion, k, outCharacter, "outCharacter",
                    [&](const CrowdMotion& crowd, std::size_t body) { *outCharacter = crowd.nearId(body); });
}

MusterStatus muster_motion_locked(MusterMotionId motion, int32_t k, MusterLimb limb, bool* outLocked) {
    if (limb >= MUSTER_LIMB_COUNT)
        return finish(invalidArgument("limb: found " + std::to_string(limb) + ", expected 0 to 5"));
    return withBody(motion, k, outLocked, "outLocked", [&](const CrowdMotion& crowd, std::size_t body) {
        *outLocked = crowd.locked(body, static_cast<Limb>(limb));
    });
}

MusterStatus muster_motion_joints(MusterMotionId motion, int32_t k, MusterTransform* outJoints) {
    return withBody(motion, k, outJoints, "outJoints", [&](const CrowdMotion& crowd, std::size_t body) {
        JointTransforms joints;
        worldJoints(crowd.states()[crowd.near()[body]], crowd.pose(body), joints);
        giveJoints(joints, outJoints);
    });
}

MusterStatus muster_motion_moment(MusterMotionId motion, MusterMotionMomentId* outMoment) {
    return withMotion(motion, [&](MotionThing& thing) -> Status {
        if (outMoment == nullptr) return nullArgument("outMoment");
        auto moment = std::make_unique<MomentThing>();
        moment->clips = thing.clips;
        moment->state = thing.motion.state();
        *outMoment = moments().add(std::move(moment));
        return {};
    });
}

MusterStatus muster_motion_go_back(MusterMotionId motion, MusterMotionMomentId moment) {
    return withMotion(motion, [&](MotionThing& thing) -> Status {
        const Result<MomentThing*> found = moments().find(moment);
        if (!found.ok()) return found.status();
        if ((*found)->clips.get() != thing.clips.get())
            return invalidArgument("moment: found one of other clips, expected one of the motion's library");
        thing.motion.goBack(*(*found)->state);
        return {};
    });
}

MusterStatus muster_motion_moment_size(MusterMotionMomentId moment, size_t* outBytes) {
    return call([&]() -> Status {
        if (outBytes == nullptr) return nullArgument("outBytes");
        const Result<MomentThing*> found = moments().find(moment);
        if (found.ok()) *outBytes = CrowdMotion::sizeOf(*(*found)->state);
        return found.status();
    });
}

MusterStatus muster_motion_moment_destroy(MusterMotionMomentId moment) {
    return call([&] { return moments().destroy(moment); });
}
