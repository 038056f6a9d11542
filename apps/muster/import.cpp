// muster import
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/grid.h"
#include "base/text_file.h"
#include "commands.h"
#include "engine/ground/environment/environment.h"
#include "engine/ground/routes/route_graph.h"
#include "engine/state/validation.h"
#include "muster/scenario.h"
#include "options.h"
#include "report.h"

namespace muster {
namespace {

struct ImportOptions {
    std::string map;
    std::string output;
    double metresPerCell = 1.0;
    double ground = 0.0;
    int count = 100;
    std::string credit;
    bool json = false;
};

/// A free square of the ground.
struct FreeSquare {
    Vec2 position;
    double reach = 0.0;         ///< Half the edge of the free square around it [m].
    std::size_t obstacles = 0;  ///< Number of obstacles on the ground.
};

/// A map as a scenario.
struct Imported {
    WorldDef def;
    std::size_t obstacles = 0;  ///< Number of obstacles that the map stands for.
};

/// The chessboard distance of each ground cell to the nearest cell outside the region, in cells: half the
/// edge of the largest free square around it.
std::vector<std::uint16_t> freeSquareSizes(const Grid& grid, const std::vector<std::int32_t>& labels,
                                           std::int32_t region) {
    std::vector<std::uint16_t> sizes(labels.size(), 0);
    const auto at = [&](std::int32_t x, std::int32_t y) {
        return grid.contains({x, y}) ? std::int32_t{sizes[grid.index({x, y})]} : 0;
    };
    for (std::int32_t y = 0; y < grid.height; ++y) {
        for (std::int32_t x = 0; x < grid.width; ++x) {
            const auto i = static_cast<std::size_t>(grid.index({x, y}));
            if (labels[i] != region) continue;
            sizes[i] = static_cast<std::uint16_t>(
                1 + std::min({at(x - 1, y), at(x - 1, y - 1), at(x, y - 1), at(x + 1, y - 1)}));
        }
    }
    for (std::int32_t y = grid.height - 1; y >= 0; --y) {
        for (std::int32_t x = grid.width - 1; x >= 0; --x) {
            const auto i = static_cast<std::size_t>(grid.index({x, y}));
            const std::int32_t above = std::min(
                {at(x + 1, y), at(x + 1, y + 1), at(x, y + 1), at(x - 1, y + 1)});
            sizes[i] = static_cast<std::uint16_t>(std::min<std::int32_t>(sizes[i], 1 + above));
        }
    }
    return sizes;
}

/// The largest free square of the largest region; among equals the one nearest to the map's centre.
Result<FreeSquare> largestFreeSquare(const WorldDef& def) {
    auto environment = Environment::create({def.box, def.cell, 1.5, 1.0, def.clips});
    if (!environment.ok()) return environment.status();
    const std::vector<ObstacleDef> obstacles = mapObstacles(def.map->grid, def.map->def);
    for (const ObstacleDef& obstacle : obstacles) {
        if (const auto added = environment->addObstacle(obstacle); !added.ok()) return added.status();
    }
    environment->setTime(0.0);
    const Grid& grid = environment->grid();
    const double radius = def.parameters.character.radius;
    RouteGraph routes;
    routes.update(*environment, radius);
    std::vector<std::int32_t> labels(static_cast<std::size_t>(grid.count()));
    std::vector<std::int32_t> regionSizes;
    for (std::int32_t i = 0; i < grid.count(); ++i) {
        const bool free = environment->clearance()[i] >= radius;
        const std::int32_t label = free ? routes.region(grid.centre(grid.at(i))) : -1;
        labels[i] = label;
        if (label < 0) continue;
        if (static_cast<std::size_t>(label) >= regionSizes.size())
            regionSizes.resize(static_cast<std::size_t>(label) + 1);
        ++regionSizes[label];
    }
    if (regionSizes.empty()) return invalidArgument("found no free ground, expected room for a character");
    const auto largest = static_cast<std::int32_t>(std::max_element(regionSizes.begin(), regionSizes.end()) -
                                                   regionSizes.begin());
    const auto sizes = freeSquareSizes(grid, labels, largest);
    const Vec2 middle = (def.box.min + def.box.max) * 0.5;
    std::int32_t best = 0;
    for (std::int32_t i = 1; i < grid.count(); ++i) {
        const auto a = sizes[i], b = sizes[best];
        const bool nearer = distance(grid.centre(grid.at(i)), middle) <
                            distance(grid.centre(grid.at(best)), middle);
        if (a > b || (a == b && nearer)) best = i;
    }
    return FreeSquare{grid.centre(grid.at(best)), (sizes[best] - 0.5) * grid.cell, obstacles.size()};
}

Result<Imported> makeScenario(const ImportOptions& options) {
    const auto text = readTextFile(options.map);
    if (!text.ok()) return text.status();
    auto grid = parseMap(*text);
    if (!grid.ok()) return grid.status().within(options.map);
    WorldDef def{
        .name = std::filesystem::path(options.map).stem().string(),
        .description = "Imported from a MovingAI map, " + std::to_string(grid->width) + " x " +
                       std::to_string(grid->height) + " cells.",
        .credit = options.credit,
        .box = {{0.0, 0.0}, {grid->width * options.metresPerCell, grid->height * options.metresPerCell}},
        .cell = options.ground > 0.0 ? options.ground : std::clamp(options.metresPerCell / 2.0, 0.25, 0.5)};
    MapDef scale{.metresPerCell = options.metresPerCell};
    def.map = MapGround{std::move(grid).value(), scale};
    const auto square = largestFreeSquare(def);
    if (!square.ok()) return square.status().within(options.map);
    def.groups.push_back({.name = "Blue", .count = options.count, .position = square->position});
    return Imported{std::move(def), square->obstacles};
}

int import(const ImportOptions& options) {
    if (Status s = differentFiles({options.map}, {options.output}); !s.ok()) return reportFailure(s);
    const auto imported = makeScenario(options);
    if (!imported.ok()) return reportFailure(imported.status());
    const WorldDef* def = &imported->def;
    if (Status s = saveScenario(*def, options.output); !s.ok()) return reportFailure(s);
    const GroupDef& group = def->groups.front();
    if (options.json) {
        printJsonValue({{"scenario", options.output},
                        {"width_m", def->box.width()},
                        {"height_m", def->box.height()},
                        {"obstacles", imported->obstacles},
                        {"characters", group.count},
                        {"position", Json::array({group.position.x, group.position.y})}});
    } else {
        std::printf("%s: %.0f x %.0f m, %zu obstacles, %d characters at (%.2f, %.2f)\n",
                    options.output.c_str(), def->box.width(), def->box.height(), imported->obstacles,
                    group.count, group.position.x, group.position.y);
    }
    return kExitOk;
}

}  // namespace

void addImportCommand(CommandLine& line) {
    Subcommand command = line.add("import", "Makes a scenario from a MovingAI .map file.");
    auto options = std::make_shared<ImportOptions>();
    command.option("MAP", options->map, "Map file.").required();
    command.option("-o,--output", options->output, "Scenario file to write; the map is embedded.").required();
    command.option("--cell", options->metresPerCell, "Metres per map cell.").finite(0.01, 1000.0);
    command.option("--count", options->count, "Characters; they start where there is most room.")
        .range(1, kMaxCharacters);
    command
        .option("--ground", options->ground,
                "Metres per ground cell; without it half a map cell, 0.25 to 0.5.")
        .finite(0.01, 100.0);
    command.option("--credit", options->credit, "Whose data it is; goes into the scenario.");
    command.flag("--json", options->json, "One JSON value on standard output.");
    command.footer(
        "Examples:\n"
        "  muster import Berlin_0_256.map -o berlin.json --cell 1 --count 100 --credit \"OpenStreetMap "
        "contributors\"\n"
        "  muster play berlin.json --seconds 5");
    command.run([options] { return import(*options); });
}

}  // namespace muster
