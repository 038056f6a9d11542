// The log of all commands that a world has received since it began.
#pragma once

#include <memory>

#include "files/take/take_frames.h"
#include "muster/session.h"
#include "muster/take.h"

namespace muster {

/// A take in memory, copied to a file while one is attached. A log that exceeds its limit ends at its last
/// mark and can still be replayed.
class TakeLog {
public:
    /// Starts the log of a new world.
    void begin(const WorldDef& def, std::size_t limit);
    /// Starts with what a take holds up to that step. `commands` of it were submitted; with `drop`, those of
    /// them that waited for that step or a later one were dropped again.
    void resume(const Take& take, std::uint32_t step, std::size_t commands, bool drop, std::size_t limit);
    /// Must be called for each command, after it is submitted.
    void command(const Command& command);
    /// The log ends here, as if its limit were reached.
    void close() { full_ = true; }
    /// The records so far, without an end record. They only grow, until the next begin().
    const std::vector<std::uint8_t>& records() const { return bytes_; }
    /// Frames are stored from now on, or no longer.
    void storeFrames(bool on);
    /// Must be called after every step.
    void observe(const World& world);
    /// The take up to now, with an end record.
    std::vector<std::uint8_t> bytes(const World& world) const;
    /// Attaches a file: writes the log so far to it and what is said about it, then everything that follows.
    Status attach(std::unique_ptr<TakeSink> sink, const TakeAbout& about);
    /// Writes what is said about the take and the end record, and detaches the file.
    Status detach(const World& world, const TakeAbout& about);
    /// Detaches the file and keeps nothing of it.
    Status discard();
    /// Name of the attached file on the shelf; empty for none.
    std::string fileName() const { return sink_ ? sink_->name() : std::string(); }
    /// Commands logged since the world began.
    std::size_t commands() const { return commands_; }
    /// True while a file is attached.
    bool attached() const { return sink_ != nullptr; }
    /// The error that detached a file since the last call; OK for none.
    Status takeFailure();
    /// True after the limit was reached.
    bool full() const { return full_; }

private:
    void append(const std::vector<std::uint8_t>& record);
    void flushFrames();

    std::vector<std::uint8_t> bytes_;
    std::size_t limit_ = 0;
    bool full_ = false;
    std::size_t commands_ = 0;
    bool storesFrames_ = false;
    FrameRecorder frames_;
    std::unique_ptr<TakeSink> sink_;
    Status failure_;
};

}  // namespace muster
