// Distance, duration and speed of a motion, as in table 1 of the paper.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "muster/clip.h"

namespace muster {

inline constexpr double kUsualRun = 2.6;     ///< Speed of running without a clip "run" [m/s].
inline constexpr double kLeastRatio = 0.02;  ///< Least speed relative to running, even for standing.

/// Figures of one motion.
struct MotionFacts {
    std::size_t frames = 0;         ///< Number of frames in the file.
    double rate = 0.0;              ///< Frames per second.
    double duration = 0.0;          ///< Duration of one play [s].
    double length = 0.0;            ///< Net distance of one play, for the size of the file's body [m].
    double speed = 0.0;             ///< length / duration [m/s].
    bool cyclic = false;            ///< True if it repeats.
    std::vector<Contact> contacts;  ///< Contacts of hands, feet and knees; empty without a human skeleton.
};

/// Figures of a clip.
MotionFacts factsOf(const Clip& clip);
/// Figures of a file's motion, from the path of its root.
MotionFacts factsOf(const BvhMotion& motion);

/// Speed relative to running at `runSpeed` [m/s] > 0, at least kLeastRatio.
double speedRatio(double speed, double runSpeed);

/// Net distance and duration of the root's path, which the simulation reads from a file. The root is the
/// first joint whose position changes; in files of Muster's own skeleton, the first joint.
struct RootPath {
    double length = 0.0;    ///< Net distance [m].
    double duration = 0.0;  ///< Duration [s].
};
RootPath rootPath(const BvhMotion& motion);  ///< The path of a motion's root.

}  // namespace muster
