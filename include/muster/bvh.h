// BVH files: skeletons and motion as most animation programs exchange them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/clip.h"
#include "muster/status.h"

namespace muster {

/// A joint of a BVH file, in Muster's axes (x forward, y left, z up).
struct BvhJoint {
    std::string name;          ///< As the file spells it.
    std::int32_t parent = -1;  ///< Index of a joint before it; -1 for a root.
    Vec3 offset;               ///< From the parent in the rest pose [m].
    std::vector<Vec3> ends;    ///< End sites, from the joint [m].
    bool moves = false;        ///< It has position channels.
};

/// A whole BVH file, decoded.
struct BvhMotion {
    std::vector<BvhJoint> joints;   ///< Parents before children; at least one.
    std::vector<Transform> values;  ///< Frame by frame, joint by joint: relative to the parent [m].
    std::size_t frames = 0;         ///< At least one.
    double rate = 30.0;             ///< Frames a second > 0.
    double unit = 1.0;              ///< One unit of the file [m].

    /// One value per joint.
    std::span<const Transform> frame(std::size_t f) const {
        return std::span(values).subspan(f * joints.size(), joints.size());
    }
    /// From the first frame to the last [s].
    double duration() const { return static_cast<double>(frames - 1) / rate; }
};

/// How to read.
struct BvhOptions {
    double unit = 0.0;  ///< One unit of the file [m], 1e-6 to 1e3; 0: guessed from the size of the body.
};

inline constexpr std::size_t kMaxBvhBytes = 512u << 20;  ///< Largest file read.
inline constexpr std::size_t kMaxBvhJoints = 1000;       ///< Most joints.
inline constexpr std::size_t kMaxBvhValues = 8u << 20;   ///< Most frames times joints.

/// Reads BVH text: any hierarchy, any order of channels. Unit, up axis (Y or Z) and facing (to a quarter
/// turn) are guessed from the rest pose. Fails, as `sourceName:LINE: found X, expected Y`, on anything that
/// is no whole BVH file.
Result<BvhMotion> parseBvh(std::string_view text, const std::string& sourceName,
                           const BvhOptions& options = {});
/// The same from a file.
Result<BvhMotion> readBvh(const std::string& path, const BvhOptions& options = {});

/// A clip as BVH, in centimetres, Y up, facing +Z, as Maya, MotionBuilder, Unreal and Mixamo take it without
/// asking (Blender imports it with scale 0.01). A joint "Root" on the ground carries the travel, "Hips"
/// stands in it with six channels, all other joints of the skeleton have three. A cyclic clip ends with its
/// first pose again, one travel on.
std::string bvhText(const Clip& clip);

/// Writes poses of Muster's skeleton as BVH, frame by frame.
class BvhFrameWriter {
public:
    /// For a body of that size, 1 for the skeleton's own.
    explicit BvhFrameWriter(float size = 1.0f) : size_(size) {}

    /// The file up to the word MOTION, that included.
    std::string hierarchy() const;
    /// The two lines behind it; the number of frames takes 10 columns, so that it can be written again in
    /// place.
    static std::string motionHead(std::size_t frames, double rate);
    /// Adds one line to `text`: the root on the ground [m, rad], and the pose, hips as for a body of size 1.
    /// Angles go on from those of the line before without jumps.
    void append(const Travel& root, const BodyPose& pose, std::string& text);

private:
    struct Angles {
        double z = 0.0, x = 0.0, y = 0.0;
    };
    static Angles anglesOf(Quat rotation, const Angles& before);
    static void put(double value, std::string& text);
    static void putAngles(const Angles& angles, std::string& text);

    float size_ = 1.0f;
    double rootTurn_ = 0.0;
    std::array<Angles, kJointCount> before_{};
};

}  // namespace muster
