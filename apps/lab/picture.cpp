// muster picture
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/text_file.h"
#include "engine/state/validation.h"
#include "lab/picture/picture.h"
#include "lab_commands.h"
#include "lab_commands_list.h"
#include "muster/scenario.h"
#include "muster/take.h"
#include "options.h"
#include "overrides.h"
#include "report.h"
#include "touches.h"

namespace muster {
namespace {

constexpr double kTrailPeriod = 0.2;  // Time between two points of a trail [s].

struct PictureOptions {
    std::string source;
    Touches touches;
    double at = 0.0;
    std::string layers;
    std::string output;
    Overrides overrides;
    PictureDef def;
    std::vector<double> view;
    int group = 0;
    bool json = false;
};

/// Scenario and commands of the world to draw.
Status loadSource(const PictureOptions& options, WorldDef& def, std::vector<Command>& commands) {
    const auto text = readTextFile(options.source, std::size_t{1} << 30);
    if (!text.ok()) return text.status();
    if (text->rfind("MUSTAKE", 0) == 0) {
        auto take = readTake(options.source);
        if (!take.ok()) return take.status();
        def = std::move(take->def);
        commands = std::move(take->commands);
        if (options.touches.demo)
            return invalidArgument("--demo: " + options.source +
                                   " is a take, expected a scenario that carries gestures");
    } else {
        auto loaded = loadScenario(options.source);
        if (!loaded.ok()) return loaded.status();
        def = std::move(loaded).value();
    }
    if (Status s = options.overrides.apply(def); !s.ok()) return s;
    if (!options.touches.demo && options.touches.gestures.empty()) return {};
    auto loaded = options.touches.load(options.source, def);
    if (!loaded.ok()) return loaded.status();
    commands = std::move(loaded).value();
    const auto gestures = options.touches.file(options.source, def);
    return differentFiles({*gestures}, {options.output});
}

/// Where characters have been, by id: who leaves takes the trail along.
using Trails = std::map<std::uint32_t, std::vector<Vec2>>;

void addTrail(const World& world, Trails& trails) {
    const CharactersView characters = world.characters();
    for (std::size_t i = 0; i < characters.size(); ++i)
        trails[characters.id[i]].push_back(characters.position[i]);
}

/// Fails where the requested group or place does not exist at that moment.
Status placeExists(const World& world, const PictureDef& picture) {
    const auto range = [](const char* what, std::size_t found, std::size_t count) {
        return invalidArgument(std::string(what) + ": found " + std::to_string(found) + ", expected " +
                               (count == 0 ? "none, as there is none" : "0 to " + std::to_string(count - 1)));
    };
    const std::size_t groups = world.groupCount();
    if (picture.group > 0 && picture.group >= groups) return range("--group", picture.group, groups);
    if (picture.place < 0) return {};
    const std::size_t places = groups == 0 ? 0 : world.group(picture.group).placePositions.size();
    const auto place = static_cast<std::size_t>(picture.place);
    return place < places ? Status() : range("--place", place, places);
}

int picture(const PictureOptions& options) {
    if (Status s = differentFiles({options.source}, {options.output}); !s.ok()) return reportFailure(s);
    PictureDef picture = options.def;
    picture.group = static_cast<std::size_t>(options.group);
    const auto layers = parseLayers(options.layers);
    if (!layers.ok()) return reportFailure(layers.status().within("--layers"));
    picture.layers = *layers;
    if (options.view.size() == 4)
        picture.view = Box{{options.view[0], options.view[1]}, {options.view[2], options.view[3]}};
    WorldDef def;
    std::vector<Command> commands;
    if (Status s = loadSource(options, def, commands); !s.ok()) return reportFailure(s);
    auto world = World::create(def);
    if (!world.ok()) return reportFailure(world.status().within(options.source));
    printWarnings(def, options.source);
    for (const Command& command : commands) {
        if (Status s = world->submit(command); !s.ok()) return reportFailure(s.within(options.source));
    }
    const auto steps = static_cast<std::uint32_t>(std::floor(options.at / def.parameters.stepTime + 0.5));
    const auto every = static_cast<std::uint32_t>(
        std::max(1.0, std::floor(kTrailPeriod / def.parameters.stepTime)));
    Progress progress("simulating");
    Trails trails;
    addTrail(*world, trails);
    while (world->stepCount() < steps) {
        world->step();
        if (world->stepCount() % every == 0 || world->stepCount() == steps) addTrail(*world, trails);
        progress.show(static_cast<double>(world->stepCount()) / steps);
    }
    for (const std::uint32_t id : world->characters().id) picture.trails.push_back(std::move(trails[id]));
    if (Status s = placeExists(*world, picture); !s.ok()) return reportFailure(s);
    if (Status s = writePicture(*world, picture, options.output); !s.ok()) return reportFailure(s);
    if (options.json)
        printJsonValue({{"picture", options.output}, {"t", world->time()}, {"width", picture.width}});
    return kExitOk;
}

}  // namespace

void addPictureCommand(CommandLine& line) {
    Subcommand command = line.add(kPictureCommand.name, kPictureCommand.about);
    auto options = std::make_shared<PictureOptions>();
    command.option("SOURCE", options->source, "Scenario or take file.").required();
    command.option("-o,--output", options->output, "Picture to write: .png or .svg.").required();
    command.option("--at", options->at, "Moment [s].").finite(0.0, 1e6);
    command.option(
        "--layers", options->layers,
        "Some of patches, field, cost, density, obstacles, mesh, places, paths, characters, separated by "
        "commas; without it all but field, cost and density.");
    options->touches.addTo(command);
    options->overrides.addTo(command);
    command.option("--width", options->def.width, "Pixels across.").range(64, 8192);
    command.option("--view", options->view, "What is shown: X0 Y0 X1 Y1 [m]; without it the whole world.")
        .values(4);
    command.option("--group", options->group, "Group (from 0) whose place the layer cost shows.")
        .range(0, static_cast<int>(kMaxGroups));
    command
        .option("--place", options->def.place,
                "Place (from 0) that the layer cost shows; without it that of the character with the "
                "longest way.")
        .range(0, kMaxCharacters);
    command.flag("--dark", options->def.dark, "Colours for dark surroundings.");
    command.flag("--json", options->json, "One JSON value on standard output.");
    command.footer(
        "Examples:\n"
        "  muster picture scenarios/woodland.json --demo --at 12 -o woodland.png\n"
        "  muster picture scenarios/block.json --layers cost,obstacles,characters -o block.svg");
    command.run([options] { return picture(*options); });
}

}  // namespace muster
