// Builds the frame message from the world.
#pragma once

#include <vector>

#include "muster/world.h"
#include "people/motion/shown_character.h"
#include "studio/session/frames/crowd_picture.h"
#include "studio/session/frames/places_encoder.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// Builds the part of a frame that all clients share, and keeps the history that some of its values need.
class FrameBuilder {
public:
    /// Starts with a new world.
    void restart();
    /// Must be called after every step.
    void observe(const World& world);
    /// Writes ids, groups, moving obstacles and statistics of the world's present state to `frame`. Those in
    /// `shown`, by ids, stand elsewhere.
    void build(const World& world, protocol::Frame& frame, std::span<const ShownCharacter> shown = {});
    /// All characters at the last build, without motion; MotionFrames adds it.
    CrowdPicture& crowd() { return crowd_; }
    const CrowdPicture& crowd() const { return crowd_; }  ///< The same, to read.
    /// The places of each group at the last build.
    const std::vector<PlacesPicture>& places() const { return places_; }
    /// Version of the last build's ids; it grows whenever the characters or their groups change.
    std::uint32_t idsVersion() const { return idsVersion_; }

private:
    void buildCharacters(const World& world, protocol::Frame& frame, std::span<const ShownCharacter> shown);
    double lagP95(const World& world);

    std::vector<std::uint32_t> swaps_;  // Swaps per step over the last steps, a ring buffer.
    std::uint64_t swapSum_ = 0;
    std::size_t observed_ = 0;        // Number of steps observed.
    std::vector<std::uint32_t> ids_;  // Ids at the last build.
    std::vector<std::uint16_t> groups_;
    std::vector<std::uint8_t> classes_;
    std::vector<std::uint8_t> radii_;
    std::uint32_t idsVersion_ = 0;
    CrowdPicture crowd_;
    std::vector<Vec2> positions_;  // Where people are shown, where some are elsewhere.
    std::vector<PlacesPicture> places_;
    std::vector<float> lags_;    // Working memory.
    double slowestStep_ = 0.0;   // Duration of the slowest step since the last frame [ms].
    bool stepsReported_ = true;  // True when a frame has reported slowestStep_.
};

/// The topology of a group's mesh.
protocol::GroupMesh buildGroupMesh(const World& world, std::size_t index);
/// Converts events for the page. Swaps are left out; frames hold their rate.
void appendEvents(const World& world, std::vector<protocol::EventFrame>& events);

}  // namespace muster
