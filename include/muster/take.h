// Takes: a scenario, the commands given to it and hashes of its state, so that it replays bit for bit (SPEC
// B6).
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "muster/command.h"
#include "muster/generated/take.h"
#include "muster/status.h"
#include "muster/world.h"

namespace muster {

inline constexpr std::uint32_t kTakeMarkSpacing = 60;  ///< Steps between hash marks.

inline constexpr std::uint32_t kTakeEnd = 0xffffffff;  ///< As the last step of a part: the take's end.

/// A whole take in memory.
struct Take {
    std::string scenario;           ///< Text of the scenario, map and clip facts embedded.
    WorldDef def;                   ///< The scenario, parsed.
    std::vector<Command> commands;  ///< Commands in the order of submission.
    std::vector<HashMark> marks;    ///< Hash marks in ascending order of steps.
    std::vector<TakeEvent> events;  ///< Events in ascending order of steps; takes of before have none.
    std::vector<TakeFrame> frames;  ///< In ascending order of steps; takes of before have none.
    TakeAbout about;                ///< As said last; takes of before say nothing.
    bool finished = false;          ///< True where the take has an end record.
    std::size_t tornBytes = 0;      ///< Bytes of an unfinished last record that were left out.
    /// Steps whose hashes are known: up to the last mark.
    std::uint32_t markedSteps() const { return marks.empty() ? 0 : marks.back().step; }
    /// Steps that can be replayed: also those behind the last mark of an unfinished take, to its last
    /// command.
    std::uint32_t steps() const;
};

class FrameRecorder;

/// Appends records to a file; each is handed to the system before the call returns, so that a killed
/// process loses at most the record it was writing.
class TakeWriter {
public:
    TakeWriter(TakeWriter&&) noexcept;             ///< Moves.
    TakeWriter& operator=(TakeWriter&&) noexcept;  ///< Moves.
    ~TakeWriter();

    /// Makes the file. Fails with IoError, also where it exists and `overwrite` is false.
    static Result<TakeWriter> create(const std::string& path, const WorldDef& def, bool overwrite = true);

    /// Appends a command. Call in the order of submission, before the step that applies it.
    Status command(const Command& command);
    /// Call after every step: appends the events of orders, and frames and a mark whenever they are due.
    Status observe(const World& world);
    /// Appends the end record and closes the file, synchronised with the disk.
    Status finish(const World& world);

private:
    struct CloseFile {
        void operator()(std::FILE* file) const;
    };
    TakeWriter(std::FILE* file, std::string path);
    Status append(const std::vector<std::uint8_t>& bytes);

    std::unique_ptr<std::FILE, CloseFile> file_;
    std::string path_;
    std::unique_ptr<FrameRecorder> frames_;
};

/// Reads a take. A torn last record is left out and reported in `tornBytes`. Fails with Corrupt, naming the
/// offset, where anything before it does not match its checksum; with ParseError or Unsupported on other
/// files.
Result<Take> readTake(const std::string& path);
/// The same from bytes.
Result<Take> parseTake(std::span<const std::uint8_t> bytes, const std::string& sourceName);

/// Where a replay takes positions from.
enum class ReplayFrom : std::uint8_t {
    Simulation,  ///< The world simulates everything again.
    Frames,      ///< Characters are put where the stored frames say; nothing is compared.
};

/// Whether this Muster simulates the take as it was recorded, up to its first mark. A take that was recorded
/// by a version with other results differs there.
bool simulatesAlike(const Take& take, std::int32_t threads = 1);

/// Simulates the take again and compares every mark and event; then, where the take is unfinished, goes on to
/// its last command. Fails with Corrupt naming the step of the first mark that differs. With
/// ReplayFrom::Frames nothing is compared, and it fails with Unsupported where the take has no stored frames.
/// `observe` is called after every step; it returns false to stop early.
Result<ReplayReport> replayTake(const Take& take, std::int32_t threads = 1,
                                const std::function<bool(const World&)>& observe = {},
                                ReplayFrom from = ReplayFrom::Simulation);

}  // namespace muster
