// Trajectories: positions of persons, frame by frame.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// Stands for a value that could not be measured.
inline constexpr double kUnmeasured = std::numeric_limits<double>::quiet_NaN();

/// Position of one person in one frame.
struct Sighting {
    std::int32_t frame = 0;  ///< Number of the frame.
    std::uint32_t id = 0;    ///< Id of the person.
    Vec2 position;           ///< Position [m].
};

/// All sightings of some persons at a constant frame rate, with access by frame and by person.
class Trajectories {
public:
    /// Sorts the sightings. Fails with InvalidArgument where the frame rate is not above 0, a position is not
    /// finite, or one person is in one frame twice.
    static Result<Trajectories> create(double frameRate, std::vector<Sighting> sightings);

    double frameRate() const { return frameRate_; }  ///< Frames per second.
    /// All sightings, by frame and, within a frame, by id.
    std::span<const Sighting> all() const { return sightings_; }
    /// Number of frames from the first to the last, frames without anybody included; 0 where there is nobody.
    std::int32_t frameCount() const;
    /// Number of the first frame; 0 where there is nobody.
    std::int32_t firstFrame() const { return sightings_.empty() ? 0 : sightings_.front().frame; }
    /// Everybody in a frame, by id; `index` counts from the first frame.
    std::span<const Sighting> frame(std::int32_t index) const;
    /// Time of a frame [s]: its number over the frame rate.
    double timeOf(std::int32_t frame) const { return frame / frameRate_; }
    /// The ids of all persons, ascending.
    std::span<const std::uint32_t> persons() const { return persons_; }
    /// The sightings of a person, an index into persons(): indices into all(), by frame.
    std::span<const std::int32_t> ofPerson(std::size_t person) const;

private:
    double frameRate_ = 1.0;
    std::vector<Sighting> sightings_;
    std::vector<std::int32_t> frameEnd_;  // By frame: the end of its range in sightings_.
    std::vector<std::uint32_t> persons_;
    std::vector<std::int32_t> personEnd_;  // By person: the end of its range in byPerson_.
    std::vector<std::int32_t> byPerson_;
};

/// Persons on ground that is joined at two sides, seen on both sides of the seam: a person within `reach` [m]
/// of one side, x = `left` or `left` + `period`, is also at the other, under its id plus `imageId`. So
/// measures of the ground between need not know of the seam.
Result<Trajectories> withImages(const Trajectories& ring, double left, double period, double reach,
                                std::uint32_t imageId = 1u << 30);

}  // namespace muster
