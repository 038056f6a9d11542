#include "site_writer.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "base/text_file.h"
#include "engine_files.h"
#include "json/json.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFileBytes = std::size_t{64} << 20;
constexpr const char* kMarker = "muster-site.json";  // Tells a folder that may be written again.
constexpr std::string_view kPageBegins = "<html ";
constexpr std::string_view kHeadEnds = "</head>";

Status addFile(FileTexts& files, const std::string& as, const fs::path& path) {
    auto bytes = readTextFile(path.string(), kMostFileBytes);
    if (!bytes.ok()) return bytes.status();
    files[as] = std::move(bytes).value();
    return {};
}

/// Replaces a text that must be there once.
Status replaceIn(std::string& text, std::string_view old, const std::string& by, const char* where) {
    const std::size_t at = text.find(old);
    if (at == std::string::npos)
        return {StatusCode::ParseError, std::string(where) + ": found no \"" + std::string(old) + "\""};
    text.replace(at, old.size(), by);
    return {};
}

/// The page's files; those of its folder `site` belong beside its first file.
Status addPage(const SiteDef& def, FileTexts& files) {
    for (const std::string& path : filesBelow(def.pageFolder)) {
        const bool ofSite = path.starts_with("site/");
        const Status added = addFile(files, ofSite ? path.substr(5) : path, fs::path(def.pageFolder) / path);
        if (!added.ok()) return added;
    }
    for (const char* needed : {"index.html", "service_worker.js", "manifest.webmanifest"})
        if (!files.contains(needed))
            return {StatusCode::NotFound, def.pageFolder + ": found no " + needed + "; build the page first"};
    std::string& page = files["index.html"];
    const std::string attributes = std::string(kPageBegins) + "data-engine=\"engine/\" data-scenario=\"" +
                                   def.scenario + "\" ";
    if (Status s = replaceIn(page, kPageBegins, attributes, "index.html"); !s.ok()) return s;
    return replaceIn(page, kHeadEnds,
                     "  <link rel=\"manifest\" href=\"manifest.webmanifest\" />\n  " + std::string(kHeadEnds),
                     "index.html");
}

Status addEngine(const SiteDef& def, FileTexts& files) {
    auto modules = engineModules(def.engineFolder);
    if (!modules.ok()) return modules.status();
    auto threads = threadModules(def.engineFolder);
    if (!threads.ok()) return threads.status();
    const bool hasThreads = !threads->empty();
    modules->merge(*threads);
    for (auto& [name, bytes] : *modules) files["engine/" + name] = std::move(bytes);
    if (!hasThreads) return {};
    return replaceIn(files["index.html"], kPageBegins, std::string(kPageBegins) + "data-threads ",
                     "index.html");
}

/// All scenarios in one file, and all gestures in another. Their number.
Result<std::size_t> addScenarios(const SiteDef& def, FileTexts& files) {
    auto texts = scenarioTexts(def.scenarioFolder, true);
    if (!texts.ok()) return texts.status();
    const std::vector<std::string>& names = texts->names;
    if (!def.scenario.empty() && std::find(names.begin(), names.end(), def.scenario) == names.end())
        return Status(StatusCode::NotFound,
                      def.scenarioFolder + ": no scenario is called '" + def.scenario + "'");
    files["engine/scenarios.json"] = std::move(texts->scenarios);
    files["engine/gestures.json"] = std::move(texts->gestures);
    return names.size();
}

/// The service worker learns which files there are, and a number that changes with any of them.
Status finishWorker(FileTexts& files) {
    const std::string version = versionOf(files);
    Json list = Json::array();
    list.push("./");
    for (const auto& [path, bytes] : files)
        if (path != "service_worker.js") list.push(path);
    std::string& worker = files["service_worker.js"];
    if (Status s = replaceIn(worker, "= FILES", "= " + compactJson(list), "service_worker.js"); !s.ok())
        return s;
    return replaceIn(worker, "muster-VERSION", "muster-" + version, "service_worker.js");
}

/// Empties the folder where it is an older site; refuses it where it holds something else.
Status makeRoom(const std::string& folder) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        return invalidArgument(folder + ": is a file, expected a folder");
    if (fs::is_directory(folder, error) && !fs::is_empty(folder, error)) {
        if (!fs::exists(fs::path(folder) / kMarker, error))
            return invalidArgument(folder + ": holds files that are no site; name an empty folder");
        for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
            fs::remove_all(entry.path(), error);
    }
    fs::create_directories(folder, error);
    if (error) return {StatusCode::IoError, folder + ": cannot be made: " + error.message()};
    return {};
}

}  // namespace

Result<SiteReport> writeSite(const SiteDef& def) {
    FileTexts files;
    if (Status s = addPage(def, files); !s.ok()) return s;
    if (Status s = addEngine(def, files); !s.ok()) return s;
    const auto scenarios = addScenarios(def, files);
    if (!scenarios.ok()) return scenarios.status();
    if (Status s = finishWorker(files); !s.ok()) return s;
    files[kMarker] = "{\"format\": \"muster-site\", \"version\": 1}\n";
    if (Status s = makeRoom(def.output); !s.ok()) return s;
    SiteReport report{.scenarios = *scenarios};
    for (const auto& [path, bytes] : files) {
        const fs::path full = fs::path(def.output) / path;
        std::error_code error;
        fs::create_directories(full.parent_path(), error);
        if (error) return Status(StatusCode::IoError, full.string() + ": " + error.message());
        if (Status s = writeTextFile(full.string(), bytes); !s.ok()) return s;
        ++report.files;
        report.bytes += bytes.size();
    }
    return report;
}

}  // namespace muster
