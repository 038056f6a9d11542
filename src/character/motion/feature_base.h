// What every frame of the clips looks like and leads to, and the search for the frame that suits best
// (motion matching, docs/method/motion.md).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "character/motion/clip_table.h"

namespace muster {

inline constexpr std::size_t kTrajectoryCount = 12;  ///< Numbers of a trajectory.
inline constexpr std::size_t
    kPoseCount = 17;  ///< Feet's places and velocities, velocity of the hips, feet that touch.
inline constexpr std::size_t kFeatureCount = kTrajectoryCount + kPoseCount;       ///< 29.
inline constexpr std::array<float, 3> kHorizons{1.0f / 3.0f, 2.0f / 3.0f, 1.0f};  ///< Looked ahead [s].

/// Where one will be at each horizon (x, y) [m], then which way one will face (x, y), in the own frame now.
using Trajectory = std::array<float, kTrajectoryCount>;
/// A frame sought: numbers less mean, over spread, times weight.
using Features = std::array<float, kFeatureCount>;

/// Clips that a search may look at.
enum class ClipFilter : std::uint8_t {
    Any,       ///< All plain ways to go and to stand.
    Going,     ///< Those that go somewhere.
    Standing,  ///< Those that stand.
};

/// A frame found.
struct Match {
    std::int32_t row = -1;  ///< -1 for none.
    float cost = 0.0f;      ///< Squared distance of features.
};

/// Frames of all clips, 30 a second.
class FeatureBase {
public:
    /// Computes the features of all frames.
    explicit FeatureBase(const ClipTable& table);

    /// The row of a clip's frame nearest to a time [s].
    std::int32_t rowOf(std::size_t clip, float time) const;
    std::size_t clipOf(std::int32_t row) const { return clipOfRow_[row]; }  ///< Of a row.
    float timeOf(std::int32_t row) const { return timeOfRow_[row]; }        ///< Of a row [s].

    /// What is sought: to go that way, from the body as it is at a row.
    Features query(const Trajectory& trajectory, std::int32_t row) const;
    /// How far a row is from it.
    float cost(const Features& query, std::int32_t row) const;
    /// The row that is nearest, if any is nearer than `below`. Looks at locomotion only.
    Match search(const Features& query, ClipFilter filter, float below) const;
    /// The row of one clip that is nearest in pose, whatever its trajectory; -1 for a clip without frames.
    std::int32_t nearestPose(std::size_t clip, std::int32_t row) const;

private:
    static constexpr std::size_t kLanes = 8;
    /// Eight rows, feature by feature.
    using Block = std::array<std::array<float, kLanes>, kFeatureCount>;
    /// A clip's rows.
    struct Range {
        std::int32_t firstRow = 0;
        std::int32_t rows = 0;
        std::int32_t firstBlock = 0;
        std::int32_t blocks = 0;  ///< That a search looks at.
        bool locomotion = false;
        bool standing = false;
        bool ends = false;
    };

    void addClip(const ClipEntry& entry);
    void normalise();
    void fillBlocks();
    void searchBlocks(const Features& query, const Range& range, Match& best) const;

    std::vector<Range> ranges_;   ///< By clip.
    std::vector<Features> rows_;  ///< Normalised and weighted.
    std::vector<Block> blocks_;
    std::vector<std::uint16_t> clipOfRow_;
    std::vector<float> timeOfRow_;
    Features mean_{};
    Features scale_{};
};

}  // namespace muster
