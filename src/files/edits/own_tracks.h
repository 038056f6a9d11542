// Where people were in each step of a take, for those who are shown at other times.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "muster/take.h"
#include "muster/world.h"

namespace muster {

/// Where somebody was at one moment of the recording.
struct TrackPoint {
    Vec2 position;  ///< [m]
    Vec2 velocity;  ///< [m/s]
    Vec2 heading;   ///< Unit vector.
};

/// Gathers the tracks of some people while a take is simulated.
class OwnTracks {
public:
    /// Of these people, by ids in ascending order.
    explicit OwnTracks(std::vector<std::uint32_t> people = {}) : people_(std::move(people)) {}

    /// Call before the first step and after each; steps that come again are passed over.
    void observe(const World& world);
    /// Where somebody was after that many steps, also between two; the nearest where it was not there then.
    /// False where nothing is known of it.
    bool at(std::uint32_t id, double step, TrackPoint& point) const;
    const std::vector<std::uint32_t>& people() const { return people_; }  ///< Whose tracks it gathers.

private:
    struct Track {
        std::uint32_t first = 0;
        std::vector<TrackPoint> points;
    };
    std::vector<std::uint32_t> people_;
    std::map<std::uint32_t, Track> tracks_;
};

/// Who has a clock of its own, in ascending order.
std::vector<std::uint32_t> peopleWithClocks(const std::vector<TakeEdit>& edits);
/// Everybody with an edit, in ascending order.
std::vector<std::uint32_t> editedPeople(const std::vector<TakeEdit>& edits);
/// Gathers the tracks that the take's own edits need up to that time of the take [s], by simulating it or
/// from its stored frames. Fails as replayTake().
Result<OwnTracks> gatherTracks(const Take& take, double until, std::int32_t threads, ReplayFrom from);

}  // namespace muster
