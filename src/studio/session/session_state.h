// The session's state, shared by the files that implement it.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/token_bucket.h"
#include "muster/session.h"
#include "studio/session/frames/frame_sender.h"
#include "studio/session/frames/overlay.h"
#include "studio/session/frames/stage_means.h"
#include "studio/session/frames/standing_watch.h"
#include "studio/session/history/place_editor.h"
#include "studio/session/inbox/chosen_scheme.h"
#include "studio/session/inbox/directors.h"
#include "studio/session/inbox/pacer.h"
#include "studio/session/inbox/protocol.h"
#include "studio/session/inbox/touch_clock.h"
#include "studio/session/shared/shared_world.h"
#include "studio/session/shared/world_ask.h"
#include "studio/session/takes/handover.h"
#include "studio/session/takes/take_log.h"
#include "studio/session/takes/take_player.h"
#include "studio/session/takes/take_versions.h"
#include "studio/session/words/spoken.h"

namespace muster {

/// A client of the session.
struct SessionClient {
    explicit SessionClient(const SessionLimits& limits)
        : notices(limits.noticesPerSecond, limits.noticesPerSecond),
          touches(limits.touchesPerSecond, limits.touchesPerSecond),
          forecasts(limits.forecastsPerSecond, limits.forecastsPerSecond) {}

    std::uint32_t id = 0;        ///< As connect() gave it.
    bool greeted = false;        ///< True after its Hello message.
    std::uint32_t number = 0;    ///< Its number in commands; its id, until a take is taken up.
    bool steers = false;         ///< True after it has given commands to this world.
    std::uint32_t sequence = 0;  ///< Sequence number of its last command.
    TouchClock clock;
    TokenBucket notices;
    TokenBucket touches;
    TokenBucket forecasts;
    /// Messages other than frames. The client's requests bound their number.
    std::vector<MessageBytes> outbox;

    FrameSender frames;                        ///< What the client knows of the world.
    std::uint64_t sentState = 0;               ///< Session state that the last frame showed; 0 for none.
    std::uint32_t sentTake = 0;                ///< Revision of the last TakeState sent; 0 for none.
    std::uint32_t sentReady = 0;               ///< Steps in the last TakeReady sent.
    double readyDue = 0.0;                     ///< Real time at which the next TakeReady is due [s].
    std::optional<protocol::AskPath> path;     ///< The path of the take that it waits for.
    bool watchesTracks = false;                ///< It wants to know the tracks of the take.
    std::uint32_t sentTracks = 0;              ///< Number of the take whose tracks it has; 0 for none.
    std::uint32_t sentDirectors = 0;           ///< Revision of the directors sent; 0 for none.
    std::uint32_t sentShared = 0;              ///< Revision of the SharedWorld sent; 0 for none.
    std::uint32_t sentEdits = 0;               ///< Revision of the last TakeEdits sent; 0 for none.
    std::uint32_t sentHistory = 0;             ///< Revision of the edits of the last EditHistory.
    double frameDue = 0.0;                     ///< Real time when the next frame is due while playing [s].
    std::vector<protocol::EventFrame> events;  ///< Events since the last frame.
    Attention attention;                       ///< The point that the client looks at.
    ChosenScheme scheme;                       ///< The control scheme that judges its inputs.
    double touchWaiting = 0.0;                 ///< Newest page time among touches that wait for a step [s].
    double touchShown = 0.0;  ///< Newest page time among touches that a step has applied [s].

    protocol::OverlayKind overlay = protocol::OverlayKind::None;
    std::uint32_t overlayCharacter = 0;
    double overlayDue = 0.0;         ///< Real time at which the next overlay is due [s].
    std::uint64_t overlayState = 0;  ///< Session state that the last overlay showed; 0 for none.
    ReachVersion sentReach;          ///< What the last overlay of reach was made from.

    bool watchesStages = false;    ///< It wants to know how long the stages of steps take.
    std::uint32_t sentStages = 0;  ///< Revision of the last StageTimes that it has or does not need.
};

/// The complete state of a session.
struct Session::Impl {
    explicit Impl(SessionDef sessionDef) : def(std::move(sessionDef)) {}

    // Worlds (session.cpp).
    Status begin(const std::string& worldName, const WorldDef& worldDef,
                 std::unique_ptr<TakePlayer> taken = nullptr);
    void beginWith(World begun, const std::string& worldName, const WorldDef& worldDef,
                   std::unique_ptr<TakePlayer> taken = nullptr);
    void forgetClients();
    void beginMotion();
    void warnOfClips(SessionClient& client);
    void observeMotion();
    Status restart();
    Status beginAgain();
    Status demonstrate();
    /// True where the scenario carries touches that can be watched now.
    bool canDemonstrate() const { return !player && !worldDef.gestures.empty() && def.loadGestures; }
    bool demonstrating() const { return world && world->stepCount() < demonstratedUntil; }
    void stepOnce();
    void stepped();
    void stepWorld();
    void queueEvents();
    void observeStages();
    void reportRejections();
    void noticeEvents();
    void warn();
    void touchState() { ++state; }
    /// True where a client waits for the next step. That step may come up to one time step early.
    bool eager() const { return waitingCommands > 0 || inputsWait; }
    /// Seconds of the world per second of real time.
    double pace() const { return player ? speed * player->speed(*world) : speed; }

    // Recording (session_takes.cpp).
    void setRecording(bool on, SessionClient* client);
    /// Records from that step on, at most the present one.
    void beginRecording(std::uint32_t from, const std::string& title, SessionClient* client);
    void beginFile(SessionClient* client);
    void stopRecording(bool dropEmpty = false);
    void reportLostFile();

    // Replays (session_takes.cpp).
    Status openTake(std::span<const std::uint8_t> bytes, const std::string& sourceName,
                    const std::string& fileName);
    void stepReplay();
    void seek();
    void replayEnded();
    void replayFailed(const Status& status);
    void showStoredFrames();
    Status takeAgain(bool keep, SessionClient& client);
    void renumberClients(const Take& take);
    /// Fingers of clients above `after` that are down at this step in the take let go.
    void liftRecorded(const Take& take, std::uint32_t step, std::uint32_t after = 0);
    void submitLayer();
    Status editTake(const protocol::EditTake& message);
    std::string titleAgain(const TakePlayer& taken) const;
    void touchTake() { ++takeRevision, touchState(); }
    void sendTake(SessionClient& client);

    // Handover (session_handover.cpp).
    Status takeOverWorld(const Handover& handover);

    // Paths of the open take (session_paths.cpp).
    Status askPath(SessionClient& client, const protocol::AskPath& message);
    Status changePath(const protocol::BendPath& message);
    void sendPath(SessionClient& client);
    Status openChanged(Take changed);
    std::string keepFile();
    void keepChanged();

    // Tracks of the open take (session_tracks.cpp).
    Status changeTracks(const protocol::EditTrack& message);
    Status stepVersion(bool redo);
    TakeVersion present() const;
    void sendTracks(SessionClient& client);
    std::string keepTracks();
    /// The open take's file with all that is said about it.
    std::vector<std::uint8_t> openBytes() const;
    void tellRefused(std::size_t before);

    // Edits of people in the open take (session_edits.cpp).
    Status editPeople(const protocol::EditPeople& message);
    void showEdits(std::vector<TakeEdit> edits);
    void touchEdits();
    Status keepEdits();
    Status undoTakeEdit(bool redo);
    void sendEdits(SessionClient& client);
    const std::vector<protocol::EditFinding>& editFindings();
    /// Who is shown otherwise than the world has them.
    std::span<const ShownCharacter> shown() {
        return player ? player->shown(*world) : std::span<const ShownCharacter>();
    }

    // The world that directors share (session_shared.cpp).
    std::size_t greetedClients() const;
    std::uint32_t numberOf(std::uint32_t id) const;  ///< 0 for who is not there.
    SessionClient* clientOf(std::uint32_t number);   ///< Null for who is not there.
    std::uint32_t idOf(std::uint32_t number) const;  ///< 0 for who is not there.
    void pause(const SessionClient& client);
    void resume();
    Status build(SessionClient& client, bool on);
    void endBuilding(std::uint32_t id);
    Status askOthers(SessionClient& client, const protocol::AskOthers& message);
    Status answerAsk(SessionClient& client, const protocol::AnswerAsk& message);
    void closeAsk();
    void settleAsk();
    /// A director begins another world, by `work`: where others direct, one can go back to this one.
    Status beginFor(std::uint32_t id, protocol::WorldChange change, const std::function<Status()>& work);
    void park(bool forTake);
    Status goBack(std::uint32_t id);
    Status leaveTake(std::uint32_t id, bool records = false);
    Status reopen(const ParkedWorld& back);
    void goOnAs(const ParkedWorld& back);
    void bringBack(ParkedWorld& back);
    void sendShared(SessionClient& client);
    Status keepPlace(SessionClient& client, const protocol::KeepPlace& message);
    void keepEntry(const ScenarioEntry& entry);
    std::vector<protocol::ScenarioInfo> scenarioInfos() const;

    // Clients (session_clients.cpp).
    void greet(SessionClient& client, const std::string& called);
    void notice(SessionClient& client, protocol::NoticeLevel level, const std::string& code,
                const std::string& text, std::optional<Vec2> place = std::nullopt);
    void noticeAll(protocol::NoticeLevel level, const std::string& code, const std::string& text,
                   std::optional<Vec2> place = std::nullopt);
    void sendDirectors(SessionClient& client);
    void buildFrame();
    void sendFrame(SessionClient& client);
    void sendOverlay(SessionClient& client);
    void sendStages(SessionClient& client);

    // The place (session_place.cpp).
    Status edit(SessionClient& client, const protocol::Edit& message);
    Status undoEdit(SessionClient& client, bool redo);
    Status act(SessionClient& client, std::vector<CommandBody> bodies);
    void submitEdits();
    void editsCarriedOut();
    void sendHistory(SessionClient& client);
    /// The place as a definition: what the world began from, with all edits since.
    WorldDef placeNow() const;

    // Sentences (words/session_words.cpp).
    Result<protocol::Said> say(SessionClient& client, const protocol::Say& message);
    Status carryOut(SessionClient& client, Understood understood, const std::string& label);
    void submitSpoken();

    // Messages (session_messages.cpp).
    Status handle(SessionClient& client, const protocol::ClientMessage& message);
    /// `steers`: a world that waits for somebody to steer goes on.
    Status submit(SessionClient& client, std::vector<CommandBody>& bodies, bool steers = true);
    /// Gives the next step the commands of all control schemes.
    void driveSchemes();
    /// Somebody steers: a world that waits for that goes on.
    void handCame();

    SessionDef def;
    std::map<std::uint32_t, SessionClient> clients;  // By client number.
    std::uint32_t lastClient = kLastDemonstrator;
    Directors directors;
    SharedWorld shared;
    WorldAsk ask;
    std::optional<Leaving> leaving;      // While somebody begins another world.
    std::optional<ParkedWorld> parked;   // The world before.
    std::optional<ParkedWorld> beneath;  // The world from which the open take was opened.
    PlaceEditor editor;
    std::vector<PlaceEditor::Given> givenEdits;  // Edits of the step that is made.
    std::vector<SpokenRest> spoken;              // What waits for parts that the next step makes.
    std::uint32_t worldNumber = 0;               // Worlds that have begun.

    std::string name;  // The scenario's name.
    WorldDef worldDef;
    std::string warning;  // The warnings about the scenario; empty for none.
    // The error that made the characters play Muster's own clips instead of the scenario's.
    Status clipsRead;
    std::optional<World> world;
    std::unique_ptr<TakePlayer> player;    // Of the take that is open; null otherwise.
    std::vector<std::uint8_t> takenBytes;  // Its bytes.
    std::uint32_t takeNumber = 0;          // Takes that were opened.
    TakeVersions versions;                 // Of the open take, before and after changes of its blocks.
    bool tracksChange = false;             // It comes from such a change, and waits for its end.
    std::size_t refusedBefore = 0;         // Commands that the take before refused.
    bool endSaid = false;                  // It was said that it ends.
    std::uint32_t editsRevision = 0;       // It grows with every change of edits and of what is found.
    std::uint32_t troublesFor = 0;         // The revision that `troubles` is about.
    std::vector<protocol::EditFinding> troubles;
    std::uint32_t takeRevision = 1;  // It grows with every change of what TakeState tells.
    // Recorded commands beneath a take that is directed again, by step, and the next of them.
    std::vector<Command> layer;
    std::size_t nextOfLayer = 0;
    bool waitsForHand = false;  // True until somebody steers, which then plays.
    // The step after the last touch of the demonstration; 0 for no demonstration.
    std::uint32_t demonstratedUntil = 0;
    TakeLog log;
    bool fullReported = false;
    std::size_t waitingCommands = 0;  // Commands submitted since the last step.
    bool inputsWait = false;          // Inputs came since the last step that a control scheme judges.

    double realTime = 0.0;  // Real time since the session began [s].
    Pacer pacer;
    bool playing = true;
    std::int32_t singleSteps = 0;  // Single steps requested while paused.
    double speed = 1.0;
    // World time at which the recording began [s]; negative while not recording.
    double recordedFrom = -1.0;
    TakeAbout recordedAbout;           // What is said about the recording that runs or ran in this world.
    bool recorded = false;             // True after a recording began in this world.
    std::size_t recordedCommands = 0;  // Commands in the log when it began.

    std::uint64_t state = 1;  // It grows with every step and every change that a frame shows.
    std::uint32_t sceneRevision = 0;
    std::uint64_t signature = 0;  // Signature of the scene with that revision.
    MessageBytes sceneBytes;      // The Scene message with that revision.
    FrameBuilder frames;
    StandingWatch standings;
    StageMeans stages;  // Of steps since somebody watches.
    MotionFrames motion;
    std::vector<Attention> attentions;             // Attention of all clients; working memory.
    protocol::Frame frame;                         // The frame that all clients share; built on demand.
    std::uint64_t frameState = 0;                  // Session state that `frame` shows.
    std::vector<protocol::EventFrame> stepEvents;  // Working memory.

    void refreshScene();
};

}  // namespace muster
