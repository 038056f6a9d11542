// Speeds of persons, and classic means in an area.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lab/measures/region.h"
#include "lab/measures/trajectories.h"

namespace muster {

/// What is done near the first and the last sighting of a person, where the frames before or after are
/// missing.
enum class SpeedBorder : std::uint8_t {
    Adaptive,     ///< As many frames on both sides as there are; none at the very first and last.
    SingleSided,  ///< Only the side that is there.
    Exclude,      ///< No speed.
};

/// How speeds are measured: |x(t + n) - x(t - n)| / 2 n frames.
struct SpeedDef {
    std::int32_t frameStep = 5;  ///< n, 1 or more.
    SpeedBorder border = SpeedBorder::Adaptive;
    std::optional<Vec2>
        direction;        ///< Speed along this direction, which may be negative; none for all of it.
    double period = 0.0;  ///< Of ground that is joined in x [m]; 0 for none.
};

/// One speed per sighting, in the order of all() [m/s]; NaN where there is none.
std::vector<double> personalSpeeds(const Trajectories& trajectories, const SpeedDef& def = {});

/// Per frame: persons in the area / area [1/m^2].
std::vector<double> classicDensity(const Trajectories& trajectories, const Region& area);
/// Per frame: mean speed of those in the area [m/s]; 0 where there is nobody (PedPy).
std::vector<double> meanSpeed(const Trajectories& trajectories, const Region& area,
                              const std::vector<double>& speeds);

}  // namespace muster
