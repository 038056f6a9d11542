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
#include "muster/world.h"

namespace muster {

/// Clients up to this number are those of gestures: a demonstration's touches keep their numbers, so that it
/// gives the same hashes as a run of its gestures. Who connects gets a higher one.
inline constexpr std::uint32_t kLastDemonstrator = 1000;

/// Bounds of what clients may ask for; anything beyond gets a Notice and changes nothing.
struct SessionLimits {
    /// Touch events of one client, on average; as many at once.
    double touchesPerSecond = 5000.0;
    std::size_t touchesPerMessage = 1024;           ///< Events of one Touches message.
    std::size_t pointsPerControl = 64;              ///< Points of one AddControl message.
    std::size_t waitingCommands = 20000;            ///< For one step: reached only while paused.
    std::int32_t charactersPerGroup = 20000;        ///< By SetCount.
    std::size_t takeBytes = std::size_t{64} << 20;  ///< Of the log kept since the world began; it ends there.
    std::size_t openTakeBytes = std::size_t{64} << 20;  ///< Of a take to open.
    std::size_t wholePoses = 500;                       ///< Of the characters a client looks at.
    double noticesPerSecond = 5.0;                      ///< To one client; more are left out.
    double overlaysPerSecond = 5.0;                     ///< To one client.
};

/// A scenario that clients may load.
struct ScenarioEntry {
    std::string name;              ///< What LoadScenario calls it.
    std::string title;             ///< For people.
    std::string description;       ///< One or two sentences.
    std::uint32_t characters = 0;  ///< Of all groups.
};

/// Where a recording is kept while it runs.
class TakeSink {
public:
    virtual ~TakeSink() = default;
    /// Appends bytes so that they outlive the process.
    virtual Status append(std::span<const std::uint8_t> bytes) = 0;
    /// No more will come.
    virtual Status finish() = 0;
};

/// What a session is made from.
struct SessionDef {
    std::string version;                   ///< Told to clients.
    std::vector<ScenarioEntry> scenarios;  ///< In the order of the picker.
    /// Reads one of them. Null where there is nothing to load from.
    std::function<Result<WorldDef>(const std::string& name)> loadScenario;
    /// Reads the touches that a scenario of that name and definition carries. Null where there are none to
    /// watch.
    std::function<Result<std::vector<Command>>(const std::string& name, const WorldDef& def)> loadGestures;
    /// The clips that characters of a scenario of that name and definition move by. Null: Muster's own.
    std::function<Result<ClipLibrary>(const std::string& name, const WorldDef& def)> loadClips;
    /// Begins a file for a recording of that scenario. Null keeps recordings in memory only.
    std::function<Result<std::unique_ptr<TakeSink>>(const std::string& name)> openSink;
    std::int32_t threads = 1;  ///< Of the world, as for ThreadPool.
    SessionLimits limits;
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

    /// Begins a world, ending the one before and any recording or replay. Plays at once. Fails, changing
    /// nothing, as World::create does.
    Status load(const std::string& name, const WorldDef& def);
    /// Begins the replay of a take's bytes. Fails, changing nothing, as parseTake does, or where the take is
    /// too large or holds no step.
    Status openTake(std::span<const std::uint8_t> bytes, const std::string& sourceName);
    /// Everything since the world began as a take that replays up to now; the opened take during a replay.
    /// Fails with NotFound before the first load.
    Result<std::vector<std::uint8_t>> take() const;
    /// A file name for it: "open.take".
    std::string takeName() const;
    /// Ends a recording that runs.
    void finish();

    /// A new client; its number is never used again.
    std::uint32_t connect();
    /// The client has gone: its fingers lift.
    void disconnect(std::uint32_t client);
    /// Takes a client's message. What is malformed or not allowed gets a Notice and changes nothing.
    void receive(std::uint32_t client, std::span<const std::uint8_t> bytes);
    /// Tells one client something.
    void notice(std::uint32_t client, bool error, const std::string& code, const std::string& text);
    /// Moves what there is to send to `messages` (emptied first), in order. While the client has not
    /// acknowledged a frame it gets no other: then the newest.
    void outgoing(std::uint32_t client, std::vector<MessageBytes>& messages);

    /// Real time has passed [s] >= 0. What the world cannot keep up with is dropped, so it slows instead.
    void elapse(double seconds);
    /// True where step() has something to do.
    bool stepDue() const;
    /// Makes the step that is due (at speeds above 1 as many as belong to a sixtieth of a second).
    void step();
    /// Real time until a step is due [s]; a long one while paused.
    double untilNextStep() const;

    /// The world; null before the first load.
    const World* world() const;
    /// True while it runs by itself.
    bool playing() const;
    /// True while a take is replayed.
    bool replaying() const;
    /// True while touches that the scenario carries are still to come.
    bool demonstrating() const;

    struct Impl;  ///< Private.

private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
