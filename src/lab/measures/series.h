// Series of values in time: means, steady states, first times of a value; headways in single file.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "lab/measures/trajectories.h"

namespace muster {

/// Mean and standard deviation of some values; NaN of none.
struct MeanAndDeviation {
    double mean = 0.0;
    double deviation = 0.0;
};
MeanAndDeviation meanOf(std::span<const double> values);

/// A steady part of a series, [begin, end).
struct SteadyState {
    std::size_t begin = 0;
    std::size_t end = 0;
    double mean = 0.0;  ///< Mean of the part; NaN where there is no steady part.
};
/// The part with the mean that is known best: values are cut off at the beginning, then at the end, and again
/// until nothing changes, where the standard error of the mean of the rest, deviation / sqrt(count), is
/// least; at most a half each time (the marginal standard error rule, White 1997).
SteadyState steadyState(std::span<const double> values);

/// Index of the first value that is at least `value`; the number of values where none is.
std::size_t firstReaching(std::span<const double> values, double value);
/// Moving means over `width` values, an odd number, fewer at both ends.
std::vector<double> smoothed(std::span<const double> values, std::size_t width);

/// The next person ahead in single file, and the distance to it.
struct FileHeadway {
    std::size_t sighting = 0;  ///< Index into all().
    std::uint32_t ahead = 0;   ///< Id of the person ahead.
    double distance = 0.0;     ///< Distance between both persons along the file [m].
};
/// For each person in each frame the next one ahead in the direction +x, or -x where `backwards`; on ground
/// joined in x, where `period` is above 0 [m], the next one across the seam too.
std::vector<FileHeadway> headways(const Trajectories& trajectories, double period = 0.0,
                                  bool backwards = false);

}  // namespace muster
