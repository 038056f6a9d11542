// Snapshots along a take, so that a replay can go to any moment.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "files/take/replayer.h"
#include "muster/motion.h"
#include "muster/world.h"

namespace muster {

/// All that a replay goes on from.
struct TakeMoment {
    std::vector<std::uint8_t> world;                 ///< World::snapshot().
    std::shared_ptr<const CrowdMotionState> motion;  ///< CrowdMotion::state().
    Replayer::Cursor cursor;                         ///< How far the take has been compared.

    std::size_t bytes() const { return world.size() + CrowdMotion::sizeOf(*motion); }  ///< Its memory.
};

/// Moments at even spacing. Where they take too much memory, every second one is dropped.
class TakeMoments {
public:
    /// Moments `spacing` steps apart, of at most so many bytes together.
    TakeMoments(std::uint32_t spacing, std::size_t mostBytes) : spacing_(spacing), mostBytes_(mostBytes) {}

    /// True where a moment of that step is wanted and missing.
    bool missing(std::uint32_t step) const { return step % spacing_ == 0 && !moments_.contains(step); }
    /// Keeps the moment of a step.
    void keep(std::uint32_t step, TakeMoment moment);
    /// The last moment at or before a step with its step; null for none.
    const std::pair<const std::uint32_t, TakeMoment>* before(std::uint32_t step) const;
    /// The step of the last moment; 0 for none.
    std::uint32_t last() const { return moments_.empty() ? 0 : moments_.rbegin()->first; }
    std::size_t count() const { return moments_.size(); }  ///< Number of moments.
    std::size_t bytes() const { return bytes_; }           ///< Their memory.
    std::uint32_t spacing() const { return spacing_; }     ///< Steps from one to the next.

private:
    void thin();

    std::map<std::uint32_t, TakeMoment> moments_;  // By step.
    std::uint32_t spacing_;
    std::size_t mostBytes_;
    std::size_t bytes_ = 0;
};

}  // namespace muster
