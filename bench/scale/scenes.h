// Scenes for measuring at scale, sized with the number of characters.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "muster/status.h"
#include "muster/world_def.h"

namespace muster::scale {

/// Distance from the crowd to the formation, edge to edge, in the regime far [m].
inline constexpr double kAway = 40.0;

/// How the crowd is moved.
enum class Regime : std::uint8_t {
    Far,        ///< The formation stands 40 m or more away; the crowd walks there.
    Tracking,   ///< The crowd follows a formation that is dragged and turned.
    Reversing,  ///< The drag turns back every 2.5 s.
};

/// "far", "tracking", "reversing".
const char* regimeName(Regime regime);

/// Names of all scenes, in the order of the table.
const std::vector<std::string>& sceneNames();

/// Which scene, how large.
struct SceneDef {
    std::string name = "open";         ///< One of sceneNames().
    Regime regime = Regime::Tracking;  ///< Where the crowd starts.
    std::int32_t count = 160;          ///< Characters.
    std::uint64_t seed = 1;            ///< Of the jitter of starts, trees and course.
    std::string maps;                  ///< Folder with the city's map.
};

/// Where the formation is led: a polyline, walked to and fro (or round, where closed), turning a little.
struct Course {
    std::vector<Vec2> points;   ///< [m], at least two.
    bool closed = false;        ///< Goes round; the formation turns with the course.
    double speed = 1.3;         ///< Along the polyline [m/s].
    double begin = 0.0;         ///< Arc length at which it begins [m].
    double turn = 0.0;          ///< Amplitude of the turning [rad].
    double turnPeriod = 12.0;   ///< Of the turning [s].
    double reverseEvery = 0.0;  ///< Turns back after so long [s]; 0 only at the ends.
};

/// A pose on the course.
struct CoursePose {
    Vec2 position;       ///< Centre [m].
    double angle = 0.0;  ///< Where the formation faces [rad].
};

/// The pose reached after `time` [s].
CoursePose poseAt(const Course& course, double time);

/// A world with the course that its formation is led along.
struct Scene {
    WorldDef world;
    Course course;         ///< Not used where far.
    double side = 0.0;     ///< Of the square formation [m].
    double seconds = 0.0;  ///< How long a run is worth while [s].
};

/// Adds the only group: its formation at a pose, its characters on free ground round `crowd`. Fails where
/// they find no room.
Status addCrowd(const SceneDef& def, const CoursePose& formation, Vec2 crowd, Scene& scene);
/// Where a crowd starts that follows a formation at this pose [m].
Vec2 behind(const CoursePose& formation);
/// Makes a crowd stay 1 to 3 m behind a formation that is dragged.
void letLag(Parameters& parameters);

/// Makes a scene. Fails with NotFound where the name or the city's map is not there.
Result<Scene> makeScene(const SceneDef& def);

}  // namespace muster::scale
