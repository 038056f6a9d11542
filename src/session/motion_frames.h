// The characters' motion as frames tell of it.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "muster/clip.h"
#include "muster/motion.h"
#include "session/crowd_picture.h"

namespace muster {

/// Where a client looks: it wants whole poses of the `count` characters nearest to `centre`.
struct Attention {
    Vec2 centre;            ///< [m]
    std::size_t count = 0;  ///< 0 for none.
};

/// Plays the crowd's motion beside a world, for all clients together.
class MotionFrames {
public:
    /// Fails, naming the culprit, where frames cannot tell of these clips: one may last as long as a time in
    /// it fits 16 bits of milliseconds, their number fits 8 bits, and all poses fit a page's memory.
    static Status fits(const ClipLibrary& library);
    /// A new world, moved by these clips, which fit.
    void restart(ClipLibrary library);
    /// Call after every step, with where all clients look.
    void observe(const World& world, const std::vector<Attention>& attentions);
    /// Writes headings, clips, phases and whole poses to `picture`.
    void build(CrowdPicture& picture) const;

    /// Skeleton and clips as an encoded Motions message.
    const std::vector<std::uint8_t>& motions() const { return motions_; }
    /// Grows with every other library.
    std::uint32_t revision() const { return revision_; }

private:
    void chooseNear(const World& world, const std::vector<Attention>& attentions);
    void encodeMotions();

    std::unique_ptr<ClipLibrary> library_;  // Where it stands CrowdMotion looks.
    std::unique_ptr<CrowdMotion> motion_;
    std::vector<std::uint8_t> motions_;
    std::vector<float> durations_;  // Of clips [s].
    bool longClips_ = false;        // Some are too long for phases of 8 bits.
    std::uint32_t revision_ = 0;
    std::uint32_t untilChoice_ = 0;  // Steps until whose poses are whole is chosen anew.
    std::size_t attended_ = 0;       // Asked for at the last choice.
    std::vector<std::pair<double, std::uint32_t>> byDistance_;  // Working memory.
    std::vector<std::uint32_t> near_;
};

}  // namespace muster
