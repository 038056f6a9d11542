// What one client is told of a group's places: how far each lies from its point of the mesh, where that
// changed.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/world.h"
#include "session/protocol.h"

namespace muster {

/// A group's places in whole numbers: the same for all clients.
struct PlacesPicture {
    std::vector<std::int16_t> offsets;  ///< x, y per place from its point of the mesh [cm].
    std::vector<std::uint8_t> unfit;    ///< A bit per place, the lowest first.

    void take(const World& world, std::size_t group);  ///< As they lie now.
};

/// Remembers what a client knows.
class PlacesEncoder {
public:
    /// The client has just been sent the group's mesh: every place is on its point, and fit.
    void restart();
    /// Writes what changed; in a large group at most a share of the places per frame, in turn.
    void encode(const PlacesPicture& picture, protocol::GroupFrame& frame);

private:
    std::vector<std::int16_t> offsets_;
    std::vector<std::uint8_t> unfit_;
    std::size_t turn_ = 0;  // Place that is looked at first.
};

}  // namespace muster
