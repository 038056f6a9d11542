// The world as a frame.
#pragma once

#include <vector>

#include "muster/world.h"
#include "session/crowd_picture.h"
#include "session/places_encoder.h"
#include "session/protocol.h"

namespace muster {

/// Builds what is the same for all clients, and remembers what lies further back than one step.
class FrameBuilder {
public:
    /// A new world.
    void restart();
    /// Call after every step.
    void observe(const World& world);
    /// Writes ids, groups, moving things and figures of the world as it stands to `frame`.
    void build(const World& world, protocol::Frame& frame);
    /// Everybody's places at the last build; motion adds what they play.
    CrowdPicture& crowd() { return crowd_; }
    /// Places of each group at the last build.
    const std::vector<PlacesPicture>& places() const { return places_; }
    /// Grows whenever the characters or their groups change; of the last build.
    std::uint32_t idsVersion() const { return idsVersion_; }

private:
    void buildCharacters(const World& world, protocol::Frame& frame);
    double lagP95(const World& world);

    std::vector<std::uint32_t> swaps_;  // Of the last steps, a ring.
    std::uint64_t swapSum_ = 0;
    std::size_t observed_ = 0;        // Steps.
    std::vector<std::uint32_t> ids_;  // Of the last build.
    std::vector<std::uint8_t> groups_;
    std::uint32_t idsVersion_ = 0;
    CrowdPicture crowd_;
    std::vector<PlacesPicture> places_;
    std::vector<float> lags_;   // Working memory.
    double slowestStep_ = 0.0;  // Of the steps that the next frame tells of, or the last told of [ms].
    bool stepsTold_ = true;     // A frame has told of them.
};

/// Topology of a group's mesh.
protocol::GroupMesh buildGroupMesh(const World& world, std::size_t index);
/// Events as the page gets them: all but swaps, whose rate frames tell.
void appendEvents(const World& world, std::vector<protocol::EventFrame>& events);

}  // namespace muster
