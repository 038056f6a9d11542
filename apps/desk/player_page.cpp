#include "player_page.h"

#include <array>
#include <filesystem>
#include <utility>

#include "base/base64.h"
#include "base/text_file.h"
#include "files/report/markup.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScriptName = "muster-player.js", kPageName = "page.html",
                           kCrowdName = "crowd.muster-player";
constexpr double kPlayerFps = 15.0;
constexpr std::size_t kMostCrowdBytes = std::size_t{256} << 20;

/// The text with each of these words replaced; what comes in place of one is not looked through again.
std::string filled(std::string_view text,
                   const std::array<std::pair<std::string_view, std::string>, 3>& words) {
    std::string out;
    while (!text.empty()) {
        std::size_t first = text.size();
        const std::pair<std::string_view, std::string>* found = nullptr;
        for (const auto& word : words) {
            const std::size_t at = text.find(word.first);
            if (at < first) first = at, found = &word;
        }
        out += text.substr(0, first);
        if (found == nullptr) break;
        out += found->second;
        text.remove_prefix(first + found->first.size());
    }
    return out;
}

/// A script that may stand within a page.
std::string inlineScript(std::string_view script) {
    static constexpr std::string_view kEnd = "</script";
    std::string out = "<script type=\"module\">\n";
    for (std::size_t at = script.find(kEnd); at != std::string_view::npos; at = script.find(kEnd)) {
        out += script.substr(0, at);
        out += "<\\/script";
        script.remove_prefix(at + kEnd.size());
    }
    out += script;
    out += "\n    </script>";
    return out;
}

std::string page(const PlayerParts& parts, const std::string& title, std::string script, std::string source) {
    return filled(parts.page, {{{"{{title}}", escaped(title)},
                                {"{{script}}", std::move(script)},
                                {"{{source}}", std::move(source)}}});
}

}  // namespace

Result<PlayerParts> readPlayerParts(const std::string& folder) {
    PlayerParts parts;
    for (const auto& [name, part] :
         {std::pair{kScriptName, &parts.script}, std::pair{kPageName, &parts.page}}) {
        const fs::path path = fs::path(folder) / name;
        std::error_code ignored;
        if (!fs::is_regular_file(path, ignored))
            return Status(StatusCode::NotFound,
                          path.string() + ": is not there; build the page first (./run does)");
        auto text = readTextFile(path.string());
        if (!text.ok()) return text.status();
        *part = std::move(text).value();
    }
    return parts;
}

std::string playerPage(const PlayerParts& parts, const std::string& title, std::string_view crowd) {
    return page(parts, title, inlineScript(parts.script),
                "data:application/octet-stream;base64," +
                    base64({reinterpret_cast<const std::uint8_t*>(crowd.data()), crowd.size()}));
}

Status writePlayerFolder(const PlayerParts& parts, const std::string& title, const std::string& crowd,
                         const std::string& folder) {
    std::error_code error;
    if (fs::exists(folder, error)) return invalidArgument(folder + ": exists already; name a new folder");
    fs::create_directories(folder, error);
    if (error) return {StatusCode::IoError, folder + ": cannot be made: " + error.message()};
    const std::string script = "<script type=\"module\" src=\"" + std::string(kScriptName) + "\"></script>";
    Status status;
    for (const auto& [name, text] :
         {std::pair{std::string_view("index.html"), page(parts, title, script, std::string(kCrowdName))},
          std::pair{kScriptName, parts.script}, std::pair{kCrowdName, crowd}})
        if (status.ok()) status = writeTextFile((fs::path(folder) / name).string(), text);
    if (!status.ok()) fs::remove_all(folder, error);
    return status;
}

bool isPlayerPage(std::string_view format) {
    return format == kPlayerPage.name || format == kPlayerFolder.name;
}

Result<ExportFormat> exportOrPageFormat(std::string_view name) {
    for (const ExportFormat& format : {kPlayerPage, kPlayerFolder})
        if (name == format.name) return format;
    auto format = exportFormat(name);
    if (format.ok()) return format;
    return Status(format.status().code(),
                  format.status().message() + ", " + kPlayerPage.name + ", " + kPlayerFolder.name);
}

Status exportTakeOrPage(const Take& take, const ClipLibrary& library, const ExportFormat& format,
                        const std::string& path, const ExportDef& def, const std::string& playerFolder,
                        const ExportProgress& progress) {
    if (!isPlayerPage(format.name)) return exportTake(take, library, format.name, path, def, progress);
    const auto parts = readPlayerParts(playerFolder);
    if (!parts.ok()) return parts.status();
    const std::string file = path + ".muster-player";
    std::error_code ignored;
    if (fs::exists(file, ignored)) return invalidArgument(file + ": exists already, and is needed meanwhile");
    if (Status s = exportTake(take, library, "player", file, def, progress); !s.ok()) return s;
    const auto crowd = readTextFile(file, kMostCrowdBytes);
    fs::remove(file, ignored);
    if (!crowd.ok()) return crowd.status();
    const std::string title = take.about.title.empty() ? take.def.name : take.about.title;
    if (std::string_view(format.name) == kPlayerFolder.name)
        return writePlayerFolder(*parts, title, *crowd, path);
    return writeTextFile(path, playerPage(*parts, title, *crowd));
}

double usualFps(std::string_view format) {
    return format == "player" || isPlayerPage(format) ? kPlayerFps : ExportDef{}.fps;
}

}  // namespace muster
