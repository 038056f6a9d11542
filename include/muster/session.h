// One world with its clients: messages in, messages out (docs/protocol.md).
//
// No sockets, threads or clocks: the studio's server hosts it, and a WebAssembly worker can.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "muster/clip.h"
#include "muster/status.h"
#include "muster/take.h"
#include "muster/world.h"

namespace muster {

/// Clients up to this number are those of gestures: a demonstration's touches keep their numbers, so that it
/// gives the same hashes as a run of its gestures. Who connects gets a higher one.
inline constexpr std::uint32_t kLastDemonstrator = 1000;

/// Limits of requests by clients. A request beyond a limit gets a Notice and changes nothing.
struct SessionLimits {
    /// Touch events of one client per second on average, and the largest number at once.
    double touchesPerSecond = 5000.0;
    std::size_t touchesPerMessage = 1024;     ///< Events of one Touches message.
    std::size_t pointsPerControl = 64;        ///< Points of one AddControl message.
    std::size_t waitingCommands = 20000;      ///< Commands queued for one step; only reached while paused.
    std::int32_t charactersPerGroup = 20000;  ///< Characters that a command may ask for.
    std::size_t commandsPerMessage = 256;     ///< Commands of one message.
    std::size_t commandBytes = std::size_t{1} << 18;  ///< Commands of one message.
    std::size_t forecastsPerMessage = 16;             ///< Orders of one AskForecasts message.
    double forecastsPerSecond = 60.0;                 ///< Forecasts to one client.
    std::size_t takeBytes = std::size_t{64} << 20;  ///< Size of the log since the world began; it ends there.
    std::size_t openTakeBytes = std::size_t{64} << 20;  ///< Size of a take to open.
    std::size_t wholePoses = 500;                       ///< Whole poses that one client gets.
    double noticesPerSecond = 5.0;                      ///< Notices to one client; others are dropped.
    double overlaysPerSecond = 5.0;                     ///< Overlays to one client.
};

/// A scenario that clients may load.
struct ScenarioEntry {
    std::string name;              ///< Name in LoadScenario messages.
    std::string title;             ///< Title for display.
    std::string description;       ///< One or two sentences.
    std::uint32_t characters = 0;  ///< Number of characters in all groups.
};

/// Storage of a recording while it runs.
class TakeSink {
public:
    virtual ~TakeSink() = default;
    /// Appends bytes so that they outlive the process.
    virtual Status append(std::span<const std::uint8_t> bytes) = 0;
    /// Ends the recording.
    virtual Status finish() = 0;
    /// Ends it and keeps nothing.
    virtual Status discard() { return finish(); }
    /// Name of the file on the shelf; empty where it is on none.
    virtual std::string name() const { return {}; }
};

/// Definition of a session.
struct SessionDef {
    std::string version;                   ///< Version that is sent to clients.
    std::vector<ScenarioEntry> scenarios;  ///< Scenarios in the order of display.
    /// Reads one of them. Null where there is nothing to load from.
    std::function<Result<WorldDef>(const std::string& name)> loadScenario;
    /// Reads the touches that a scenario of that name and definition carries. Null where there are none to
    /// watch.
    std::function<Result<std::vector<Command>>(const std::string& name, const WorldDef& def)> loadGestures;
    /// The clips that characters of a scenario of that name and definition move by. Null: Muster's own.
    std::function<Result<ClipLibrary>(const std::string& name, const WorldDef& def)> loadClips;
    /// Begins a file for a recording of that scenario. Null keeps recordings in memory only.
    std::function<Result<std::unique_ptr<TakeSink>>(const std::string& name)> openSink;
    /// Keeps what is said about a take with its file on the shelf, by its name. Null where there is no shelf.
    std::function<Status(const std::string& name, const TakeAbout& about)> keepAbout;
    /// Puts other bytes in the place of a take on the shelf. Null where there is no shelf.
    std::function<Status(const std::string& name, std::span<const std::uint8_t> bytes)> replaceTake;
    /// Titles of all takes on the shelf. Null where there is no shelf.
    std::function<std::vector<std::string>()> takeTitles;
    /// Keeps a place by its name for good, where clients can load it from then on. Null: there is no room.
    std::function<Result<ScenarioEntry>(const WorldDef& place)> keepScenario;
    /// Called with the name of the scenario that is shown from now on. Null: nobody wants to know.
    std::function<void(const std::string& name)> opened;
    std::int32_t threads = 1;  ///< Threads of the world, as for ThreadPool.
    SessionLimits limits;      ///< Limits of requests by clients.
};

/// Bytes of one message.
using MessageBytes = std::vector<std::uint8_t>;

/// A world, who watches and steers it, its log and its replay. Not thread-safe.
class Session {
public:
    /// Without a world: load() comes next.
    explicit Session(SessionDef def);
    ~Session();
    Session(Session&&) noexcept;  ///< Moves.
    Session& operator=(Session&&) noexcept;

    /// Begins a world, ending the one before and any recording, which is kept, or replay. Plays at once.
    /// Fails, changing nothing, as World::create does.
    Status load(const std::string& name, const WorldDef& def);
    /// The same from the text of a scenario file that lies nowhere. Fails, changing nothing, as parseScenario
    /// and World::create do. `director`: the client that opens it, as Welcome calls it; 0 for somebody.
    Status openScenario(const std::string& name, std::string_view text, std::uint32_t director = 0);
    /// The place as a scenario file: what the world began from, with all edits since. Restart begins with it,
    /// and a world made from it has the same hashes. Fails with NotFound before the first load.
    Result<std::string> scenario() const;
    /// A file name for it: "open.json".
    std::string scenarioName() const;
    /// Begins the replay of a take's bytes. Fails, changing nothing, as parseTake does, or where the take is
    /// too large or holds no step. `fileName` is its name on the shelf, empty where it lies elsewhere.
    /// `director` as above.
    Status openTake(std::span<const std::uint8_t> bytes, const std::string& sourceName,
                    const std::string& fileName = {}, std::uint32_t director = 0);
    /// What is said about the take on the shelf has changed but for its camera; the open one follows where it
    /// is this.
    void takeEdited(const std::string& fileName, const TakeAbout& about);
    /// The name on the shelf of the take that is open, and of the one that is being recorded; empty for none.
    std::string openTakeName() const;
    std::string recordedTakeName() const;  ///< As above.
    /// Everything since the world began as a take that replays up to now; the opened take during a replay.
    /// Fails with NotFound before the first load.
    Result<std::vector<std::uint8_t>> take() const;
    /// A file name for it: "open.take".
    std::string takeName() const;
    /// Ends a recording that runs.
    void finish();

    /// What another session needs to go on with this world, or with the take that is open: docs/protocol.md,
    /// "Handover". Who has the first `takeBytes` bytes of the take of the world of that number already does
    /// not get them again. Fails with NotFound before the first load.
    Result<std::vector<std::uint8_t>> handover(std::uint32_t world = 0, std::uint64_t takeBytes = 0) const;
    /// Goes on with the world of a handover, which must hold the whole take; the world before ends. Fingers
    /// of the other session's clients let go. Fails, changing nothing, with ParseError, Unsupported or
    /// InvalidArgument, and as openTake() does.
    Status takeOver(std::span<const std::uint8_t> handover);

    /// Adds a client and returns its number, which is not reused.
    std::uint32_t connect();
    /// Removes a client, which lifts its fingers.
    void disconnect(std::uint32_t client);
    /// Takes a client's message. What is malformed or not allowed gets a Notice and changes nothing.
    void receive(std::uint32_t client, std::span<const std::uint8_t> bytes);
    /// Sends a Notice to one client.
    void notice(std::uint32_t client, bool error, const std::string& code, const std::string& text);
    /// Replaces `messages` by those to send to the client, in order. A client gets no frame until it has
    /// acknowledged the last one, and then the newest.
    void outgoing(std::uint32_t client, std::vector<MessageBytes>& messages);

    /// Advances real time by `seconds` [s], 0 or more. Time that the world cannot keep up with is dropped.
    void elapse(double seconds);
    /// True where step() has something to do.
    bool stepDue() const;
    /// Makes the step that is due; at speeds above 1, the steps of a sixtieth of a second.
    void step();
    /// True where prepare() has something to do.
    bool preparing() const;
    /// Reads ahead in the take that is open, by one step, so that seeks in it are quick. Call while idle.
    void prepare();
    /// Real time until a step is due [s]; a long time while paused.
    double untilNextStep() const;

    /// The world; null before the first load.
    const World* world() const;
    /// True while the world is playing.
    bool playing() const;
    /// True while a take is replayed.
    bool replaying() const;
    /// True while touches of the scenario's gestures are still to come.
    bool demonstrating() const;

    struct Impl;  ///< Private.

private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
