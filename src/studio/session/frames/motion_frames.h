// The motion part of frames: clips, phases and whole poses.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <vector>

#include "muster/clip.h"
#include "muster/motion.h"
#include "people/motion/shown_character.h"
#include "studio/session/frames/crowd_picture.h"

namespace muster {

/// The point that a client looks at. It receives whole poses of the `count` characters nearest to `centre`.
struct Attention {
    Vec2 centre;            ///< [m]
    std::size_t count = 0;  ///< 0 for none.
};

/// Plays the crowd's motion along with a world, once for all clients.
class MotionFrames {
public:
    /// Fails, naming the clip, where frames cannot represent these clips: a clip lasts longer than 65 s,
    /// there are more than 256 clips, or all poses together exceed the page's memory limit.
    static Status fits(const ClipLibrary& library);
    /// Starts with a new world whose characters play these clips. fits() must accept them. With `trackAll`
    /// the whole poses of all characters go on, whoever looks where, so that a replay shows the same ones
    /// each time.
    void restart(ClipLibrary library, bool trackAll = false);
    /// True where a take of that scenario is small enough for it.
    static bool tracksAll(const WorldDef& def);
    /// Must be called after every step, with the attention of all clients.
    /// Those in `shown`, by ids, are shown otherwise and have whole poses wherever somebody has.
    void observe(const World& world, const std::vector<Attention>& attentions,
                 std::span<const ShownCharacter> shown = {});
    /// Writes headings, clips, phases and whole poses to `picture`.
    void build(CrowdPicture& picture) const;

    /// The motion of the crowd.
    const CrowdMotion& motion() const { return *motion_; }
    /// The clips that it plays.
    const ClipLibrary& library() const { return *library_; }
    /// Goes to another moment of the same motion.
    void goBack(const CrowdMotionState& state);
    /// The motion of these characters starts again with the next step.
    void forget(std::span<const std::uint32_t> ids) { motion_->forget(ids); }
    void startAgain() { motion_->restart(); }  ///< The motion of everybody starts again.

    /// The skeleton and the clips as an encoded Motions message.
    const std::vector<std::uint8_t>& motions() const { return motions_; }
    /// Revision of motions(); it grows with every change of the library.
    std::uint32_t revision() const { return revision_; }

private:
    void chooseNear(const World& world, const std::vector<Attention>& attentions,
                    std::span<const ShownCharacter> shown);
    void encodeMotions();

    std::unique_ptr<ClipLibrary> library_;  // On the heap, because CrowdMotion points to it.
    std::unique_ptr<CrowdMotion> motion_;
    std::vector<std::uint8_t> motions_;
    std::vector<float> durations_;  // Duration of each clip [s].
    bool trackAll_ = false;         // True where all characters have whole poses.
    bool longClips_ = false;        // True where a clip is too long for 8-bit phases.
    std::uint32_t revision_ = 0;
    std::uint32_t untilChoice_ = 0;  // Steps until the characters with whole poses are chosen again.
    std::size_t attended_ = 0;       // Number of whole poses requested at the last choice.
    std::vector<std::pair<double, std::uint32_t>> byDistance_;  // Working memory.
    std::vector<std::uint32_t> near_;  // Ids of those whom clients look at, ascending.
};

}  // namespace muster
