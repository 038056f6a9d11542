// muster check
#include <memory>
#include <string>
#include <vector>

#include "base/text_file.h"
#include "commands.h"
#include "muster/scenario.h"
#include "muster/take.h"
#include "report.h"

namespace muster {
namespace {

struct CheckOptions {
    std::vector<std::string> files;
    bool schema = false;
    bool gesturesSchema = false;
    bool json = false;
};

/// The result for one file.
struct Finding {
    std::string kind = "unknown";
    Status status;
    std::string summary;
    std::vector<std::string> warnings;
};

std::int64_t charactersOf(const WorldDef& def) {
    std::int64_t sum = 0;
    for (const GroupDef& group : def.groups) sum += group.count;
    return sum;
}

void checkScenario(const WorldDef& def, const std::string& path, Finding& finding) {
    finding.summary = "\"" + def.name + "\", " + std::to_string(charactersOf(def)) + " characters, " +
                      std::to_string(def.obstacles.size()) + " obstacles, " +
                      std::to_string(def.patches.size()) + " patches";
    if (def.map)
        finding.summary += ", a map of " + std::to_string(def.map->grid.width) + " x " +
                           std::to_string(def.map->grid.height) + " cells";
    const auto gestures = loadScenarioGestures(path, def);
    finding.status = gestures.ok() ? Status() : gestures.status();
    if (!gestures.ok()) return;
    if (!def.gestures.empty())
        finding.summary += ", gestures of " + std::to_string(gestures->size()) + " events";
    const auto world = World::create(def);
    finding.status = world.ok() ? Status() : world.status().within(path);
    if (world.ok()) finding.warnings = scenarioWarnings(def);
}

void checkTake(const std::string& path, Finding& finding) {
    finding.kind = "take";
    const auto take = readTake(path);
    finding.status = take.ok() ? Status() : take.status();
    if (!take.ok()) return;
    finding.summary = "\"" + take->def.name + "\", " + std::to_string(take->commands.size()) + " commands, " +
                      std::to_string(take->events.size()) + " events, " + std::to_string(take->marks.size()) +
                      " hash marks, " + std::to_string(take->steps()) + " steps";
    std::size_t edited = 0;
    for (const TakeEdit& edit : take->about.edits) edited += edit.people.size();
    if (edited > 0) finding.summary += ", edits of " + std::to_string(edited) + " people";
    if (take->tornBytes > 0) {
        finding.warnings.push_back("the last record is torn; " + std::to_string(take->tornBytes) +
                                   " bytes are left out");
    } else if (!take->finished) {
        finding.warnings.push_back("it was never finished: there is no end record");
    }
    if (const std::uint32_t unmarked = take->steps() - take->markedSteps(); unmarked > 0)
        finding.warnings.push_back("its last " + std::to_string(unmarked) + " steps bear no hash");
}

Finding checkFile(const std::string& path) {
    Finding finding;
    const auto text = readTextFile(path, std::size_t{1} << 30);
    if (!text.ok()) {
        finding.status = text.status();
        return finding;
    }
    if (text->rfind("MUSTAKE", 0) == 0) {
        checkTake(path, finding);
    } else if (text->substr(0, 400).find("muster-gestures") != std::string::npos) {
        finding.kind = "gestures";
        const auto commands = parseGestures(*text, path, Parameters{}.stepTime);
        finding.status = commands.ok() ? Status() : commands.status();
        if (commands.ok()) finding.summary = std::to_string(commands->size()) + " events";
    } else {
        finding.kind = "scenario";
        const auto def = loadScenario(path);
        finding.status = def.ok() ? Status() : def.status();
        if (def.ok()) checkScenario(*def, path, finding);
    }
    return finding;
}

void print(const std::string& path, const Finding& finding) {
    if (!finding.status.ok()) {
        std::fprintf(stderr, "muster: %s\n", finding.status.message().c_str());
        return;
    }
    std::printf("%s: a good %s: %s\n", path.c_str(), finding.kind.c_str(), finding.summary.c_str());
    for (const std::string& warning : finding.warnings)
        std::printf("%s: warning: %s\n", path.c_str(), warning.c_str());
}

int check(const CheckOptions& options) {
    if (options.schema) {
        std::printf("%s", scenarioSchema().c_str());
        return kExitOk;
    }
    if (options.gesturesSchema) {
        std::printf("%s", gesturesSchema().c_str());
        return kExitOk;
    }
    if (options.files.empty()) {
        std::fprintf(stderr,
                     "muster: check: found no file, expected one or --schema (see muster check --help)\n");
        return kExitUsage;
    }
    int code = kExitOk;
    Json results = Json::array();
    for (const std::string& path : options.files) {
        const Finding finding = checkFile(path);
        if (!finding.status.ok()) code = kExitFailure;
        if (!options.json) {
            print(path, finding);
            continue;
        }
        Json entry = {{"file", path}, {"kind", finding.kind}, {"good", finding.status.ok()}};
        entry["summary"] = finding.summary;
        entry["error"] = finding.status.ok() ? Json(nullptr) : Json(finding.status.message());
        entry["warnings"] = Json::arrayOf(finding.warnings);
        results.push(std::move(entry));
    }
    if (options.json) printJsonValue(results);
    return code;
}

}  // namespace

void addCheckCommand(CommandLine& line) {
    Subcommand command = line.add("check", "Says whether scenario, gesture and take files are good.");
    auto options = std::make_shared<CheckOptions>();
    command.option("FILES", options->files, "Files of any of the three kinds.");
    command.flag("--schema", options->schema, "Prints the JSON Schema of scenario files instead.");
    command.flag("--gestures-schema", options->gesturesSchema, "Prints that of gesture files instead.");
    command.flag("--json", options->json, "One JSON array on standard output, an object per file.");
    command.footer(
        "Ends with 1 where any file is bad. Warnings (gaps too narrow, starts in obstacles,\n"
        "exits that nobody can come into...) change nothing.\n"
        "Examples:\n"
        "  muster check scenarios/*.json\n"
        "  muster check cars.take --json\n"
        "  muster check --schema > scenario.schema.json");
    command.run([options] { return check(*options); });
}

}  // namespace muster
