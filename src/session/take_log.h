// The log of everything that was done to a world since it began.
#pragma once

#include <memory>

#include "muster/session.h"
#include "muster/take.h"

namespace muster {

/// A take in memory, copied to a file while one is attached. A log that grows beyond its limit ends at its
/// last mark: what it holds still replays.
class TakeLog {
public:
    /// The log of a new world.
    void begin(const WorldDef& def, std::size_t limit);
    /// Call for each command, after it was submitted.
    void command(const Command& command);
    /// Call after every step.
    void observe(const World& world);
    /// All so far, ended now.
    std::vector<std::uint8_t> bytes(const World& world) const;
    /// Copies all so far, and what comes, to a file.
    Status attach(std::unique_ptr<TakeSink> sink);
    /// Ends the file.
    Status detach(const World& world);
    /// True where a file is attached.
    bool attached() const { return sink_ != nullptr; }
    /// Why a file was given up since the last call; it is detached then.
    Status takeFailure();
    /// True once the limit was reached.
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
