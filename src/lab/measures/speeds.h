// Speeds of persons, and classic means in an area.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lab/measures/region.h"
#include "lab/measures/trajectories.h"

namespace muster {

/// Treatment of the sightings near the first and the last one of a person, where the frames before or after
/// are missing.
enum class SpeedBorder : std::uint8_t {
    Adaptive,     ///< Takes as many frames on both sides as there are; no speed at the very first and last.
    SingleSided,  ///< Takes only the side with frames.
    Exclude,      ///< Gives no speed.
};

/// Definition of a speed: |x(t + n) - x(t - n)| / 2 n frames.
struct SpeedDef {
    std::int32_t frameStep = 5;  ///< n, 1 or more.
    SpeedBorder border = SpeedBorder::Adaptive;
    /// Speed along this direction, which may be negative; none for all of it.
    std::optional<Vec2> direction;
    double period = 0.0;  ///< Period of ground that is joined in x [m]; 0 for none.
};

/// One speed per sighting, in the order of all() [m/s]; NaN where there is none.
std::vector<double> personalSpeeds(const Trajectories& trajectories, const SpeedDef& def = {});

/// Per frame: persons in the area / area [1/m^2].
std::vector<double> classicDensity(const Trajectories& trajectories, const Region& area);
/// Per frame: mean speed of the persons in the area [m/s]; 0 where there is nobody (PedPy).
std::vector<double> meanSpeed(const Trajectories& trajectories, const Region& area,
                              const std::vector<double>& speeds);

}  // namespace muster
