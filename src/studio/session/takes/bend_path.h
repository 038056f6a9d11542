// Changes the path of a group or of a character in a take afterwards.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/take.h"
#include "studio/session/takes/take_paths.h"

namespace muster {

class Environment;

/// What is done to a path.
struct PathBend {
    GroupId group;                ///< Whose.
    std::uint32_t character = 0;  ///< Whose alone; 0 for the group's.
    std::uint32_t step = 0;       ///< Where it is taken hold of.
    Vec2 offset;                  ///< How far it is moved there [m].
    double seconds = 3.0;         ///< So long before and after it moves along, ever less [s].
};

/// The take with that path, to be simulated again: its marks are places for hashes that are not known yet,
/// and neither
/// events nor frames are left.
///
/// Of a group the fingers that move it go elsewhere around that moment, and the order that it carries out
/// leads through the new point, or ends there where it had arrived. A character is led along the new path
/// while it differs, round obstacles; others keep clear of it. Fails with NotFound where there is no such
/// path or nothing directs the group then, with InvalidArgument where a number is out of its range.
Result<Take> bendPath(const Take& take, const TakePaths& paths, const Environment& environment,
                      const PathBend& bend);

/// How much a path is moved so long after the moment at which it is taken hold of: 1 there, 0 from `seconds`
/// on, smooth between.
double bendWeight(double after, double seconds);

}  // namespace muster
