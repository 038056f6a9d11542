// Delta encoding of the crowd for one client: the changes since the last frame that was sent to it.
#pragma once

#include <cstdint>
#include <vector>

#include "studio/session/frames/crowd_picture.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// Remembers what a client knows. The client receives every frame and in order, so each frame holds the
/// changes since the one before.
class CrowdEncoder {
public:
    /// Writes `picture` to `frame`. `restart` is true where the client knows none of these characters.
    void encode(const CrowdPicture& picture, bool restart, protocol::CrowdFrame& frame);

private:
    bool encodeSteps(const CrowdPicture& picture, protocol::CrowdFrame& frame) const;

    Vec2 corner_;  // Corner of the lattice that the client knows [m].
    double quantum_ = 0.0;
    std::vector<std::uint16_t> x_;
    std::vector<std::uint16_t> y_;
    std::vector<std::uint8_t> clip_;
};

}  // namespace muster
