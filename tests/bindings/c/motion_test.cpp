// Clips, poses and the motion of a crowd by the C API, against the C++ API.
#include <doctest.h>

#include <cstring>

#include "bindings/c/both_worlds.h"
#include "bindings/c/c_motion/libraries.h"
#include "muster/motion.h"
#include "muster/own_clips.h"

using namespace muster;

namespace {

bool samePose(const MusterBodyPose& a, const BodyPose& b) {
    return std::memcmp(&a, &b, sizeof(a)) == 0;
}

MusterClipLibraryId ownLibrary() {
    MusterClipLibraryId library{};
    REQUIRE(muster_clips_own(&library) == MUSTER_OK);
    return library;
}

}  // namespace

TEST_SUITE("motion in C") {
    TEST_CASE("Muster's own clips are those of the engine, and sample alike") {
        const MusterClipLibraryId library = ownLibrary();
        const MusterClip* clips = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_clips_get(library, &clips, &count) == MUSTER_OK);
        REQUIRE(count == static_cast<int>(ownClips().clips.size()));
        for (std::int32_t i = 0; i < count; ++i) {
            const Clip& own = ownClips().clips[static_cast<std::size_t>(i)];
            CAPTURE(own.name);
            CHECK(own.name == clips[i].name);
            CHECK(clips[i].poseCount == static_cast<int>(own.poses.size()));
            std::int32_t index = -1;
            CHECK(muster_clips_find(library, own.name.c_str(), &index) == MUSTER_OK);
            CHECK(index == i);
            MusterClipMeasures measures{};
            REQUIRE(muster_clip_measures(library, i, &measures) == MUSTER_OK);
            CHECK(measures.speed == own.speed());
            CHECK(measures.duration == own.duration());
            for (const double time : {-1.5, 0.0, 0.31, 7.0}) {
                MusterBodyPose pose;
                BodyPose expected;
                own.sample(time, expected);
                REQUIRE(muster_clip_sample(library, i, time, &pose) == MUSTER_OK);
                CHECK(samePose(pose, expected));
                MusterTravel travel{};
                REQUIRE(muster_clip_travel_at(library, i, time, &travel) == MUSTER_OK);
                CHECK(travel.x == own.travelAt(time).x);
                const MusterLimbContact* contact = nullptr;
                REQUIRE(muster_clip_contact_at(library, i, MUSTER_LIMB_LEFT_FOOT, time, &contact) ==
                        MUSTER_OK);
                const Contact* const same = own.contactAt(Limb::LeftFoot, time);
                REQUIRE((contact == nullptr) == (same == nullptr));
                if (same != nullptr) CHECK(contact->anchor.x == same->anchor.x);
            }
        }
        std::int32_t index = -1;
        CHECK(muster_clips_find(library, "no such clip", &index) == MUSTER_NOT_FOUND);
        CHECK(muster_clips_destroy(library) == MUSTER_OK);
        CHECK(muster_clips_destroy(library) == MUSTER_NOT_FOUND);
    }

    TEST_CASE("a library of given clips is the same again; faulty ones are named") {
        const MusterClipLibraryId own = ownLibrary();
        const MusterClip* clips = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_clips_get(own, &clips, &count) == MUSTER_OK);
        MusterClipLibraryId copy{};
        REQUIRE(muster_clips_create(clips, count, &copy) == MUSTER_OK);
        MusterBuffer first{}, second{};
        REQUIRE(muster_clip_bvh(own, 2, &first) == MUSTER_OK);
        REQUIRE(muster_clip_bvh(copy, 2, &second) == MUSTER_OK);
        CHECK(std::string(reinterpret_cast<char*>(first.data)) == bvhText(ownClips().clips[2]));
        CHECK(std::string(reinterpret_cast<char*>(second.data)) == bvhText(ownClips().clips[2]));

        MusterBvhId file{};
        const char* const text = reinterpret_cast<const char*>(first.data);
        REQUIRE(muster_bvh_parse(text, first.size, "run.bvh", 0.01, &file) == MUSTER_OK);
        MusterBvh bvh = muster_default_bvh();
        REQUIRE(muster_bvh_get(file, &bvh) == MUSTER_OK);
        const BvhMotion expected = *parseBvh(text, "run.bvh", {0.01});
        CHECK(bvh.frames == static_cast<int>(expected.frames));
        REQUIRE(bvh.jointCount == static_cast<int>(expected.joints.size()));
        CHECK(expected.joints[4].name == bvh.joints[4].name);
        CHECK(bvh.valueCount == bvh.frames * bvh.jointCount);
        CHECK(bvh.values[40].translation.z == expected.values[40].translation.z);
        CHECK(bvh.duration == expected.duration());
        CHECK(muster_bvh_destroy(file) == MUSTER_OK);
        CHECK(muster_bvh_parse("x", 1, "bad.bvh", 0.0, &file) == MUSTER_PARSE_ERROR);
        CHECK(std::string(muster_last_error()) == parseBvh("x", "bad.bvh").status().message());
        muster_free_buffer(&first);
        muster_free_buffer(&second);

        MusterClip broken = clips[0];
        broken.rate = -1.0;
        Clip same = ownClips().clips[0];
        same.rate = -1.0;
        MusterClipLibraryId none{};
        CHECK(muster_clips_create(&broken, 1, &none) == MUSTER_INVALID_ARGUMENT);
        CHECK(std::string(muster_last_error()) == validate(same).message());
        const MusterClip twice[] = {clips[0], clips[0]};
        CHECK(muster_clips_create(twice, 2, &none) == MUSTER_INVALID_ARGUMENT);
        const MusterClip zeroed{};
        CHECK(muster_clips_create(&zeroed, 1, &none) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_clips_destroy(own) == MUSTER_OK);
        CHECK(muster_clips_destroy(copy) == MUSTER_OK);
    }

    TEST_CASE("a crowd moves as by the C++ API, goes back, and outlives the handle of its clips") {
        BothWorlds both(makeDef());
        const MusterClipLibraryId library = ownLibrary();
        MusterMotionId motion{};
        REQUIRE(muster_motion_create(library, true, &motion) == MUSTER_OK);
        CHECK(muster_clips_destroy(library) == MUSTER_OK);
        CrowdMotion engine(ownClips());
        MusterMotionMomentId moment{};
        std::vector<MotionState> earlier;
        for (int step = 0; step < 60; ++step) {
            both.step();
            REQUIRE(muster_motion_update(motion, both.id()) == MUSTER_OK);
            engine.update(both.engine());
            if (step == 40) {
                REQUIRE(muster_motion_moment(motion, &moment) == MUSTER_OK);
                earlier.assign(engine.states().begin(), engine.states().end());
            }
        }
        const MusterMotionState* states = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_motion_states(motion, &states, &count) == MUSTER_OK);
        REQUIRE(count == 36);
        CHECK(std::memcmp(states, engine.states().data(), engine.states().size_bytes()) == 0);
        const std::uint32_t* near = nullptr;
        REQUIRE(muster_motion_near(motion, &near, &count) == MUSTER_OK);
        REQUIRE(count == 36);
        MusterBodyPose pose;
        REQUIRE(muster_motion_pose(motion, 7, &pose) == MUSTER_OK);
        CHECK(samePose(pose, engine.pose(7)));
        MusterTransform joints[MUSTER_JOINT_COUNT];
        JointTransforms expected;
        worldJoints(engine.states()[7], engine.pose(7), expected);
        REQUIRE(muster_motion_joints(motion, 7, joints) == MUSTER_OK);
        CHECK(std::memcmp(joints, expected.data(), sizeof(joints)) == 0);
        bool locked = false;
        REQUIRE(muster_motion_locked(motion, 7, MUSTER_LIMB_RIGHT_FOOT, &locked) == MUSTER_OK);
        CHECK(locked == engine.locked(7, Limb::RightFoot));

        std::size_t bytes = 0;
        CHECK(muster_motion_moment_size(moment, &bytes) == MUSTER_OK);
        CHECK(bytes > 36 * sizeof(MotionState));
        REQUIRE(muster_motion_go_back(motion, moment) == MUSTER_OK);
        REQUIRE(muster_motion_states(motion, &states, &count) == MUSTER_OK);
        CHECK(std::memcmp(states, earlier.data(), earlier.size() * sizeof(MotionState)) == 0);

        const std::uint32_t wanted[] = {5, 3, 999};
        CHECK(muster_motion_set_near(motion, wanted, 3) == MUSTER_OK);
        CHECK(muster_motion_update(motion, both.id()) == MUSTER_OK);
        REQUIRE(muster_motion_near(motion, &near, &count) == MUSTER_OK);
        CHECK(count == 2);
        MusterCharacterId id = 0;
        CHECK(muster_motion_near_id(motion, 1, &id) == MUSTER_OK);
        CHECK(id == 5);
        CHECK(muster_motion_pose(motion, 2, &pose) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_motion_locked(motion, 0, 6, &locked) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_motion_destroy(motion) == MUSTER_OK);
        CHECK(muster_motion_update(motion, both.id()) == MUSTER_NOT_FOUND);
        CHECK(muster_motion_moment_destroy(moment) == MUSTER_OK);
    }

    TEST_CASE("a moment of other clips is refused, and no clips at all are the rest pose") {
        BothWorlds both(makeDef());
        MusterClipLibraryId none{};
        const MusterClipLibraryId own = ownLibrary();
        REQUIRE(muster_clips_create(nullptr, 0, &none) == MUSTER_OK);
        MusterMotionId still{}, moving{};
        REQUIRE(muster_motion_create(none, true, &still) == MUSTER_OK);
        REQUIRE(muster_motion_create(own, true, &moving) == MUSTER_OK);
        REQUIRE(muster_motion_update(still, both.id()) == MUSTER_OK);
        REQUIRE(muster_motion_update(moving, both.id()) == MUSTER_OK);
        MusterBodyPose pose;
        REQUIRE(muster_motion_pose(still, 0, &pose) == MUSTER_OK);
        const MusterBodyPose rest = muster_rest_pose();
        CHECK(std::memcmp(&pose, &rest, sizeof(pose)) == 0);
        MusterMotionMomentId moment{};
        REQUIRE(muster_motion_moment(moving, &moment) == MUSTER_OK);
        CHECK(muster_motion_go_back(still, moment) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_motion_go_back(moving, {9, 9}) == MUSTER_NOT_FOUND);
        CHECK(muster_motion_restart(moving) == MUSTER_OK);
        CHECK(muster_motion_destroy(still) == MUSTER_OK);
        CHECK(muster_motion_destroy(moving) == MUSTER_OK);
        CHECK(muster_motion_moment_destroy(moment) == MUSTER_OK);
    }

    TEST_CASE("the skeleton stands 1.75 m tall by its own offsets") {
        const MusterJoint* const joints = muster_skeleton();
        MusterTransform placed[MUSTER_JOINT_COUNT];
        const MusterBodyPose rest = muster_rest_pose();
        const MusterTransform root{{0, 0, 0, 1}, {1, 2, 0}};
        REQUIRE(muster_joint_transforms(&rest, &root, placed) == MUSTER_OK);
        const MusterVec3 head = placed[MUSTER_JOINT_HEAD].translation;
        CHECK(head.z + joints[MUSTER_JOINT_HEAD].tip.z == doctest::Approx(kBodyHeight));
        CHECK(head.y == doctest::Approx(2.0));
        CHECK(std::string(joints[MUSTER_JOINT_LEFT_FORE_ARM].name) == "LeftForeArm");
        CHECK(joints[MUSTER_JOINT_HIPS].parent == -1);
        MusterBodyPose half;
        MusterBodyPose low = rest;
        low.hips.z -= 0.5f;
        CHECK(muster_blend_poses(&rest, &low, 0.5f, &half) == MUSTER_OK);
        CHECK(half.hips.z == doctest::Approx(rest.hips.z - 0.25));
        CHECK(muster_blend_poses(&rest, &low, 2.0f, &half) == MUSTER_INVALID_ARGUMENT);
        const MusterTravel turned = muster_travel_compose({1.0f, 0.0f, 1.5707963f}, {2.0f, 0.0f, 0.0f});
        CHECK(turned.x == doctest::Approx(1.0));
        CHECK(turned.y == doctest::Approx(2.0));
        CHECK(muster_character_size(12) == characterSize(12));
        CHECK(std::string(muster_limb_name(MUSTER_LIMB_LEFT_HAND)) == "left hand");
        CHECK(muster_limb_joint(MUSTER_LIMB_LEFT_HAND) == MUSTER_JOINT_LEFT_HAND);
        CHECK(muster_limb_joint(9) == MUSTER_JOINT_COUNT);
    }
}
