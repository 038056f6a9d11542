// The feature database of motion matching (Clavet 2016; docs/method/motion.md): features of every frame of
// the clips, and the search for the nearest ones.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "people/motion/clip_table.h"

namespace muster {

inline constexpr std::size_t kTrajectoryCount = 12;  ///< Number of trajectory features.
/// Number of pose features: positions and velocities of the feet, velocity of the hips, contacts of the feet.
inline constexpr std::size_t kPoseCount = 17;
inline constexpr std::size_t kFeatureCount = kTrajectoryCount + kPoseCount;  ///< Number of all features, 29.
inline constexpr std::array<float, 3> kHorizons{1.0f / 3.0f, 2.0f / 3.0f,
                                                1.0f};  ///< Times of the prediction ahead of now [s].

/// The predicted position (x, y) [m] at each horizon, then the predicted facing (x, y), in the present body
/// axes.
using Trajectory = std::array<float, kTrajectoryCount>;
/// Normalised features of a frame: (value - mean) / standard deviation * weight.
using Features = std::array<float, kFeatureCount>;

/// Clips that a search considers.
enum class ClipFilter : std::uint8_t {
    Any,       ///< All locomotion clips.
    Going,     ///< Clips that travel.
    Standing,  ///< Clips that do not travel.
};

/// The result of a search.
struct Match {
    std::int32_t row = -1;  ///< Row that was found, -1 for none.
    float cost = 0.0f;      ///< Squared distance of features.
};

/// Features of all clips, one row per frame at 30 frames per second.
class FeatureDatabase {
public:
    /// Computes the features of all frames.
    explicit FeatureDatabase(const ClipTable& table);

    /// The row of a clip's frame nearest to a time [s].
    std::int32_t rowOf(std::size_t clip, float time) const;
    std::size_t clipOf(std::int32_t row) const { return clipOfRow_[row]; }  ///< Clip of a row.
    float timeOf(std::int32_t row) const { return timeOfRow_[row]; }  ///< Time of a row in its clip [s].

    /// The query for a frame with this trajectory and the pose of a row.
    Features query(const Trajectory& trajectory, std::int32_t row) const;
    /// Squared distance of a row from a query.
    float cost(const Features& query, std::int32_t row) const;
    /// The nearest row of locomotion whose cost is less than `below`, if any, for people of a motion set.
    Match search(const Features& query, ClipFilter filter, std::optional<MotionSet> set, float below) const;
    /// True for clips that people of a motion set play: its own clips, and plain ones except gaits, where it
    /// has its own gaits.
    bool suits(std::size_t clip, std::optional<MotionSet> set) const { return suits(ranges_[clip], set); }
    /// The row of one clip with the nearest pose, regardless of the trajectory; -1 for a clip without frames.
    std::int32_t nearestPose(std::size_t clip, std::int32_t row) const;

private:
    static constexpr std::size_t kRowsPerBlock = 8;
    /// Eight rows in structure-of-arrays order, for vector instructions.
    using Block = std::array<std::array<float, kRowsPerBlock>, kFeatureCount>;
    /// The rows of one clip.
    struct Range {
        std::int32_t firstRow = 0;     ///< Index of the first row.
        std::int32_t rows = 0;         ///< Number of rows.
        std::int32_t firstBlock = 0;   ///< Index of the first block.
        std::int32_t blocks = 0;       ///< Number of blocks that a search considers.
        bool locomotion = false;       ///< True for a locomotion clip.
        bool standing = false;         ///< True for a clip that does not travel.
        bool ends = false;             ///< True for a clip that is not cyclic.
        std::optional<MotionSet> set;  ///< Motion set as in Clip::set.

        /// True for a cycle that travels.
        bool gait() const { return locomotion && !standing && !ends; }
    };

    void addClip(const ClipEntry& entry);
    bool suits(const Range& range, std::optional<MotionSet> set) const;
    void normalise();
    void measure(const std::vector<const Features*>& rows);
    void fillBlocks();
    void searchBlocks(const Features& query, const Range& range, Match& best) const;

    std::vector<Range> ranges_;                         ///< Rows of each clip.
    std::array<bool, kCountOf<MotionSet>> hasGaits_{};  ///< True by motion set.
    std::vector<Features> rows_;                        ///< Normalised, weighted features by row.
    std::vector<Block> blocks_;
    std::vector<std::uint16_t> clipOfRow_;
    std::vector<float> timeOfRow_;
    Features mean_{};
    Features scale_{};
};

}  // namespace muster
