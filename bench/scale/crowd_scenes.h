// Benchmark scenes whose size grows with the number of characters.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/status.h"
#include "muster/world.h"

namespace muster::scale {

/// Distance from the crowd to the formation, edge to edge, in the regime far [m].
inline constexpr double kAway = 40.0;

/// How the crowd moves.
enum class Regime : std::uint8_t {
    Far,        ///< The formation stands 40 m or more away; the crowd walks there.
    Tracking,   ///< The crowd follows a formation that is dragged and rotated.
    Reversing,  ///< As Tracking, but the drag reverses every 2.5 s.
};

/// The name of a regime: "far", "tracking" or "reversing".
const char* regimeName(Regime regime);

/// Names of all scenes, in the order of the table.
const std::vector<std::string>& sceneNames();

/// Definition of a scene.
struct SceneDef {
    std::string name = "open";         ///< One of sceneNames().
    Regime regime = Regime::Tracking;  ///< How the crowd moves.
    std::int32_t count = 160;          ///< Number of characters.
    std::uint64_t seed = 1;            ///< Seed of starts, trees and course.
    std::string maps;                  ///< Folder with the city's map.
};

/// The course of the formation: a polyline, followed back and forth or, where closed, round and round, with a
/// small oscillating rotation.
struct Course {
    std::vector<Vec2> points;   ///< Vertices [m], at least two.
    bool closed = false;        ///< True for a loop, along whose direction the formation faces.
    double speed = 1.3;         ///< Speed along the polyline [m/s].
    double begin = 0.0;         ///< Arc length at which it begins [m].
    double turn = 0.0;          ///< Amplitude of the rotation [rad].
    double turnPeriod = 12.0;   ///< Period of the rotation [s].
    double reverseEvery = 0.0;  ///< Time between reversals [s]; 0 to reverse at the ends only.
};

/// A pose on the course.
struct CoursePose {
    Vec2 position;       ///< Centre [m].
    double angle = 0.0;  ///< Heading, counter-clockwise from +x [rad].
};

/// The pose reached after `time` [s].
CoursePose poseAt(const Course& course, double time);

/// A world and the course of its formation.
struct Scene {
    WorldDef world;        ///< Definition of the world.
    Course course;         ///< Not used in the regime Far.
    double side = 0.0;     ///< Side of the square formation [m].
    double seconds = 0.0;  ///< World time of a run [s].
};

/// Adds the only group: its formation at a pose, its characters on free ground round `crowd`. Fails where
/// there is too little free ground.
Status addCrowd(const SceneDef& def, const CoursePose& formation, Vec2 crowd, Scene& scene);
/// Centre of a crowd that starts behind a formation at this pose [m].
Vec2 behind(const CoursePose& formation);
/// Sets parameters such that a crowd stays 1 to 3 m behind a dragged formation.
void letLag(Parameters& parameters);

/// Makes a scene. Fails with NotFound where there is no such scene or the city's map is missing.
Result<Scene> makeScene(const SceneDef& def);

}  // namespace muster::scale
