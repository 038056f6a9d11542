// Crossings of a line by persons, with time and direction; N-t curves, flows and times of evacuation.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lab/measures/trajectories.h"

namespace muster {

/// A measurement line.
struct Line {
    Vec2 a;  ///< One end [m].
    Vec2 b;  ///< The other end [m].
};

/// One crossing of a line.
struct Crossing {
    std::uint32_t id = 0;    ///< Id of the person.
    std::int32_t frame = 0;  ///< Number of the first frame after the crossing, as PedPy counts.
    double time = 0.0;       ///< Time of the crossing, by linear interpolation between the frames [s].
    int direction = 0;       ///< 1: to the right of the line, as seen from `a` to `b`; -1: to its left.
    Vec2 point;              ///< Point of the crossing [m].
};

/// All crossings by time, those at the same time by id. A movement that ends on the line does not cross it;
/// one that begins on it does. A person without a sighting in the frame before does not cross.
std::vector<Crossing> crossings(const Trajectories& trajectories, Line line);
/// The first crossing of each person; `direction` 0 takes both.
std::vector<Crossing> firstCrossings(std::span<const Crossing> all, int direction = 0);

/// N-t curve: the number of persons that have crossed by each frame, from the first frame.
std::vector<std::int32_t> crossedByFrame(const Trajectories& trajectories, std::span<const Crossing> crossed);

/// The flow in one stretch of time.
struct FlowSample {
    double from = 0.0;  ///< Begin of the stretch [s].
    double to = 0.0;    ///< End of the stretch [s].
    double flow = 0.0;  ///< Flow [1/s].
    /// Mean speed of the persons that cross in the stretch [m/s]; NaN where there are no speeds.
    double speed = 0.0;
};
/// Flows over stretches of `frames` frames from the first crossing on. A stretch lasts up to the frame after
/// the last crossing in it, so that no stretch is cut within the gap between two crossings (PedPy). `speeds`:
/// one per sighting, may be empty.
std::vector<FlowSample> flowSamples(const Trajectories& trajectories, std::span<const Crossing> crossed,
                                    std::int32_t frames, std::span<const double> speeds = {});

/// Flow between the crossings number `first` and `last`, counted from 0: (last - first) / time between them
/// [1/s]; NaN where there are not so many crossings or no time passes.
double flowBetween(std::span<const Crossing> crossed, std::size_t first, std::size_t last);
/// Flow from the first to the last crossing [1/s]; NaN where no time passes.
double meanFlow(std::span<const Crossing> crossed);

/// Time at which each person is seen last [s], ascending: an evacuation curve where exits take persons out.
std::vector<double> lastSeen(const Trajectories& trajectories);

}  // namespace muster
