// Export of takes as animated bodies or trajectories for other programs.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/clip.h"
#include "muster/status.h"
#include "muster/take.h"

namespace muster {

/// A file format of exports.
struct ExportFormat {
    const char* name;    ///< Unique name: "glb", "bvh"...
    const char* ending;  ///< Ending of the file name (".glb"), or of the folder that bvh writes ("-bvh").
    const char* about;   ///< Description in one line.
};

/// All formats of this build.
std::span<const ExportFormat> exportFormats();
/// The format of that name. Fails with NotFound, naming all formats.
Result<ExportFormat> exportFormat(std::string_view name);

/// The part of a take to export, and the frame rate.
struct ExportDef {
    double from = 0.0;         ///< Time of the first frame [s] >= 0.
    double to = -1.0;          ///< Time of the last frame [s] >= from, within the take; negative: its end.
    double fps = 30.0;         ///< Frames per second, 1 to 240.
    std::int32_t threads = 1;  ///< Number of threads, as for World::create.
    /// Faster and slower parts: frames lie closer together in the take, or farther apart. The exported motion
    /// still has `fps` frames per second.
    std::vector<SpeedPiece> speeds;
    /// Ids of groups; none: everybody. Who belongs to one of them when first seen in the part stays to its
    /// end.
    std::vector<std::uint32_t> groups;
    std::uint32_t firstPerson = 0;           ///< Smallest id of a character.
    std::uint32_t lastPerson = 0xffffffffu;  ///< Largest id of a character.
};

/// Gets the share done, 0 to 1; false ends the export.
using ExportProgress = std::function<bool(double)>;

/// Replays `take`, its characters moved by the clips of `library`, and writes `path` in the format of that
/// name. Positions and poses between steps are interpolated. Where the replay gives other hashes, as takes of
/// another version may, characters move as the stored frames of the take say, and progress begins again.
/// `progress` may be empty; where it returns false the export fails with Unsupported. A failed export leaves
/// no file. Fails as exportFormat() does; with InvalidArgument where the part does not lie in the take, or
/// nobody in it was chosen; with Corrupt where the replay gives other hashes and the take has no stored
/// frames; with LimitExceeded where the format cannot hold so much; with Unsupported where this build cannot
/// write the format; with IoError.
Status exportTake(const Take& take, const ClipLibrary& library, std::string_view format,
                  const std::string& path, const ExportDef& def = {}, const ExportProgress& progress = {});

/// What an export will be, as far as it can be known before.
struct ExportEstimate {
    double bytes = 0.0;      ///< Of the file, or of all files together.
    std::size_t people = 0;  ///< Characters that were chosen.
    std::size_t frames = 0;  ///< Moments of the take.
};

/// Writes a part of the take, as exportTake() does, to the path.
using WriteExportPart = std::function<Status(const ExportDef&, const std::string& path)>;

/// Tells how large an export by `write` will be. Small parts of the beginning of the take are written to
/// `path` and removed again, and the rest follows from its stored frames. Fails as exportTake() does.
Result<ExportEstimate> estimateExport(const Take& take, std::string_view format, const ExportDef& def,
                                      const std::string& path, const WriteExportPart& write);

}  // namespace muster
