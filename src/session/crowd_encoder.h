// What one client is told of the crowd: what differs from the frame it was sent last.
#pragma once

#include <cstdint>
#include <vector>

#include "session/crowd_picture.h"
#include "session/protocol.h"

namespace muster {

/// Remembers what a client knows. Frames reach it all and in order, so each tells the steps since the one
/// before.
class CrowdEncoder {
public:
    /// Writes `picture` to `frame`; `anew` where the client knows none of these characters.
    void encode(const CrowdPicture& picture, bool anew, protocol::CrowdFrame& frame);

private:
    bool encodeSteps(const CrowdPicture& picture, protocol::CrowdFrame& frame) const;

    Vec2 corner_;  // Of the lattice that the client knows.
    double quantum_ = 0.0;
    std::vector<std::uint16_t> x_;
    std::vector<std::uint16_t> y_;
    std::vector<std::uint8_t> clip_;
};

}  // namespace muster
