// Delta encoding of a group's places for one client: the offsets of places from their mesh points, where they
// changed.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/world.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// The places of a group in whole numbers. They are the same for all clients.
struct PlacesPicture {
    std::vector<std::int16_t> offsets;  ///< x, y per place: offset from its mesh point [cm].
    std::vector<std::uint8_t> unfit;    ///< One bit per place, the lowest bit first; 1 for an unfit place.

    void take(const World& world, std::size_t group);  ///< Copies the present state of a group's places.
};

/// Remembers what a client knows of a group's places since the group's mesh was sent: at first it assumes
/// every place fit and on its mesh point.
class PlacesEncoder {
public:
    /// Writes the changes. In a large group a frame updates only a share of the places, in cyclic order.
    void encode(const PlacesPicture& picture, protocol::GroupFrame& frame);

private:
    std::vector<std::int16_t> offsets_;
    std::vector<std::uint8_t> unfit_;
    std::size_t next_ = 0;  // The place at which the next frame begins its search for changes.
};

}  // namespace muster
