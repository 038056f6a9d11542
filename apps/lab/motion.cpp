// muster motion
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lab_commands.h"
#include "lab_commands_list.h"
#include "motion_bodies.h"
#include "motion_parts.h"
#include "muster/own_clips.h"
#include "people/clips/clip_files.h"
#include "people/clips/motion_facts.h"
#include "people/clips/retarget.h"
#include "report.h"

namespace muster {
namespace {

struct MotionOptions {
    std::vector<std::string> clips;
    std::string run;
    std::string unit;
    std::string folder;
    std::string strips;
    std::string bodies;
    bool measure = false;
    bool json = false;
    MeasureOptions measured;
};

/// A row of the table.
struct Row {
    std::string clip;
    std::string file;  ///< Empty for Muster's own clips.
    MotionFacts facts;
};

/// Metres of a unit given by name or number; 0 where the unit is guessed.
Result<double> unitNamed(const std::string& name) {
    static constexpr std::pair<const char*, double> kUnits[] = {
        {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}, {"cmu", 0.0254 / 0.45}};
    if (name.empty()) return 0.0;
    for (const auto& [known, metres] : kUnits)
        if (name == known) return metres;
    char* end = nullptr;
    const double metres = std::strtod(name.c_str(), &end);
    if (*end == '\0' && metres >= 1e-6 && metres <= 1e3) return metres;
    return invalidArgument("unit: found \"" + name.substr(0, 40) +
                           "\", expected m, cm, mm, in, ft, cmu or a number of metres");
}

Row ownRow(const Clip& clip) {
    return {clip.name, {}, factsOf(clip)};
}

/// The clips that a name on the command line refers to.
struct Named {
    std::vector<Clip> clips;  ///< One of Muster's own clips, or those of a folder.
    bool own = false;
    std::optional<BvhMotion> motion;  ///< The motion of a file.
};

Result<Named> named(const std::string& name, double unit) {
    Named found;
    if (const Clip* own = ownClips().find(name)) {
        found.clips.push_back(*own);
        found.own = true;
        return found;
    }
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored))
        return Status(StatusCode::NotFound,
                      name + ": is none of Muster's clips, and there is no such file or folder");
    if (std::filesystem::is_directory(name, ignored)) {
        auto library = loadClips(name);
        if (!library.ok()) return library.status();
        found.clips = std::move(library).value().clips;
        return found;
    }
    auto motion = readBvh(name, {unit});
    if (!motion.ok()) return motion.status();
    found.motion = std::move(motion).value();
    return found;
}

std::string stemOf(const std::string& file) {
    return std::filesystem::path(file).stem().string();
}

Status addRow(const std::string& name, double unit, std::vector<Row>& rows) {
    const auto found = named(name, unit);
    if (!found.ok()) return found.status();
    for (const Clip& clip : found->clips)
        rows.push_back(found->own ? ownRow(clip)
                                  : Row{clip.name, name + "/" + clip.name + ".bvh", factsOf(clip)});
    if (found->motion) rows.push_back({stemOf(name), name, factsOf(*found->motion)});
    return {};
}

/// "left foot 2, right foot 3", shortened: "2 LF, 3 RF".
std::string contactsText(const std::vector<Contact>& contacts) {
    static constexpr const char* kShort[kLimbCount] = {"LF", "RF", "LH", "RH", "LK", "RK"};
    std::string text;
    for (std::size_t limb = 0; limb < kLimbCount; ++limb) {
        std::size_t count = 0;
        for (const Contact& contact : contacts)
            count += static_cast<std::size_t>(contact.limb) == limb ? 1 : 0;
        if (count > 0) text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + kShort[limb];
    }
    return text.empty() ? "-" : text;
}

Json rowJson(const Row& row, double run) {
    Json json = {{"clip", row.clip}, {"file", row.file.empty() ? Json(nullptr) : Json(row.file)}};
    json["frames"] = row.facts.frames;
    json["rate"] = row.facts.rate;
    json["duration_s"] = row.facts.duration;
    json["length_m"] = row.facts.length;
    json["speed_mps"] = row.facts.speed;
    json["ratio"] = speedRatio(row.facts.speed, run);
    json["cyclic"] = row.facts.cyclic;
    json["contacts"] = Json::array();
    for (const Contact& c : row.facts.contacts)
        json["contacts"].push({{"limb", limbName(c.limb)}, {"begin_s", c.begin}, {"end_s", c.end}});
    return json;
}

void print(const std::vector<Row>& rows, double run) {
    std::size_t width = 4;
    for (const Row& row : rows) width = std::max(width, row.clip.size());
    const int w = static_cast<int>(width);
    std::printf("%-*s  frames  duration s  length m  speed m/s  ratio  cyclic  contacts\n", w, "clip");
    for (const Row& row : rows) {
        const MotionFacts& f = row.facts;
        std::printf("%-*s  %6zu  %10.3f  %8.3f  %9.3f  %5.2f  %-6s  %s\n", w, row.clip.c_str(), f.frames,
                    f.duration, f.length, f.speed, speedRatio(f.speed, run), f.cyclic ? "yes" : "no",
                    contactsText(f.contacts).c_str());
    }
    std::printf("Ratios are to running at %.3f m/s. Contacts: left and right foot, hand and knee.\n", run);
}

/// Speed of the clip that speed ratios refer to [m/s].
Result<double> runSpeed(const MotionOptions& options, double unit) {
    std::vector<Row> rows;
    if (options.run.empty()) {
        const Clip* run = ownClips().find("run");
        return run != nullptr ? run->speed() : kUsualRun;
    }
    if (Status s = addRow(options.run, unit, rows); !s.ok()) return s;
    if (rows.size() != 1 || !(rows[0].facts.speed > 0.0))
        return invalidArgument("run: " + options.run + ": expected one clip that goes somewhere");
    return rows[0].facts.speed;
}

/// Muster's own clips by name, a folder's clips, or a file's motion retargeted to Muster's skeleton.
Status addClips(const std::string& name, double unit, std::vector<Clip>& clips) {
    auto found = named(name, unit);
    if (!found.ok()) return found.status();
    for (Clip& clip : found->clips) clips.push_back(std::move(clip));
    if (!found->motion) return {};
    auto clip = retarget(*found->motion, {stemOf(name), "run", {}});
    if (!clip.ok()) return clip.status().within(name);
    clips.push_back(std::move(clip).value());
    return {};
}

Status drawStrips(const MotionOptions& options, double unit) {
    std::vector<Clip> clips;
    for (const std::string& name : options.clips)
        if (Status s = addClips(name, unit, clips); !s.ok()) return s;
    return writeStrips(options.clips.empty() ? ownClips().clips : clips, options.strips);
}

/// The outputs requested besides the table.
Status writeFiles(const MotionOptions& options, double unit) {
    if (!options.folder.empty())
        if (Status s = writeClips(ownClips(), options.folder); !s.ok()) return s;
    if (!options.bodies.empty())
        if (Status s = writeBodies(options.bodies); !s.ok()) return s;
    return options.strips.empty() ? Status() : drawStrips(options, unit);
}

int measure(const MotionOptions& options) {
    MeasureOptions measured = options.measured;
    measured.scenarios = options.clips;
    measured.json = options.json;
    if (measured.scenarios.empty())
        return reportFailure(invalidArgument("--measure: found no scenario, expected at least one file"));
    return measureMotion(measured);
}

int motion(const MotionOptions& options) {
    if (options.measure) return measure(options);
    const auto unit = unitNamed(options.unit);
    if (!unit.ok()) return reportFailure(unit.status());
    if (Status s = writeFiles(options, *unit); !s.ok()) return reportFailure(s);
    const auto run = runSpeed(options, *unit);
    if (!run.ok()) return reportFailure(run.status());
    std::vector<Row> rows;
    for (const std::string& name : options.clips)
        if (Status s = addRow(name, *unit, rows); !s.ok()) return reportFailure(s);
    if (options.clips.empty())
        for (const Clip& clip : ownClips().clips) rows.push_back(ownRow(clip));
    if (!options.json) {
        print(rows, *run);
        return kExitOk;
    }
    Json list = Json::array();
    for (const Row& row : rows) list.push(rowJson(row, *run));
    printJsonValue(list);
    return kExitOk;
}

}  // namespace

void addMotionCommand(CommandLine& line) {
    Subcommand command = line.add(kMotionCommand.name, kMotionCommand.about);
    auto options = std::make_shared<MotionOptions>();
    command.option("CLIPS", options->clips,
                   "Names of Muster's own clips, BVH files, or folders with a clips.json; all of "
                   "Muster's own if left out.");
    command.option("--run", options->run, "Ratios are to this clip; left out: Muster's own run.");
    command.option("--unit", options->unit,
                   "Unit of the files: m, cm, mm, in, ft, cmu or a number of metres; left out: guessed "
                   "by the size of the body.");
    command.option("--write", options->folder,
                   "Also writes Muster's own clips into this folder, as BVH with a clips.json.");
    command.option("--strip", options->strips,
                   "Also draws each clip as a strip of poses into this folder, as SVG.");
    command.option("--bodies", options->bodies,
                   "Also writes the characters' bodies into this folder, as binary glTF.");
    const Option measuring = command.flag(
        "--measure", options->measure,
        "CLIPS are scenarios: plays them with their gestures and tells how far feet slide, how fast knees "
        "turn and how deep limbs go below the floor.");
    command.option("--count", options->measured.count, "Characters of the first group, for --measure.")
        .range(1, 5000)
        .needs(measuring);
    command
        .option("--seconds", options->measured.seconds,
                "Simulated, for --measure; left out: until all stand.")
        .range(0.1, 3600.0)
        .needs(measuring);
    command.option("--clips", options->measured.clips, "Folder of clips to play, for --measure.")
        .needs(measuring);
    command.flag("--json", options->json, "One JSON array on standard output, an object per clip.");
    command.footer(
        "Speed is the net way over the duration. Ratios are what scenarios call a clip's speed; the least is "
        "0.02.\n"
        "Examples:\n"
        "  muster motion\n"
        "  muster motion walk.bvh run.bvh --run run.bvh\n"
        "  muster motion --write motions --json\n"
        "  muster motion --measure scenarios/paper/x04-woodland.json");
    command.run([options] { return motion(*options); });
}

}  // namespace muster
