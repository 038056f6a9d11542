// What one client knows of the world that it is shown, and the messages that tell it the rest.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "muster/session.h"
#include "studio/session/frames/crowd_encoder.h"
#include "studio/session/frames/frame_builder.h"
#include "studio/session/frames/motion_frames.h"
#include "studio/session/frames/places_encoder.h"

namespace muster {

/// A world as it is shown to all clients. `frame` must be built.
struct WorldPicture {
    const World& world;
    const FrameBuilder& frames;
    const MotionFrames& motion;
    std::uint32_t sceneRevision = 0;  ///< Of the scene; it grows.
    const MessageBytes& scene;        ///< The Scene message with that revision.
    protocol::Frame& frame;           ///< What all clients share; written to while it is sent.
};

/// Sends frames to one client: one at a time, until it is acknowledged, and before it all that it refers to.
class FrameSender {
public:
    /// A new world began, or the world is at another moment: its characters and meshes are not known.
    void restart();
    /// True until the last frame is acknowledged.
    bool waits() const { return awaitsAck_; }
    /// Takes an acknowledgement. Fails for a frame that was never sent.
    Status acknowledge(std::uint32_t number);
    /// Appends the next frame. `echo`: newest page clock of its touches; `events` are moved into it.
    void send(const WorldPicture& picture, double echo, std::vector<protocol::EventFrame>& events,
              std::vector<MessageBytes>& messages);

private:
    // A group as the client knows it, since its mesh was sent.
    struct SentGroup {
        std::uint32_t mesh = 0;  // Version of its mesh.
        PlacesEncoder places;
        std::optional<std::vector<QueuedOrder>> queue;  // None before the first frame.
        std::vector<std::uint32_t> standings;           // Empty before the first frame.
    };

    void sendScene(const WorldPicture& picture, std::vector<MessageBytes>& messages);
    void encodeGroups(const WorldPicture& picture);
    void restoreGroups(protocol::Frame& frame) const;

    std::uint32_t frame_ = 0;                    // Number of the last frame sent.
    bool awaitsAck_ = false;                     // True while that frame is not acknowledged.
    std::uint32_t sentScene_ = 0;                // Revision of the last scene sent; 0 for none.
    std::uint32_t sentMotions_ = 0;              // Revision of the last motions sent; 0 for none.
    std::uint32_t sentIds_ = 0;                  // Version of the last ids sent; 0 for none.
    CrowdEncoder crowd_;                         // The characters as the client knows them.
    std::map<std::uint32_t, SentGroup> groups_;  // What the client knows of each group, by its id.
};

}  // namespace muster
