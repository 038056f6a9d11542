#include "files/export/player/crowd_track.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "files/export/player/player_format.h"

namespace muster {
namespace {

constexpr double kMostPart = 0.70710678118654752;  // Of the three smaller numbers of a unit quaternion.

std::array<std::int32_t, 3> bodyUnits(Vec3 v) {
    return {unitsOf(static_cast<double>(v.x), kBodyUnit), unitsOf(static_cast<double>(v.y), kBodyUnit),
            unitsOf(static_cast<double>(v.z), kBodyUnit)};
}

/// Weights as whole numbers that sum up to kWeightSteps.
std::array<std::int32_t, 4> weightUnits(const BodyVertex& vertex) {
    std::array<std::int32_t, 4> units{};
    std::int32_t left = kWeightSteps;
    for (std::size_t k = 3; k > 0; --k) {
        units[k] = std::min(left, unitsOf(static_cast<double>(vertex.weights[k]), 1.0 / kWeightSteps));
        left -= units[k];
    }
    units[0] = left;
    return units;
}

class BodyWriter {
public:
    explicit BodyWriter(RangeEncoder& coder) : coder_(coder) {}

    void mesh(const BodyMesh& mesh) {
        coder_.natural(count_, static_cast<std::uint32_t>(mesh.vertices.size()));
        std::array<std::int32_t, 3> last{};
        BodyVertex before;
        std::array<std::int32_t, 4> weightsBefore{};
        for (const BodyVertex& vertex : mesh.vertices) {
            const auto units = bodyUnits(vertex.position);
            for (std::size_t k = 0; k < 3; ++k) coder_.whole(position_[k], units[k] - last[k]);
            last = units;
            coder_.whole(region_, static_cast<int>(vertex.region) - static_cast<int>(before.region));
            const auto weights = weightUnits(vertex);
            // A vertex ends with its last joint that bears weight.
            std::size_t joints = 4;
            while (joints > 1 && weights[joints - 1] == 0) --joints;
            coder_.natural(joints_, static_cast<std::uint32_t>(joints - 1));
            for (std::size_t k = 0; k < joints; ++k) {
                coder_.whole(joint_[k], vertex.joints[k] - before.joints[k]);
                if (k > 0) coder_.whole(weight_[k], weights[k] - weightsBefore[k]);
            }
            for (std::size_t k = 0; k < joints; ++k) before.joints[k] = vertex.joints[k];
            before.region = vertex.region;
            weightsBefore = weights;
        }
        triangles(mesh);
    }

private:
    void triangles(const BodyMesh& mesh) {
        coder_.natural(count_, static_cast<std::uint32_t>(mesh.indices.size() / 3));
        std::array<std::int32_t, 3> last{};
        for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
            const auto corner = [&](std::size_t k) { return static_cast<std::int32_t>(mesh.indices[t + k]); };
            coder_.whole(index_[0], corner(0) - last[0]);
            coder_.whole(index_[1], corner(1) - corner(0) - (last[1] - last[0]));
            coder_.whole(index_[2], corner(2) - corner(1) - (last[2] - last[1]));
            last = {corner(0), corner(1), corner(2)};
        }
    }

    RangeEncoder& coder_;
    NumberModel count_, position_[3], region_, joints_, joint_[4], weight_[4], index_[3];
};

/// A rotation as its largest part's index and the three others, for a positive largest part.
struct SmallRotation {
    std::uint32_t largest = 3;
    std::array<std::int32_t, 3> others{};
};

SmallRotation smallRotation(Quat q) {
    const std::array<float, 4> parts{q.x, q.y, q.z, q.w};
    SmallRotation small;
    for (std::uint32_t k = 0; k < 3; ++k)
        if (std::abs(parts[k]) > std::abs(parts[small.largest])) small.largest = k;
    const double sign = parts[small.largest] < 0.0f ? -1.0 : 1.0;
    std::size_t at = 0;
    for (std::uint32_t k = 0; k < 4; ++k)
        if (k != small.largest)
            small.others[at++] = unitsOf(sign * static_cast<double>(parts[k]), kMostPart / kRotationSteps);
    return small;
}

class ClipWriter {
public:
    explicit ClipWriter(RangeEncoder& coder) : coder_(coder) {}

    void clip(const Clip& clip, const PlayedClip& played) {
        const double seconds = clip.duration();
        const auto parts = static_cast<std::uint32_t>(
            std::max(1.0, std::ceil(seconds * kPosesPerSecond - 1e-6)));
        // Cyclic clips go on with their first pose; others end with one more.
        const std::uint32_t poses = played.cyclic ? parts : parts + 1;
        coder_.natural(head_, static_cast<std::uint32_t>(played.duration));
        coder_.natural(head_, played.cyclic ? 1u : 0u);
        coder_.natural(head_, poses);
        hips_ = {}, hipsBy_ = {};
        rotations_ = {};
        steps_ = {};
        for (std::uint32_t k = 0; k < poses; ++k) {
            BodyPose pose;
            clip.sample(seconds * k / parts, pose);
            write(pose);
        }
    }

private:
    void write(const BodyPose& pose) {
        const auto hips = bodyUnits(pose.hips);
        for (std::size_t k = 0; k < 3; ++k) {
            coder_.whole(hipsModel_, hips[k] - hips_[k] - hipsBy_[k]);
            hipsBy_[k] = hips[k] - hips_[k];
            hips_[k] = hips[k];
        }
        for (std::size_t j = 0; j < kJointCount; ++j) joint(j, smallRotation(pose.rotation[j]));
    }

    void joint(std::size_t j, const SmallRotation& now) {
        SmallRotation& last = rotations_[j];
        const bool same = now.largest == last.largest;
        coder_.bit(other_, !same);
        if (!same) coder_.plain(now.largest, 2);
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t expected = same ? last.others[k] + steps_[j][k] : 0;
            coder_.whole(part_[j][k], now.others[k] - expected);
            steps_[j][k] = same ? now.others[k] - last.others[k] : 0;
        }
        last = now;
    }

    RangeEncoder& coder_;
    std::array<std::int32_t, 3> hips_{}, hipsBy_{};
    std::array<SmallRotation, kJointCount> rotations_{};
    std::array<std::array<std::int32_t, 3>, kJointCount> steps_{};
    NumberModel head_, hipsModel_;
    std::array<std::array<NumberModel, 3>, kJointCount> part_;
    BitModel other_;
};

}  // namespace

std::string playerBodies(const CrowdTrack& track) {
    RangeEncoder coder;
    NumberModel parent, offset, kinds;
    coder.natural(kinds, static_cast<std::uint32_t>(kJointCount));
    for (const Joint& joint : skeleton()) {
        coder.natural(parent, static_cast<std::uint32_t>(joint.parent + 1));
        for (const std::int32_t units : bodyUnits(joint.offset)) coder.whole(offset, units);
    }
    for (std::size_t kind = 0; kind < kBodyKindCount; ++kind) {
        coder.natural(kinds, track.hasBody(kind) ? 1u : 0u);
        if (!track.hasBody(kind)) continue;
        BodyWriter writer(coder);
        for (const BodyLevel level : {BodyLevel::Near, BodyLevel::Far})
            writer.mesh(makeBody(static_cast<BodyKind>(kind), level));
    }
    return coder.finish();
}

std::string playerClips(const ClipLibrary& library, std::span<const PlayedClip> clips) {
    RangeEncoder coder;
    ClipWriter writer(coder);
    for (const PlayedClip& played : clips) writer.clip(library.clips[played.index], played);
    return coder.finish();
}

}  // namespace muster
