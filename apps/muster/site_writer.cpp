#include "site_writer.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "base/hash.h"
#include "base/text_file.h"
#include "json/json.h"
#include "muster/scenario.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFileBytes = std::size_t{64} << 20;
constexpr const char* kMarker = "muster-site.json";  // Tells a folder that may be written again.
constexpr const char* kEngineFiles[] = {"muster-engine.js", "muster-engine.wasm", "muster-exporter.js",
                                        "muster-exporter.wasm"};
constexpr std::string_view kHtmlBegins = "<html ";
constexpr std::string_view kHeadEnds = "</head>";

/// The files of a site by their paths in it.
using SiteFiles = std::map<std::string, std::string>;

Status addFile(SiteFiles& files, const std::string& as, const fs::path& path) {
    auto bytes = readTextFile(path.string(), kMostFileBytes);
    if (!bytes.ok()) return bytes.status();
    files[as] = std::move(bytes).value();
    return {};
}

/// The regular files below a folder, as paths relative to it, in their order.
std::vector<std::string> filesBelow(const fs::path& folder) {
    std::vector<std::string> found;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_regular_file(ignored))
            found.push_back(entry->path().lexically_relative(folder).generic_string());
    }
    std::sort(found.begin(), found.end());
    return found;
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
Status addPage(const SiteDef& def, SiteFiles& files) {
    for (const std::string& path : filesBelow(def.pageFolder)) {
        const bool ofSite = path.starts_with("site/");
        const Status added = addFile(files, ofSite ? path.substr(5) : path, fs::path(def.pageFolder) / path);
        if (!added.ok()) return added;
    }
    for (const char* needed : {"index.html", "service_worker.js", "manifest.webmanifest"})
        if (!files.contains(needed))
            return {StatusCode::NotFound, def.pageFolder + ": found no " + needed + "; build the page first"};
    std::string& page = files["index.html"];
    const std::string attributes = std::string(kHtmlBegins) + "data-engine=\"engine/\" data-scenario=\"" +
                                   def.scenario + "\" ";
    if (Status s = replaceIn(page, kHtmlBegins, attributes, "index.html"); !s.ok()) return s;
    return replaceIn(page, kHeadEnds,
                     "  <link rel=\"manifest\" href=\"manifest.webmanifest\" />\n  " + std::string(kHeadEnds),
                     "index.html");
}

Status addEngine(const SiteDef& def, SiteFiles& files) {
    for (const char* name : kEngineFiles) {
        const fs::path path = fs::path(def.engineFolder) / name;
        std::error_code ignored;
        if (!fs::is_regular_file(path, ignored))
            return {StatusCode::NotFound,
                    path.string() + ": the engine for browsers is not built; ./run -- site builds it"};
        if (Status s = addFile(files, std::string("engine/") + name, path); !s.ok()) return s;
    }
    return {};
}

/// All scenarios and gestures in one file: an object from paths to texts.
Result<std::size_t> addScenarios(const SiteDef& def, SiteFiles& files) {
    Json all = Json::object();
    std::size_t count = 0;
    bool first = def.scenario.empty();
    for (const std::string& path : filesBelow(def.scenarioFolder)) {
        if (!path.ends_with(".json") || path.starts_with("schema/") || path.find("/.") != std::string::npos)
            continue;
        const std::string full = (fs::path(def.scenarioFolder) / path).string();
        auto text = readTextFile(full);
        if (!text.ok()) return text.status();
        if (path.find("gestures/") == std::string::npos) {
            if (const auto read = loadScenario(full); !read.ok()) return read.status();
            ++count;
            first = first || path == def.scenario + ".json";
        }
        all[path] = std::move(text).value();
    }
    if (count == 0) return Status(StatusCode::NotFound, def.scenarioFolder + ": found no scenario");
    if (!first)
        return Status(StatusCode::NotFound,
                      def.scenarioFolder + ": no scenario is called '" + def.scenario + "'");
    files["engine/scenarios.json"] = compactJson(all);
    return count;
}

/// The service worker learns which files there are, and a number that changes with any of them.
Status finishWorker(SiteFiles& files) {
    Hash hash;
    Json list = Json::array();
    list.push("./");
    for (const auto& [path, bytes] : files) {
        hash.add(path);
        hash.add(bytes);
        if (path != "service_worker.js") list.push(path);
    }
    std::string& worker = files["service_worker.js"];
    if (Status s = replaceIn(worker, "= FILES", "= " + compactJson(list), "service_worker.js"); !s.ok())
        return s;
    return replaceIn(worker, "muster-VERSION", "muster-" + toHex(hash.value()), "service_worker.js");
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
    SiteFiles files;
    if (Status s = addPage(def, files); !s.ok()) return s;
    if (Status s = addEngine(def, files); !s.ok()) return s;
    const auto scenarios = addScenarios(def, files);
    if (!scenarios.ok()) return scenarios.status();
    if (Status s = finishWorker(files); !s.ok()) return s;
    files[kMarker] = "{\"format\": \"muster-site\", \"version\": 1}\n";
    if (Status s = makeRoom(def.output); !s.ok()) return s;
    SiteReport report;
    report.scenarios = *scenarios;
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
