// What a motion covers, and how fast: the paper's table 1 for any clip.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "muster/clip.h"

namespace muster {

inline constexpr double kUsualRun = 2.6;     ///< Speed of running where no clip of it is at hand [m/s].
inline constexpr double kLeastRatio = 0.02;  ///< To running: no clip, not even of standing, counts as slower.

/// Figures of one motion.
struct MotionFacts {
    std::size_t frames = 0;  ///< As in the file.
    double rate = 0.0;       ///< Frames a second.
    double duration = 0.0;   ///< Of one play [s].
    double length = 0.0;     ///< Net ground covered by one play, at the size of the file's own body [m].
    double speed = 0.0;      ///< length / duration [m/s].
    bool cyclic = false;     ///< It repeats.
    std::vector<Contact> contacts;  ///< Of hands, feet and knees; empty where the skeleton is not a person's.
};

/// Figures of a clip.
MotionFacts factsOf(const Clip& clip);
/// Figures of a file's motion, from the path of its root.
MotionFacts factsOf(const BvhMotion& motion);

/// Speed relative to running at `runSpeed` [m/s] > 0, at least kLeastRatio.
double speedRatio(double speed, double runSpeed);

/// What simulation reads of a file: how far its root goes. The root is the first joint that changes its
/// place; of files of Muster's own skeleton, the first joint.
struct RootPath {
    double length = 0.0;    ///< Net ground covered [m].
    double duration = 0.0;  ///< [s]
};
RootPath rootPath(const BvhMotion& motion);  ///< Of that motion.

}  // namespace muster
