#include "scale/large_ground.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/maths.h"
#include "base/random.h"
#include "base/text_file.h"
#include "scale/caves.h"
#include "scale/meter.h"
#include "scale/stages.h"

namespace muster::scale {
namespace {

constexpr double kClearing = 14.0;           // Radius round the group's start and goal without obstacles [m].
constexpr std::int32_t kStandingSteps = 40;  // Steps before the order.
constexpr std::int32_t kAfterEdit = 8;       // Steps after each edit.

Vec2 startOf(const LargeGroundDef& def) {
    return {-0.5 * def.away, 0.0};
}
Vec2 goalOf(const LargeGroundDef& def) {
    return {0.5 * def.away, 0.0};
}

Polygon turnedBox(Vec2 centre, Vec2 half, double angle) {
    const Rotation turn{cosine(angle), sine(angle)};
    Polygon polygon;
    for (const Vec2 corner : {Vec2{-half.x, -half.y}, Vec2{half.x, -half.y}, half, Vec2{-half.x, half.y}})
        polygon.push_back(centre + turn.apply(corner));
    return polygon;
}

// Every third obstacle is a tree, the others are buildings.
ObstacleDef randomObstacle(Random& random, double half, std::int32_t number) {
    ObstacleDef obstacle;
    const Vec2 centre{random.uniform(-half, half), random.uniform(-half, half)};
    if (number % 3 == 0) {
        obstacle.centre = centre;
        obstacle.radius = random.uniform(0.3, 2.0);
        return obstacle;
    }
    obstacle.polygon = turnedBox(centre, {random.uniform(1.5, 8.0), random.uniform(1.5, 5.0)},
                                 random.uniform(0.0, 2.0 * kPi));
    return obstacle;
}

bool isClear(const ObstacleDef& obstacle, Vec2 p) {
    const Vec2 centre = obstacle.polygon.empty() ? obstacle.centre
                                                 : 0.5 * (obstacle.polygon[0] + obstacle.polygon[2]);
    return distance(centre, p) > kClearing + 10.0;
}

void addMadeObstacles(const LargeGroundDef& def, WorldDef& world) {
    Random random(def.seed);
    const double half = 0.5 * def.side;
    world.box = {{-half, -half}, {half, half}};
    while (std::cmp_less(world.obstacles.size(), def.obstacles)) {
        const auto number = static_cast<std::int32_t>(world.obstacles.size());
        ObstacleDef obstacle = randomObstacle(random, half, number);
        if (isClear(obstacle, startOf(def)) && isClear(obstacle, goalOf(def)))
            world.obstacles.push_back(std::move(obstacle));
    }
}

bool hasMap(const LargeGroundDef& def) {
    return !def.map.empty() || def.caves[0] > 0;
}

Result<MapGrid> mapOf(const LargeGroundDef& def) {
    if (def.map.empty()) return madeCaves(def.caves[0], def.caves[1], def.seed);
    const Result<std::string> text = readTextFile(def.map);
    if (!text.ok()) return text.status();
    return parseMap(*text);
}

Status addMap(const LargeGroundDef& def, WorldDef& world) {
    Result<MapGrid> grid = mapOf(def);
    if (!grid.ok()) return grid.status();
    MapDef at{.metresPerCell = def.metres,
              .origin = -0.5 * def.metres * Vec2{1.0 * grid->width, 1.0 * grid->height}};
    world.box = {at.origin, -at.origin};
    world.map = MapGround{*std::move(grid), at};
    return {};
}

double percentile(std::vector<double> times, double share) {
    if (times.empty()) return 0.0;
    std::sort(times.begin(), times.end());
    return times[static_cast<std::size_t>(std::lround(share * static_cast<double>(times.size() - 1)))];
}

std::vector<double> timedSteps(World& world, std::int32_t count) {
    std::vector<double> times;
    for (std::int32_t k = 0; k < count; ++k) times.push_back(timedStep(world));
    return times;
}

Status give(World& world, std::uint32_t sequence, CommandBody body) {
    return world.submit({world.stepCount(), 1, sequence, std::move(body)});
}

// A building beside the group is added, moved to its other side and removed.
Status timeEdits(World& world, std::uint32_t& sequence, LargeGroundRow& row) {
    const auto beside = [&](double side) {
        return ObstacleDef{
            .polygon = turnedBox(world.characters().position[0] + Vec2{3.0, side}, {6.0, 4.0}, 0.3)};
    };
    const auto timeEdit = [&](CommandBody body) {
        if (Status status = give(world, sequence++, std::move(body)); !status.ok()) return status;
        row.edits.push_back(timedStep(world));
        row.afterEdit = std::max(row.afterEdit, percentile(timedSteps(world, kAfterEdit), 1.0));
        return Status{};
    };
    if (Status status = timeEdit(putThing(beside(20.0))); !status.ok()) return status;
    const ObstacleId added = world.obstacleIds().back();
    if (Status status = timeEdit(putThing(beside(-20.0), added)); !status.ok()) return status;
    return timeEdit(removeThing(added));
}

Status timeRestore(const World& world, LargeGroundRow& row) {
    const std::vector<std::uint8_t> bytes = world.snapshot();
    const double began = threadMilliseconds();
    Result<World> restored = World::restore(bytes);
    if (!restored.ok()) return restored.status();
    row.restore = threadMilliseconds() - began;
    row.firstRestored = timedStep(*restored);
    return {};
}

Status timeSteps(World& world, LargeGroundRow& row) {
    row.first = timedStep(world);
    row.standing = percentile(timedSteps(world, kStandingSteps), 0.5);
    std::uint32_t sequence = 0;
    const GroupId group = world.group(0).id;
    if (Status status = give(world, sequence++, SetPose{group, goalOf(row.def), 0.0}); !status.ok())
        return status;
    row.order = timedStep(world);
    const std::vector<double> times = timedSteps(world, row.def.steps);
    row.p50 = percentile(times, 0.5);
    row.p95 = percentile(times, 0.95);
    row.most = percentile(times, 1.0);
    if (Status status = timeEdits(world, sequence, row); !status.ok()) return status;
    row.memory = peakMemory();
    row.hash = world.hash();
    return timeRestore(world, row);
}

}  // namespace

Result<WorldDef> largeWorld(const LargeGroundDef& def) {
    WorldDef world{.cell = def.cell};
    if (!hasMap(def)) {
        addMadeObstacles(def, world);
    } else if (Status status = addMap(def, world); !status.ok()) {
        return status;
    }
    world.groups.push_back({.count = def.characters, .position = startOf(def)});
    return world;
}

Result<LargeGroundRow> runLargeGround(const LargeGroundDef& def) {
    LargeGroundRow row{.def = def};
    resetPeakMemory();
    const double importing = threadMilliseconds();
    Result<WorldDef> made = largeWorld(def);
    if (!made.ok()) return made.status();
    const double began = threadMilliseconds();
    Result<World> world = World::create(*made);
    if (!world.ok()) return world.status();
    row.create = !hasMap(def) ? threadMilliseconds() - began : threadMilliseconds() - importing;
    row.createMemory = peakMemory();
    if (Status status = timeSteps(*world, row); !status.ok()) return status;
    return row;
}

std::string largeGroundText(const LargeGroundRow& row) {
    char text[1024];
    const auto edit = [&](std::size_t k) { return k < row.edits.size() ? row.edits[k] : 0.0; };
    std::snprintf(text, sizeof(text),
                  "create          %9.1f ms  %7.1f MB\nfirst step      %9.2f ms\n"
                  "standing        %9.2f ms  p50\norder step      %9.2f ms\n"
                  "later steps     %9.2f ms  p50 %9.2f p95 %9.2f max\n"
                  "edit: added     %9.2f ms\nedit: moved     %9.2f ms\nedit: removed   %9.2f ms\n"
                  "after an edit   %9.2f ms  max\npeak memory     %9.1f MB\n"
                  "restore         %9.1f ms\nfirst restored  %9.2f ms\nhash            %016llx\n",
                  row.create, row.createMemory, row.first, row.standing, row.order, row.p50, row.p95,
                  row.most, edit(0), edit(1), edit(2), row.afterEdit, row.memory, row.restore,
                  row.firstRestored, static_cast<unsigned long long>(row.hash));
    return text;
}

}  // namespace muster::scale
