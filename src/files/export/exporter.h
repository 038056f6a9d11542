// The interface of all export formats: a take is replayed and its frames are passed on one by one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "muster/clip.h"
#include "muster/export.h"
#include "muster/take.h"
#include "muster/world.h"
#include "people/motion/shown_character.h"

namespace muster {

/// A character in one frame.
struct ExportCharacter {
    std::uint32_t id = 0;     ///< Id of the character; it is the same in the whole take.
    std::uint32_t group = 0;  ///< Index of the character's group.
    Vec2 position;            ///< Origin of the character's own frame, on the ground [m].
    float yaw = 0.0f;         ///< The character faces (cos yaw, sin yaw) [rad].
    float size = 1.0f;        ///< Scale of the skeleton; it applies to the hips and offsets of the pose.
    const BodyPose* pose = nullptr;  ///< The pose for a body of size 1; null where the exporter needs none.
    std::uint16_t clip = 0;          ///< Index into the library of the clip it plays, where clips are wanted.
    float clipTime = 0.0f;           ///< Time in that clip [s], within one play.
    float fade = 0.0f;               ///< Share of the clip before that is still shown, 0 to 1.
};

/// The state at one moment of a take; it may lie between two steps of the simulation.
struct ExportFrame {
    std::size_t index = 0;  ///< Number of the frame, from 0.
    double time = 0.0;      ///< Time in the take [s].
    std::span<const ExportCharacter>
        characters;                         ///< Ordered by id. Characters may appear and leave within a take.
    const World* world = nullptr;           ///< The world at the first step not before that time. Never null.
    std::span<const ShownCharacter> shown;  ///< Who is shown otherwise than in that world, by ids.
};

/// Facts about an export, known before its first frame.
struct ExportInfo {
    std::string name;              ///< The scenario's name.
    double fps = 30.0;             ///< Frames per second, > 0.
    double from = 0.0;             ///< Time of the first frame in the take [s].
    std::size_t frames = 0;        ///< Exact number of frames, at least one.
    const World* world = nullptr;  ///< The world before the take's first step. Only valid within begin().
    const ClipLibrary* clips = nullptr;  ///< The clips that characters move by; valid until finish().
    std::optional<std::size_t> chosen;   ///< Characters of that world that are exported; none: all.

    /// Characters that are exported, of those before the first step.
    std::size_t people() const { return chosen.value_or(world->characters().size()); }
};

/// Writes a take in some format. The calls are begin() once, frame() once per frame and finish() once; none
/// follows a call that fails.
class Exporter {
public:
    Exporter() = default;                ///< Opens nothing.
    Exporter(const Exporter&) = delete;  ///< A file has one writer.
    Exporter& operator=(const Exporter&) = delete;
    /// Removes the written files, unless finish() succeeded.
    virtual ~Exporter() = default;

    /// False where the format needs no poses; they are not computed then.
    virtual bool wantsPoses() const { return true; }
    /// True where the format needs to know which clips are played; so it is where it needs poses.
    virtual bool wantsClips() const { return wantsPoses(); }
    /// Opens the output. Fails with IoError.
    virtual Status begin(const ExportInfo& info) = 0;
    /// Writes one frame. It must not keep pointers into it.
    virtual Status frame(const ExportFrame& frame) = 0;
    /// Completes the file and moves it to its final path.
    virtual Status finish() = 0;
};

/// The times of an export's frames in the take [s]; `def.to` becomes the time of the end where it is
/// negative. Fails with InvalidArgument, naming what does not fit the take.
Result<std::vector<double>> exportTimes(const Take& take, ExportDef& def);

/// Replays `take` with the clips of `library` and passes its frames to `exporter`. Positions and poses
/// between steps are interpolated. `progress` is called with the completed share; it may be empty. Fails with
/// InvalidArgument where the part does not lie in the take, with Corrupt where a simulation gives other
/// hashes, with Unsupported where `progress` returns false or the take has no stored frames and `from` asks
/// for them, and with the exporter's failures.
Status exportTake(const Take& take, const ClipLibrary& library, const ExportDef& def, Exporter& exporter,
                  const ExportProgress& progress = {}, ReplayFrom from = ReplayFrom::Simulation);

}  // namespace muster
