#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/geometry/polygon.h"
#include "files/scenario/warning_parts.h"

namespace muster {
namespace {

// Who walks steps over what is smaller [m].
constexpr double kLeastExit = 0.05;
constexpr double kExact = 0.004;  // To which the ground is searched [m].

const char* kindText(AreaKind kind) {
    return kind == AreaKind::Exit ? "exit" : kind == AreaKind::Source ? "source" : "waiting area";
}

/// True where a function that changes by at most a metre a metre is 0 or more somewhere in the box, but for
/// where it is barely so: squares where it cannot be are left out, others are quartered.
template <class Function>
bool reachesZero(const Box& box, const Function& function) {
    struct Square {
        Vec2 centre;
        double half;
    };
    const double largest = 0.5 * std::max(box.width(), box.height());
    std::vector<Square> left{{0.5 * (box.min + box.max), largest}};
    while (!left.empty()) {
        const Square square = left.back();
        left.pop_back();
        const double value = function(square.centre), reach = std::sqrt(2.0) * square.half;
        if (value >= 0.0) return true;
        if (value < -reach || reach < kExact) continue;
        const double half = 0.5 * square.half;
        for (const Vec2 way : {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}, Vec2{1, 1}})
            left.push_back({square.centre + half * way, half});
    }
    return false;
}

// What comes of an area that nobody has room in.
const char* outcomeText(AreaKind kind) {
    if (kind == AreaKind::Source) return "it can send nobody";
    return kind == AreaKind::Exit ? "nobody can leave by it" : "nobody can wait in it";
}

void warnOfRoom(const WarnedScene& scene, std::size_t k, double radius, WarningList& warnings) {
    const AreaDef& area = scene.def.areas[k];
    if (!hasRoom(scene, area, radius)) {
        warnings.add(areaText(scene.def, k) +
                     " lies in obstacles or off the ground, without room for a body of radius " +
                     metresText(radius) + ": " + outcomeText(area.kind));
        return;
    }
    const auto depth = [&](Vec2 p) { return -signedDistance(area.polygon, p) - 0.5 * kLeastExit; };
    if (area.kind == AreaKind::Exit && !reachesZero(boundsOf(area.polygon), depth))
        warnings.add(areaText(scene.def, k) + " is less than " + metresText(kLeastExit) +
                     " across: people step over it");
}

void warnOfQueue(const WarnedScene& scene, std::size_t k, double radius, WarningList& warnings) {
    const std::vector<Vec2>& line = scene.def.areas[k].queue;
    for (std::size_t p = 1; p < line.size(); ++p) {
        if (scene.ground.clearStaticLine(line[p - 1], line[p], radius)) continue;
        warnings.add("the queue of " + areaText(scene.def, k) + " comes nearer than the radius of a body, " +
                     metresText(radius) + ", to an obstacle or the side of the ground between " +
                     pointText(line[p - 1]) + " and " + pointText(line[p]));
        return;
    }
}

// A source that has room, but nobody to send.
void warnOfIdleSource(const WarnedScene& scene, std::size_t k, double radius, WarningList& warnings) {
    const AreaDef& area = scene.def.areas[k];
    if (area.kind == AreaKind::Source && area.rate == 0.0 && area.timetable.empty() &&
        hasRoom(scene, area, radius))
        warnings.add(areaText(scene.def, k) + " has neither a rate nor a timetable: nobody comes");
}

// Exits that are all shut, although people are to leave.
void warnOfShutExits(const WorldDef& def, WarningList& warnings) {
    bool shut = false;
    for (const AreaDef& area : def.areas) {
        if (area.kind == AreaKind::Exit && area.open) return;
        shut = shut || area.kind == AreaKind::Exit;
    }
    if (shut) warnings.add("every exit is shut: nobody leaves until a command opens one");
}

// Orders behind one that waits without end.
void warnOfEndlessWaits(const WorldDef& def, WarningList& warnings) {
    for (std::size_t g = 0; g < def.groups.size(); ++g) {
        const std::vector<Order>& orders = def.groups[g].orders;
        for (std::size_t k = 0; k + 1 < orders.size(); ++k) {
            if (orders[k].kind != OrderKind::Wait || orders[k].seconds > 0.0) continue;
            warnings.add("order " + std::to_string(k + 1) + " of " + groupText(def, g) +
                         " waits without end: the orders behind it never begin");
            break;
        }
    }
}

}  // namespace

double WarnedScene::clearance(Vec2 p) const {
    const Box sides = ground.def().sides();
    const double toSide = std::min(std::min(p.x - sides.min.x, sides.max.x - p.x),
                                   std::min(p.y - sides.min.y, sides.max.y - p.y));
    return std::min(toSide, ground.distanceToObstacle(p));
}

std::string pointText(Vec2 p) {
    char buffer[64];
    std::snprintf(buffer, sizeof(buffer), "(%.2f, %.2f)", p.x, p.y);
    return buffer;
}

std::string metresText(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.3g m", value);
    return buffer;
}

std::string groupText(const WorldDef& def, std::size_t group) {
    return "group " + std::to_string(group + 1) + " \"" + def.groups[group].name + "\"";
}

std::string thingText(std::string_view kind, std::size_t index, const std::string& name) {
    const std::string text = std::string(kind) + " " + std::to_string(index + 1);
    return name.empty() ? text : text + " \"" + name + "\"";
}

std::string areaText(const WorldDef& def, std::size_t area) {
    return thingText(kindText(def.areas[area].kind), area, def.areas[area].name);
}

bool hasRoom(const WarnedScene& scene, const AreaDef& area, double radius) {
    return reachesZero(boundsOf(area.polygon), [&](Vec2 p) {
        return std::min(-signedDistance(area.polygon, p), scene.clearance(p) - radius);
    });
}

void warnOfAreas(const WarnedScene& scene, WarningList& warnings) {
    const double radius = scene.leastRadius();
    for (std::size_t k = 0; k < scene.def.areas.size() && !warnings.full(); ++k) {
        warnOfRoom(scene, k, radius, warnings);
        warnOfQueue(scene, k, radius, warnings);
        warnOfIdleSource(scene, k, radius, warnings);
    }
    warnOfShutExits(scene.def, warnings);
    warnOfEndlessWaits(scene.def, warnings);
}

}  // namespace muster
