#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "engine/state/ground_class.h"
#include "files/scenario/warning_parts.h"
#include "muster/scenario.h"

namespace muster {
namespace {

// A single-step patch whose length differs from its clip's by more than this share gives a warning.
constexpr double kLengthShare = 0.15;
constexpr double kFewPersons = 0.001;  // So few persons of a sort are smaller, or larger, than who count.
constexpr double kLeastRadius = 0.05, kMostRadius = 1.5;  // Of drawn bodies [m].

/// The ground of the definition at time 0.
Result<Environment> groundOf(const WorldDef& def) {
    EnvironmentDef ground{def.box,   def.cell, def.parameters.field.range, def.parameters.field.strength,
                          def.clips, def.ring};
    auto environment = Environment::create(ground);
    if (!environment.ok()) return environment;
    std::vector<ObstacleDef> obstacles = def.obstacles;
    if (def.map) {
        for (ObstacleDef& piece : mapObstacles(def.map->grid, def.map->def))
            obstacles.push_back(std::move(piece));
    }
    for (const ObstacleDef& obstacle : obstacles) {
        if (const auto id = environment->addObstacle(obstacle); !id.ok()) return id.status();
    }
    environment->setTime(0.0);
    return environment;
}

std::string nameOf(const Environment& environment, ObstacleId id) {
    const ObstacleDef* obstacle = environment.obstacle(id);
    if (obstacle != nullptr && !obstacle->name.empty()) return "\"" + obstacle->name + "\"";
    return "obstacle " + std::to_string(id.value);
}

/// The location of a gap, in words.
std::string placeOf(const Environment& environment, const NarrowGap& gap) {
    if (!gap.b) return "between " + nameOf(environment, gap.a) + " and the edge of the world";
    if (gap.a == gap.b) return "within " + nameOf(environment, gap.a);
    return "between " + nameOf(environment, gap.a) + " and " + nameOf(environment, gap.b);
}

/// The bodies of a group: the widths of the narrowest ways on which the smallest and the largest are led [m].
struct Widths {
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;

    void add(double usual, double radius) {
        // Fields are those of a class of bodies, which holds up to a largest radius.
        const double body = radius > 0.0 ? radius : usual;
        const double width = 2.0 * groundRadius(usual, groundClassFor(usual, body));
        least = std::min(least, width);
        most = std::max(most, width);
    }
};

Widths widthsOf(const GroupDef& group, double usual) {
    Widths widths;
    const auto addBodies = [&] {
        if (group.bodies.empty()) widths.add(usual, usual);
        for (const Body& body : group.bodies) widths.add(usual, body.radius);
    };
    if (group.people.empty()) addBodies();
    for (const PeopleDef& sort : group.people) {
        if (sort.radius == Distribution{}) {
            addBodies();
            continue;
        }
        for (const double share : {kFewPersons, 1.0 - kFewPersons})
            widths.add(usual, std::clamp(sort.radius.quantile(share), kLeastRadius, kMostRadius));
    }
    return widths;
}

/// Why somebody does not fit through a gap of this width; empty where all do.
std::string tooNarrowFor(const WorldDef& def, double width) {
    const double usual = def.parameters.character.radius;
    double least = def.groups.empty() ? 2.0 * usual : std::numeric_limits<double>::infinity();
    std::string larger;
    for (const GroupDef& group : def.groups) {
        const Widths widths = widthsOf(group, usual);
        least = std::min(least, widths.least);
        if (!larger.empty() || width >= widths.most) continue;
        char needed[64];
        std::snprintf(needed, sizeof(needed), ", who are led through %.2f m and more", widths.most);
        larger = "too narrow for the largest bodies of group \"" + group.name + "\"" + needed;
    }
    return width < least ? "narrower than a character" : larger;
}

void warnOfGaps(const WarnedScene& scene, WarningList& warnings) {
    const double usual = scene.def.parameters.character.radius;
    double widest = scene.def.groups.empty() ? 2.0 * usual : 0.0;
    for (const GroupDef& group : scene.def.groups) widest = std::max(widest, widthsOf(group, usual).most);
    for (const NarrowGap& gap : scene.ground.narrowGaps(widest, static_cast<std::int32_t>(warnings.most))) {
        char width[32];
        std::snprintf(width, sizeof(width), "%.2f", gap.width);
        warnings.add("the gap " + placeOf(scene.ground, gap) + " at " + pointText(gap.where) + " is " +
                     width + " m wide, " + tooNarrowFor(scene.def, gap.width));
    }
}

/// The shortest straight path across a shape [m].
double widthOf(std::span<const Vec2> polygon) {
    const Polygon hull = convexHull(polygon);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, j = hull.size() - 1; i < hull.size(); j = i++) {
        const Vec2 along = normalized(hull[i] - hull[j]);
        double across = 0.0;
        for (const Vec2 p : hull) across = std::max(across, cross(along, p - hull[j]));
        least = std::min(least, across);
    }
    return least;
}

/// SPEC C3: a single-step motion runs once, so its patch must be as long as its clip.
void warnOfSingleSteps(const WorldDef& def, WarningList& warnings) {
    for (std::size_t i = 0; i < def.patches.size() && !warnings.full(); ++i) {
        const ClipFacts& clip = def.clips[def.patches[i].motion];
        if (clip.cyclic || clip.length <= 0.0) continue;
        const double found = widthOf(def.patches[i].polygon);
        if (std::fabs(found - clip.length) <= kLengthShare * clip.length) continue;
        char text[160];
        std::snprintf(text, sizeof(text),
                      " is %.2f m across, expected %.2f to %.2f m, as a play of \"%.40s\" covers %.2f m",
                      found, (1.0 - kLengthShare) * clip.length, (1.0 + kLengthShare) * clip.length,
                      clip.name.c_str(), clip.length);
        warnings.add(thingText("patch", i, def.patches[i].name) + text);
    }
}

/// What is wrong with where an order leads; empty where nothing is.
std::string troubleOf(const Order& order, const WorldDef& def) {
    const auto is = [&](AreaId id, AreaKind kind) {
        return id.value >= 1 && id.value <= def.areas.size() && def.areas[id.value - 1].kind == kind;
    };
    if (order.kind == OrderKind::Wait && !is(order.area, AreaKind::Waiting))
        return "wait in area " + std::to_string(order.area.value) + ", which is no waiting area";
    if (order.kind != OrderKind::Leave) return {};
    for (const AreaId exit : order.exits)
        if (!is(exit, AreaKind::Exit))
            return "leave by area " + std::to_string(exit.value) + ", which is no exit";
    const bool none = std::none_of(def.areas.begin(), def.areas.end(),
                                   [](const AreaDef& area) { return area.kind == AreaKind::Exit; });
    return none ? "leave, and there is no exit" : "";
}

void warnOfGoals(const WorldDef& def, WarningList& warnings) {
    for (const GroupDef& group : def.groups)
        for (const Order& order : group.orders)
            if (const std::string trouble = troubleOf(order, def); !trouble.empty())
                warnings.add("group \"" + group.name + "\" is to " + trouble);
}

}  // namespace

std::vector<std::string> scenarioWarnings(const WorldDef& def, std::size_t most) {
    const auto environment = groundOf(def);
    if (!environment.ok()) return {environment.status().message()};
    const WarnedScene scene = warnedScene(def, *environment);
    WarningList warnings{most, {}};
    warnOfGaps(scene, warnings);
    warnOfSingleSteps(def, warnings);
    warnOfStarts(scene, warnings);
    warnOfGoals(def, warnings);
    warnOfAreas(scene, warnings);
    warnOfWays(scene, warnings);
    return std::move(warnings.texts);
}

}  // namespace muster
