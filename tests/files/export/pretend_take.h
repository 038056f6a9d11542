// Synthetic characters for tests of formats with bodies: they wave, walk in circles, appear late and leave
// early.
#pragma once

#include "base/maths.h"
#include "files/export/export_fixture.h"
#include "muster/motion.h"

namespace muster::testing {

/// A world with a wall, a tree, a car that drives along a bend, and a pool.
inline WorldDef furnishedWorld() {
    WorldDef def{.name = "A \"furnished\" world", .box = {{-20, -10}, {20, 10}}};
    ObstacleDef wall{.polygon = {{-4, 4}, {6, 4}, {6, 5}, {-3, 5}, {-3, 8}, {-4, 8}}};
    ObstacleDef tree{.name = "Old oak", .centre = {8, -5}, .radius = 0.4};
    ObstacleDef car{.name = "Car",
                    .polygon = {{-16, -8}, {-12, -8}, {-12, -6.2}, {-16, -6.2}},
                    .path = {.waypoints = {{0.0, {0, 0}, 0.0}, {2.0, {6, 0}, 0.0}, {4.0, {8, 3}, 1.2}}},
                    .height = 1.5};
    def.obstacles = {wall, tree, car};
    PatchDef pool{.name = "Pool", .polygon = {{10, 0}, {15, 0}, {15, 6}, {10, 6}}};
    pool.motion = 4;  // swim
    def.patches = {pool};
    def.groups = {{.count = 4}};
    return def;
}

/// One frame with some characters.
struct PretendFrame {
    std::vector<ExportCharacter> characters;
    std::vector<BodyPose> poses;
};

/// The characters whose ids lie in [from, to) at a time [s].
inline PretendFrame pretendPeople(std::uint32_t from, std::uint32_t to, double time) {
    PretendFrame frame;
    for (std::uint32_t id = from; id < to; ++id) {
        const double turn = 0.9 * time + 2.0 * id;
        ExportCharacter c{.id = id, .position = {3.0 * id + 2.0 * cosine(turn), 2.0 * sine(turn)}};
        // The characters walk in circles: the yaw jumps from pi to -pi.
        c.yaw = static_cast<float>(arcTangent2(cosine(turn), -sine(turn)));
        c.size = characterSize(id);
        BodyPose pose = restPose();
        pose.hips += Vec3{0.02f, 0.0f, static_cast<float>(-0.1 + 0.1 * sine(3.0 * time))};
        for (std::size_t j = 0; j < kJointCount; ++j) {
            const double k = static_cast<double>(j);
            const Vec3 axis = normalized(Vec3{static_cast<float>(sine(k)),
                                              static_cast<float>(cosine(1.7 * k)),
                                              static_cast<float>(sine(2.3 * k + 1.0))});
            pose.rotation[j] = axisAngle(axis, 1.2 * sine(2.0 * time + k));
            // The same rotation with the other sign, as it may occur in a library.
            if ((j + frame.poses.size()) % 3 == 0 && static_cast<int>(time * 10.0) % 2 == 1)
                pose.rotation[j] = -pose.rotation[j];
        }
        frame.characters.push_back(c);
        frame.poses.push_back(pose);
    }
    for (std::size_t i = 0; i < frame.characters.size(); ++i) frame.characters[i].pose = &frame.poses[i];
    return frame;
}

/// The positions of the joints of one character.
inline JointTransforms jointsOf(const ExportCharacter& c) {
    MotionState place{.position = c.position, .yaw = c.yaw, .size = c.size};
    JointTransforms joints;
    worldJoints(place, *c.pose, joints);
    return joints;
}

/// The characters of a frame of the take below: the fourth appears at frame 20 and leaves at 50, all others
/// stay.
inline std::uint32_t peopleIn(std::size_t frame) {
    return frame >= 20 && frame < 50 ? 5u : 4u;
}

/// Passes `frames` frames to an exporter, 30 per second; fails with the exporter's failures.
inline Status exportPretendTake(Exporter& exporter, std::size_t frames) {
    const auto world = World::create(furnishedWorld());
    if (!world.ok()) return world.status();
    if (Status s = exporter.begin({"Pretended", 30.0, 1.0, frames, &*world}); !s.ok()) return s;
    for (std::size_t k = 0; k < frames; ++k) {
        const double time = 1.0 + static_cast<double>(k) / 30.0;
        const PretendFrame frame = pretendPeople(1, peopleIn(k), time);
        if (Status s = exporter.frame({k, time, frame.characters, &*world}); !s.ok()) return s;
    }
    return exporter.finish();
}

}  // namespace muster::testing
