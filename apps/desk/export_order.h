// Exports of takes on the shelf: what is asked for, and the file that is made of it.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "muster/export.h"
#include "take_shelf.h"

namespace muster {

/// An export that somebody asked for.
struct ExportOrder {
    std::string take;    ///< Path of the take.
    std::string format;  ///< As for exportTake().
    std::string title;   ///< The file's name, without its ending.
    double from = 0.0;   ///< [s]
    double to = -1.0;    ///< [s]; negative: the end.
    double fps = 30.0;
    bool speeds = true;                 ///< With the take's speeds, where the format has bodies in motion.
    std::vector<std::uint32_t> groups;  ///< As in ExportDef.
    std::uint32_t firstPerson = 0, lastPerson = 0xffffffffu;  ///< As in ExportDef.
    bool estimate = false;                                    ///< Only the size is asked for.
};

/// The clips that characters of a scenario move by.
using LoadClips = std::function<Result<ClipLibrary>(const std::string& name, const WorldDef& def)>;

/// What exports are made with.
struct ExportTools {
    LoadClips loadClips;       ///< May be empty: Muster's own clips.
    std::string playerFolder;  ///< That of readPlayerParts().
};

/// The order that a request's JSON text spells out, for a take on the shelf. Fails with InvalidArgument or
/// ParseError, naming the culprit, and with NotFound.
Result<ExportOrder> readExportOrder(const std::string& text, TakeShelf& shelf);
/// The name under which its file is saved: "first-take.glb". Fails with NotFound for an unknown format.
Result<std::string> exportFileName(const ExportOrder& order);
/// Makes the file. `progress` is told the share that is done, 0 to 1, and returns false to end it. Fails like
/// readTake and exportTake.
Status writeExport(const ExportOrder& order, const ExportTools& tools, const std::string& path,
                   const std::function<bool(double)>& progress);
/// What writeExport() will make; `path` is used meanwhile. `goOn` returns false to end it. Fails like
/// writeExport().
Result<ExportEstimate> estimateExport(const ExportOrder& order, const ExportTools& tools,
                                      const std::string& path, const std::function<bool()>& goOn);

}  // namespace muster
