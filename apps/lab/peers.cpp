// muster peers
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/text_file.h"
#include "engine/state/validation.h"
#include "lab_commands.h"
#include "lab_commands_list.h"
#include "muster/scenario.h"
#include "options.h"
#include "overrides.h"
#include "report.h"
#include "runner.h"

namespace muster {
namespace {

// Largest number of characters for which one cost field per place is practicable.
constexpr std::size_t kLargestExact = 1000;
constexpr double kLongest = 1e6;  // Largest time in a scene [s].

struct PeersOptions {
    std::string file;
    std::string scene;
    std::string trajectory;
    Overrides overrides;
    int threads = 1;
    bool inertia = false;
    bool json = false;
};

/// A scene and its time limit.
struct Scene {
    std::string name;
    WorldDef def;
    double limit = 120.0;  ///< [s]
};

std::string sceneName(const std::string& file, const std::string& scene) {
    return file + ": $.scenes." + scene;
}

bool readPoints(const Json& list, std::vector<Vec2>& points) {
    if (!list.isArray()) return false;
    for (const Json& p : list.elements()) {
        if (!p.isArray() || p.size() < 2 || !p[0].isNumber() || !p[1].isNumber()) return false;
        points.push_back({p[0].number(), p[1].number()});
    }
    return true;
}

/// The value of a key, or `none` where it is missing.
const Json& valueOf(const Json& object, std::string_view key, const Json& none) {
    const Json* found = object.find(key);
    return found != nullptr ? *found : none;
}

bool readObstacles(const Json& scene, WorldDef& def) {
    const Json none = Json::array();
    const Json &polygons = valueOf(scene, "polygons_ccw", none), &circles = valueOf(scene, "circles", none);
    if (!polygons.isArray() || !circles.isArray()) return false;
    for (const Json& corners : polygons.elements()) {
        if (!readPoints(corners, def.obstacles.emplace_back().polygon)) return false;
    }
    for (const Json& circle : circles.elements()) {
        if (!circle.isArray() || circle.size() != 3 || !circle[0].isNumber() || !circle[1].isNumber() ||
            !circle[2].isNumber()) {
            return false;
        }
        ObstacleDef& disc = def.obstacles.emplace_back();
        disc.centre = {circle[0].number(), circle[1].number()};
        disc.radius = circle[2].number();
    }
    return true;
}

/// Makes explicit starts, and slots as a formation that stands still. Nothing may displace the slots.
Result<Scene> readScene(const std::string& name, const Json& json, const PeersOptions& options) {
    const auto bad = [&](const char* key, const std::string& expected) {
        return Status(StatusCode::ParseError, sceneName(options.file, name) + "." + key +
                                                  ": found something else, expected " + expected);
    };
    Scene scene{.name = name};
    GroupDef group{.formation = {.kind = FormationKind::Points}};
    if (!json.isObject()) return bad("", "an object");
    const Json none, &box = valueOf(json, "world", none);
    if (!box.isArray() || box.size() != 4 ||
        !std::ranges::all_of(box.elements(), [](const Json& v) { return v.isNumber(); })) {
        return bad("world", "[x0, y0, x1, y1]");
    }
    scene.def.box = {{box[0].number(), box[1].number()}, {box[2].number(), box[3].number()}};
    if (!readPoints(valueOf(json, "start", none), group.starts)) return bad("start", "points [x, y]");
    if (!readPoints(valueOf(json, "slots", none), group.formation.points))
        return bad("slots", "points [x, y]");
    if (!readObstacles(json, scene.def))
        return bad("polygons_ccw or circles", "corners [x, y] or [x, y, radius]");
    const Json& limit = valueOf(json, "T", none);
    if (!limit.isNumber()) return bad("T", "a number of seconds");
    scene.limit = limit.number();
    if (!(scene.limit > 0.0 && scene.limit <= kLongest))
        return bad("T", "seconds, more than 0 and at most 1e6");
    if (group.starts.empty() || group.starts.size() > static_cast<std::size_t>(kMaxCharacters))
        return bad("start", "1 to " + std::to_string(kMaxCharacters) + " points");
    group.count = static_cast<std::int32_t>(group.starts.size());
    scene.def.name = name;
    scene.def.groups.push_back(std::move(group));
    scene.def.parameters.stepTime = 1.0 / 60.0;
    scene.def.parameters.character.radius = 0.25;
    scene.def.parameters.character.maxSpeed = 2.0;
    scene.def.parameters.field.enabled = false;
    if (!options.inertia) {
        // Allows any change of velocity within a step.
        scene.def.parameters.character.velocityGain = 60.0;
        scene.def.parameters.character.acceleration = 1000.0;
    }
    if (Status s = validate(scene.def); !s.ok()) return s.within(sceneName(options.file, name));
    if (Status s = options.overrides.apply(scene.def); !s.ok()) return s;
    return scene;
}

std::size_t countOf(const WorldDef& def) {
    return static_cast<std::size_t>(def.groups.front().count);
}

Result<std::vector<Scene>> readScenes(const PeersOptions& options) {
    const auto text = readTextFile(options.file);
    if (!text.ok()) return text.status();
    const auto json = parseJson(*text, options.file);
    const Json* bodies = json.ok() ? json->find("scenes") : nullptr;
    if (bodies == nullptr || !bodies->isObject())
        return Status(StatusCode::ParseError,
                      options.file + ": $.scenes: found none, expected an object of scenes");
    std::vector<Scene> scenes;
    for (const auto& [name, body] : bodies->members()) {
        if (!options.scene.empty() && name != options.scene) continue;
        auto scene = readScene(name, body, options);
        if (!scene.ok()) return scene.status();
        const WorldDef& def = scene->def;
        const bool exact = def.parameters.plan.solver == PlanSolver::Exact;
        if (options.scene.empty() && exact && countOf(def) > kLargestExact) {
            std::fprintf(stderr,
                         "muster: %s is left out: %zu characters are too many for the exact plan; --plan "
                         "fast takes them\n",
                         name.c_str(), countOf(def));
            continue;
        }
        scenes.push_back(std::move(scene).value());
    }
    if (!scenes.empty()) return scenes;
    return Status(StatusCode::NotFound,
                  options.file + ": $.scenes: found no scene \"" + options.scene + "\"");
}

/// One CSV file per scene: PATH itself for one scene, otherwise PATH-SCENE with the extension of PATH.
/// Characters that are unsuitable for a file name become "-".
std::vector<std::string> trajectoryFiles(const std::string& path, const std::vector<Scene>& scenes) {
    if (path.empty() || scenes.size() == 1) return std::vector<std::string>(scenes.size(), path);
    const std::filesystem::path whole(path);
    std::vector<std::string> files;
    for (const Scene& scene : scenes) {
        std::string name = scene.name.substr(0, 100);
        for (char& c : name) {
            const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                               c == '_' || c == '.';
            if (!plain) c = '-';
        }
        const std::string file = whole.stem().string() + "-" + name + whole.extension().string();
        files.push_back((whole.parent_path() / file).string());
    }
    return files;
}

void printRow(const Scene& scene, const RunFigures& f) {
    const std::string missing = f.arrived100 < 0.0 && f.stuck > 0 ? " (" + std::to_string(f.stuck) + ")" : "";
    const std::string times = timeText(f.arrived95) + "/" + timeText(f.arrived100) + missing;
    std::printf("| %-9s | %6d | %-15s | %5d | %8d | %11.2f | %10.4f | %10s | %.2f / %.2f / %.2f |\n",
                scene.name.c_str(), f.characters, times.c_str(), f.stuck, f.overlapPairsMax,
                100.0 * f.worstPenetration, f.swapsPerCharacterPerSecond, timeText(f.pathRatio).c_str(),
                f.stepP50, f.stepP95, f.stepMax);
    std::fflush(stdout);
}

int peers(const PeersOptions& options) {
    const auto scenes = readScenes(options);
    if (!scenes.ok()) return reportFailure(scenes.status());
    const auto files = trajectoryFiles(options.trajectory, *scenes);
    if (Status s = differentFiles({options.file}, files); !s.ok()) return reportFailure(s);
    Json results = Json::array();
    if (!options.json)
        std::printf(
            "| scene     |      n | 95 %%/100 %% [s]  | stuck | overlaps | deepest [%%] | swaps/n/s  | path "
            "ratio | step ms p50/p95/max |\n"
            "|---|---|---|---|---|---|---|---|---|\n");
    for (std::size_t i = 0; i < scenes->size(); ++i) {
        const Scene& scene = (*scenes)[i];
        RunDef run{.longest = scene.limit,
                   .threads = options.threads,
                   .trajectoryPath = files[i],
                   .pathRatio = countOf(scene.def) <= kLargestExact,
                   .label = scene.name};
        auto world = World::create(scene.def, run.threads);
        if (!world.ok()) return reportFailure(world.status().within(sceneName(options.file, scene.name)));
        const auto outcome = runWorld(*std::move(world), scene.def, {}, run);
        if (!outcome.ok()) return reportFailure(outcome.status().within(sceneName(options.file, scene.name)));
        if (!options.json) printRow(scene, outcome->figures);
        Json entry = {{"scene", scene.name}};
        const Json values = figuresJson(outcome->figures);
        for (const auto& [key, value] : values.members()) entry[key] = value;
        results.push(std::move(entry));
    }
    if (options.json) printJsonValue(results);
    return kExitOk;
}

}  // namespace

void addPeersCommand(CommandLine& line) {
    Subcommand command = line.add(kPeersCommand.name, kPeersCommand.about);
    auto options = std::make_shared<PeersOptions>();
    command
        .option("SCENES", options->file,
                "JSON file: scenes by name, each with world, T, start, slots, "
                "polygons_ccw and circles.")
        .required();
    command.option("--scene", options->scene,
                   "Only this scene. Without it, scenes above 1,000 characters are left out where the "
                   "plan is exact.");
    options->overrides.addTo(command);
    command.option("--threads", options->threads, "Threads; 0 takes what the machine has.").range(0, 256);
    command.option("--trajectory", options->trajectory,
                   "Writes t,id,x,y,place_x,place_y,group,heading,motion,goal for every step into this CSV "
                   "file; where several scenes run, "
                   "each into a file of its own, whose name ends with that of the scene.");
    command.flag(
        "--inertia", options->inertia,
        "With Muster's own inertia; else velocities change at once, as those of other engines' agents do.");
    command.flag("--json", options->json, "One JSON array on standard output, an object per scene.");
    command.footer(
        "Radius 0.25 m, top speed 2 m/s, 60 steps a second; the potential field is off, since slots are "
        "fixed.\n"
        "The path ratio is left out above 1,000 characters.\n"
        "Times are until 95 % and 100 % stand within 0.5 m of their slots; (k) of them are stuck.\n"
        "Examples:\n"
        "  muster peers scenes.json\n"
        "  muster peers scenes.json --scene S2-100 --json --trajectory s2.csv");
    command.run([options] { return peers(*options); });
}

}  // namespace muster
