// The interface that all export formats implement: a take is replayed and its frames are handed on one by
// one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "muster/clip.h"
#include "muster/export.h"
#include "muster/take.h"
#include "muster/world.h"

namespace muster {

/// A character in one frame.
struct ExportCharacter {
    std::uint32_t id = 0;     ///< Of the character: its own in the whole take.
    std::uint32_t group = 0;  ///< Index of its group.
    Vec2 position;            ///< Of its own frame on the ground [m].
    float yaw = 0.0f;         ///< It faces (cos, sin) of this [rad].
    float size = 1.0f;        ///< Of the skeleton; hips and offsets of the pose are to be scaled by it.
    const BodyPose* pose = nullptr;  ///< For a body of size 1; null where the exporter wants none.
};

/// One moment of a take, between two steps of the simulation if need be.
struct ExportFrame {
    std::size_t index = 0;  ///< From 0.
    double time = 0.0;      ///< In the take [s].
    std::span<const ExportCharacter>
        characters;                ///< In ascending order of ids; may grow and shrink within a take.
    const World* world = nullptr;  ///< At the first step not before that time. Never null.
};

/// What is going to come.
struct ExportInfo {
    std::string name;              ///< Of the scenario.
    double fps = 30.0;             ///< Frames a second > 0.
    double from = 0.0;             ///< Time of the first frame in the take [s].
    std::size_t frames = 0;        ///< Exactly so many will come, at least one.
    const World* world = nullptr;  ///< Before the take's first step. Only valid within begin().
};

/// Writes a take in some format. begin() once, frame() as often as said, finish() once; a call that fails is
/// the last.
class Exporter {
public:
    Exporter() = default;                ///< Nothing is open.
    Exporter(const Exporter&) = delete;  ///< A file has one writer.
    Exporter& operator=(const Exporter&) = delete;
    /// Removes what was written, unless finish() went well.
    virtual ~Exporter() = default;

    /// False where no poses are needed, which saves making them.
    virtual bool wantsPoses() const { return true; }
    /// Opens what is written to. Fails with IoError.
    virtual Status begin(const ExportInfo& info) = 0;
    /// Takes one frame; nothing of it may be kept by pointer.
    virtual Status frame(const ExportFrame& frame) = 0;
    /// Completes the file, so that it is in its place as a whole.
    virtual Status finish() = 0;
};

/// Replays `take`, the characters moved by the clips of `library`, and hands frames to `exporter`: positions
/// and poses between steps are interpolated. `progress` gets the share done; it may be empty. Fails with
/// InvalidArgument where the part does not lie in the take, with Corrupt where the replay gives other hashes,
/// and as the exporter does.
Status exportTake(const Take& take, const ClipLibrary& library, const ExportDef& def, Exporter& exporter,
                  const std::function<void(double)>& progress = {});

}  // namespace muster
