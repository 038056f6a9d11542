// Web pages that play a crowd: one HTML file with everything in it, or a folder for a web host.
#pragma once

#include <string>
#include <string_view>

#include "muster/export.h"

namespace muster {

/// What a page with a player is made of.
struct PlayerParts {
    std::string script;  ///< muster-player.js.
    std::string page;    ///< HTML with {{title}}, {{script}} and {{source}}.
};
/// Reads both from the folder `player` of the built page. Fails with NotFound, naming what is missing.
Result<PlayerParts> readPlayerParts(const std::string& folder);

/// An HTML page with script and crowd in it, which opens without a web server. `crowd` is the file of an
/// export in the format "player".
std::string playerPage(const PlayerParts& parts, const std::string& title, std::string_view crowd);
/// Writes index.html, muster-player.js and crowd.muster-player into a new folder. Fails with IoError, and
/// with InvalidArgument where something of that name exists. A failure leaves no folder.
Status writePlayerFolder(const PlayerParts& parts, const std::string& title, const std::string& crowd,
                         const std::string& folder);

/// The formats of exports that are such pages.
inline constexpr ExportFormat kPlayerPage{"player-page", ".html",
                                          "one HTML file that plays the crowd in any browser"};
inline constexpr ExportFormat kPlayerFolder{"player-folder", "-player",
                                            "a folder for a web host: page, script and crowd"};
/// True for one of these two.
bool isPlayerPage(std::string_view format);
/// The format of that name, one of these or of exportFormats(). Fails with NotFound, naming all formats.
Result<ExportFormat> exportOrPageFormat(std::string_view name);
/// As exportTake(), and for these two formats as well; `playerFolder` is that of readPlayerParts().
Status exportTakeOrPage(const Take& take, const ClipLibrary& library, const ExportFormat& format,
                        const std::string& path, const ExportDef& def, const std::string& playerFolder,
                        const ExportProgress& progress);
/// Frames per second of a format where nobody says. Players draw as many pictures as the display shows.
double usualFps(std::string_view format);

}  // namespace muster
