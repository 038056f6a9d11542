// What there is to see, in words and as a map of letters.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/maths.h"
#include "engine/geometry/polygon.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "muster/views.h"
#include "studio/words/known_names.h"
#include "studio/words/lexicon.h"
#include "studio/words/planner.h"
#include "studio/words/words.h"

namespace muster {
using namespace words;

namespace {

constexpr std::size_t kMostThings = 200;
constexpr std::size_t kColumns = 72;
constexpr double kTall = 2.0;  // A letter is so much higher than wide.

std::string pointText(Vec2 p) {
    return "(" + numberText(p.x) + ", " + numberText(p.y) + ")";
}

std::string compass(Vec2 direction) {
    const double eighths = arcTangent2(direction.y, direction.x) / (kPi / 4.0);
    const auto k = static_cast<int>(std::floor(eighths + 0.5));
    return std::string(nameOf(static_cast<Heading>((k + 8) % 8)));
}

std::string orderText(const Order& order, const KnownNames& names) {
    switch (order.kind) {
        case OrderKind::Move:
            return "go to " + pointText(order.target);
        case OrderKind::Face:
            return "turn";
        case OrderKind::Follow:
            return "follow " + (order.group ? names.nameOf(order.group) : "a person");
        case OrderKind::Guard:
            return "guard " + (order.group ? names.nameOf(order.group) : pointText(order.target));
        case OrderKind::Leave:
            return "leave by an exit";
        case OrderKind::Wait:
            return "wait in " + names.thing(NamedKind::Area, order.area.value).name;
        case OrderKind::Walk:
            return "walk on";
    }
    return "";
}

std::string groupLine(const GroupView& group, const KnownNames& names) {
    std::string text = "Group " + std::to_string(group.id.value) + " " + std::string(group.name) + ": " +
                       std::to_string(group.members.size()) + " people, " + formWord(group.formation) +
                       " at " + pointText(group.pose.position) + ", facing " +
                       compass(group.pose.rotation.apply({1.0, 0.0}));
    if (group.held) text += ", holding";
    if (group.patrols) text += ", patrolling";
    text += ". Orders: ";
    for (std::size_t k = 0; k < group.orders.size(); ++k)
        text += (k == 0 ? "" : ", then ") + orderText(group.orders[k].order, names);
    return text + (group.orders.empty() ? "none." : ".");
}

const char* kindText(const ThingSpot& thing) {
    if (thing.kind == NamedKind::Obstacle) return "Obstacle";
    if (thing.kind == NamedKind::Patch) return "Patch";
    return thing.area == AreaKind::Exit ? "Exit" : thing.area == AreaKind::Source ? "Source" : "Waiting area";
}

std::string thingLine(const ThingSpot& thing) {
    const double width = thing.reach({1, 0}) + thing.reach({-1, 0});
    const double height = thing.reach({0, 1}) + thing.reach({0, -1});
    return std::string(kindText(thing)) + " " + std::to_string(thing.id) + " " + thing.name + ": at " +
           pointText(thing.centre) + ", " + numberText(width) + " m by " + numberText(height) + " m.";
}

/// A raster of letters over the place.
struct Letters {
    Box box;
    double cell = 1.0;
    std::vector<std::string> rows;

    explicit Letters(const Box& of) : box(of), cell(std::max(0.05, of.width() / kColumns)) {
        const auto count = static_cast<std::size_t>(std::clamp(of.height() / (cell * kTall), 1.0, 200.0));
        rows.assign(count, std::string(kColumns, '.'));
    }
    Vec2 centreOf(std::size_t column, std::size_t row) const {
        return {box.min.x + (static_cast<double>(column) + 0.5) * cell,
                box.max.y - (static_cast<double>(row) + 0.5) * cell * kTall};
    }
    void put(Vec2 p, char letter) {
        const double column = (p.x - box.min.x) / cell, row = (box.max.y - p.y) / (cell * kTall);
        if (column < 0.0 || row < 0.0 || column >= static_cast<double>(kColumns) ||
            row >= static_cast<double>(rows.size()))
            return;
        rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] = letter;
    }
    void fill(const ThingSpot& thing, char letter) {
        for (std::size_t r = 0; r < rows.size(); ++r)
            for (std::size_t c = 0; c < kColumns; ++c) {
                const Vec2 p = centreOf(c, r);
                const bool in = thing.outline.empty() ? distance(p, thing.centre) <= thing.radius
                                                      : containsPoint(thing.outline, p);
                if (in) rows[r][c] = letter;
            }
    }
};

std::vector<ThingSpot> thingsOf(const World& world, const KnownNames& names) {
    std::vector<ThingSpot> things;
    for (const ObstacleId id : world.obstacleIds())
        things.push_back(names.thing(NamedKind::Obstacle, id.value));
    for (const PatchId id : world.patchIds()) things.push_back(names.thing(NamedKind::Patch, id.value));
    for (std::size_t a = 0; a < world.areaCount(); ++a)
        things.push_back(names.thing(NamedKind::Area, world.area(a).id.value));
    if (things.size() > kMostThings) things.resize(kMostThings);
    return things;
}

}  // namespace

std::vector<std::string> lookAround(const World& world) {
    const KnownNames names(world);
    const Box box = inspect::environment(world).def().box;
    std::vector<std::string> lines{
        "The ground goes from " + pointText(box.min) + " to " + pointText(box.max) +
        " in metres; x points east, y north. Time: " + numberText(world.time()) + " s."};
    for (std::size_t g = 0; g < world.groupCount(); ++g) lines.push_back(groupLine(world.group(g), names));
    for (const ThingSpot& thing : thingsOf(world, names)) lines.push_back(thingLine(thing));
    if (!world.items().empty()) lines.push_back(std::to_string(world.items().size()) + " items lie about.");
    return lines;
}

std::vector<std::string> mapFromAbove(const World& world) {
    const KnownNames names(world);
    Letters letters(inspect::environment(world).def().box);
    std::string key = "# obstacle, ~ patch, E exit or other area";
    for (const ThingSpot& thing : thingsOf(world, names))
        letters.fill(thing, thing.kind == NamedKind::Obstacle ? '#'
                            : thing.kind == NamedKind::Patch  ? '~'
                                                              : 'E');
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const char letter = static_cast<char>('a' + g % 26);
        key += std::string(", ") + letter + " " + std::string(world.group(g).name);
        for (const std::int32_t i : world.group(g).members)
            letters.put(world.characters().position[static_cast<std::size_t>(i)], letter);
    }
    letters.rows.push_back(key);
    return letters.rows;
}

}  // namespace muster
