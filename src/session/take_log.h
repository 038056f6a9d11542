// The log of all commands that a world has received since it began.
#pragma once

#include <memory>

#include "muster/session.h"
#include "muster/take.h"

namespace muster {

/// A take in memory, copied to a file while one is attached. A log that exceeds its limit ends at its last
/// mark and can still be replayed.
class TakeLog {
public:
    /// Starts the log of a new world.
    void begin(const WorldDef& def, std::size_t limit);
    /// Must be called for each command, after it is submitted.
    void command(const Command& command);
    /// Must be called after every step.
    void observe(const World& world);
    /// The take up to now, with an end record.
    std::vector<std::uint8_t> bytes(const World& world) const;
    /// Attaches a file: writes the log so far to it, then everything that follows.
    Status attach(std::unique_ptr<TakeSink> sink);
    /// Writes the end record and detaches the file.
    Status detach(const World& world);
    /// True while a file is attached.
    bool attached() const { return sink_ != nullptr; }
    /// The error that detached a file since the last call; OK for none.
    Status takeFailure();
    /// True after the limit was reached.
    bool full() const { return full_; }

private:
    void append(const std::vector<std::uint8_t>& record);

    std::vector<std::uint8_t> bytes_;
    std::size_t limit_ = 0;
    bool full_ = false;
    std::unique_ptr<TakeSink> sink_;
    Status failure_;
};

}  // namespace muster
