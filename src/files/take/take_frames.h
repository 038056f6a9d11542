// Stored frames of takes: where everybody was, so that a take can be shown where its simulation gives other
// bits (docs/take-format.md, "Frames").
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/take.h"

namespace muster {

/// Positions are stored as whole multiples of this [m].
inline constexpr double kFrameGrain = 0.001;

/// Writes frames as bytes, each predicted from those before it. They must be in ascending order of steps.
std::vector<std::uint8_t> packFrames(std::span<const TakeFrame> frames);
/// Appends the frames of packFrames(). Fails with Corrupt, and appends nothing, where the bytes are none.
Status unpackFrames(std::span<const std::uint8_t> bytes, std::vector<TakeFrame>& frames);

/// Steps from one stored frame to the next for a crowd of that size: a divisor of kTakeMarkSpacing.
std::uint32_t storedFrameSpacing(std::size_t characters);

/// Gathers frames while a world is recorded.
class FrameRecorder {
public:
    /// Call after every step. True where a record is due: then take().
    bool observe(const World& world);
    /// The frames since the last call; empty for none.
    std::vector<TakeFrame> take();
    std::span<const TakeFrame> waiting() const { return frames_; }  ///< What take() would give.

private:
    std::vector<TakeFrame> frames_;
};

/// Where a character was after `step` steps, from the stored frames of a take.
class FrameCurve {
public:
    /// The take must outlive this.
    explicit FrameCurve(const Take& take) : frames_(&take.frames) {}
    /// Writes ids and positions [m] at that step; false where no frame tells of it.
    bool at(std::uint32_t step, std::vector<std::uint32_t>& ids, std::vector<Vec2>& positions) const;

private:
    const std::vector<TakeFrame>* frames_;
};

}  // namespace muster
