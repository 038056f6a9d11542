// What a session keeps: shared by the files that implement it.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/token_bucket.h"
#include "io/take/replayer.h"
#include "muster/session.h"
#include "session/crowd_encoder.h"
#include "session/frame_builder.h"
#include "session/motion_frames.h"
#include "session/pacer.h"
#include "session/places_encoder.h"
#include "session/protocol.h"
#include "session/take_log.h"
#include "session/touch_clock.h"

namespace muster {

/// A client as the session knows it.
struct SessionClient {
    explicit SessionClient(const SessionLimits& limits)
        : notices(limits.noticesPerSecond, limits.noticesPerSecond),
          touches(limits.touchesPerSecond, limits.touchesPerSecond) {}

    bool greeted = false;        ///< Its Hello came.
    bool steers = false;         ///< It has given commands to this world.
    std::uint32_t sequence = 0;  ///< Of its last command.
    TouchClock clock;
    TokenBucket notices;
    TokenBucket touches;
    std::vector<MessageBytes> outbox;  ///< Beside frames; bounded by what the client asks for.

    std::uint32_t frame = 0;        ///< Number of the last frame sent.
    bool awaitsAck = false;         ///< That frame has not been acknowledged.
    std::uint64_t sentState = 0;    ///< Session state that it showed; 0 for none.
    std::uint32_t sentScene = 0;    ///< Revision; 0 for none.
    std::uint32_t sentMotions = 0;  ///< Revision; 0 for none.
    std::uint32_t sentIds = 0;      ///< Version; 0 for none.
    double frameDue = 0.0;          ///< Real time of the next frame of a world that plays [s].
    CrowdEncoder crowd;             ///< What it knows of the characters.
    std::map<std::uint32_t, std::uint32_t> sentMeshes;  ///< Version by group.
    std::map<std::uint32_t, PlacesEncoder> places;      ///< What it knows of places, by group.
    std::vector<protocol::EventFrame> events;           ///< Since that frame.
    Attention attention;                                ///< Where it looks.
    double touchWaiting = 0.0;  ///< Newest page time among touches that wait for a step [s].
    double touchShown = 0.0;    ///< Newest page time among touches that a step has applied [s].

    protocol::OverlayKind overlay = protocol::OverlayKind::None;
    std::uint32_t overlayCharacter = 0;
    double overlayDue = 0.0;         ///< Real time of the next one [s].
    std::uint64_t overlayState = 0;  ///< Session state that the last one showed; 0 for none.
};

/// All of a session.
struct Session::Impl {
    explicit Impl(SessionDef sessionDef) : def(std::move(sessionDef)) {}

    // Worlds (session.cpp).
    Status begin(const std::string& worldName, const WorldDef& worldDef, std::shared_ptr<const Take> take);
    void beginMotion();
    void warnOfClips(SessionClient& client);
    void observeMotion();
    Status restart();
    Status demonstrate();
    /// The scenario carries touches that can be watched now.
    bool canDemonstrate() const { return !replay && !worldDef.gestures.empty() && def.loadGestures; }
    bool demonstrating() const { return world && world->stepCount() < demonstratedUntil; }
    void stepOnce();
    void replayEnded();
    void reportRejections();
    void warn();
    void touchState() { ++state; }
    /// Somebody waits for the next step: it may come up to one step time early, at once where it can.
    bool eager() const { return waitingCommands > 0; }

    // Recording (session.cpp).
    void setRecording(bool on, std::uint32_t client);
    void stopRecording();
    void reportLostFile();

    // Clients (session_clients.cpp).
    void greet(std::uint32_t id, SessionClient& client);
    void notice(SessionClient& client, protocol::NoticeLevel level, const std::string& code,
                const std::string& text, std::optional<Vec2> place = std::nullopt);
    void noticeAll(protocol::NoticeLevel level, const std::string& code, const std::string& text);
    void sendScene(SessionClient& client);
    void buildFrame();
    void sendFrame(SessionClient& client);
    void sendOverlay(SessionClient& client);

    // Messages (session_messages.cpp).
    Status handle(std::uint32_t id, SessionClient& client, const protocol::ClientMessage& message);
    Status submit(std::uint32_t id, SessionClient& client, std::vector<CommandBody>& bodies);

    SessionDef def;
    std::map<std::uint32_t, SessionClient> clients;  // By number.
    std::uint32_t lastClient = kLastDemonstrator;

    std::string name;  // Of the scenario.
    WorldDef worldDef;
    std::string warning;  // What is likely a mistake in it; empty for nothing.
    // Why its people move by Muster's own clips, where they should by others.
    Status clipsRead;
    std::optional<World> world;
    std::shared_ptr<const Take> replayedTake;  // Null unless a take is replayed.
    std::optional<Replayer> replay;            // Of that take.
    std::uint32_t demonstratedUntil = 0;       // The step after the demonstration's last touch; 0 for none.
    TakeLog log;
    bool toldFull = false;
    std::size_t waitingCommands = 0;  // Submitted since the last step.

    double realTime = 0.0;  // Passed since the session began [s].
    Pacer pacer;
    bool playing = true;
    std::int32_t singleSteps = 0;  // Asked for while paused.
    double speed = 1.0;
    double recordedFrom = -1.0;  // World time [s]; negative: not recording.

    std::uint64_t state = 1;  // Grows with every step and every change that a frame shows.
    std::uint32_t sceneRevision = 0;
    std::uint64_t signature = 0;  // Of the scene with that revision.
    MessageBytes sceneBytes;      // The Scene message with that revision.
    FrameBuilder frames;
    MotionFrames motion;
    std::vector<Attention> attentions;             // Of all clients; working memory.
    protocol::Frame frame;                         // Shared by clients; built when first asked for.
    std::uint64_t frameState = 0;                  // State that it shows.
    std::vector<protocol::EventFrame> stepEvents;  // Working memory.

    void refreshScene();
};

}  // namespace muster
