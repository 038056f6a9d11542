// Whether people have a way to their exits and waiting areas, by the regions of ground that bodies of their
// size walk on.
#include <algorithm>
#include <map>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/ground/routes/route_graph.h"
#include "engine/state/ground_class.h"
#include "files/scenario/warning_parts.h"

namespace muster {
namespace {

constexpr double kBeside = 2.0;  // An area that holds no cell is come to from so far beside it [cells].

/// The regions of ground, and which of them each area is come to from, by the class of a body.
class Regions {
public:
    explicit Regions(const WarnedScene& scene) : scene_(scene) {}

    /// The region of a body that stands at a point; -1 where it cannot stand near by.
    std::int32_t of(Vec2 p, std::int32_t groundClass) {
        const RouteGraph& routes = graph(groundClass);
        const std::int32_t region = routes.region(p);
        if (region >= 0) return region;
        const Vec2 near = routes.nearestReachable(p, -1);
        const double reach = routes.radius() + scene_.ground.grid().cell;
        return distance(near, p) <= reach ? routes.region(near) : -1;
    }
    /// The regions from which an area is come to, ascending.
    const std::vector<std::int32_t>& at(std::size_t area, std::int32_t groundClass) {
        const auto found = areas_.find({area, groundClass});
        if (found != areas_.end()) return found->second;
        std::vector<std::int32_t> list = find(scene_.def.areas[area].polygon, groundClass, 0.0);
        const double beside = kBeside * scene_.ground.grid().cell;
        if (list.empty()) list = find(scene_.def.areas[area].polygon, groundClass, beside);
        return areas_[{area, groundClass}] = std::move(list);
    }

private:
    const RouteGraph& graph(std::int32_t groundClass) {
        const auto [at, isNew] = graphs_.try_emplace(groundClass);
        if (isNew)
            at->second.update(scene_.ground,
                              groundRadius(scene_.def.parameters.character.radius, groundClass));
        return at->second;
    }
    // The regions of the cells whose centres are within a distance of a polygon and see it.
    std::vector<std::int32_t> find(const Polygon& polygon, std::int32_t groundClass, double within) {
        const RouteGraph& routes = graph(groundClass);
        const Grid& grid = scene_.ground.grid();
        const Box box = boundsOf(polygon).grown(within);
        const Cell low = grid.nearestCell(box.min), high = grid.nearestCell(box.max);
        std::vector<std::int32_t> list;
        for (std::int32_t y = low.y; y <= high.y; ++y)
            for (std::int32_t x = low.x; x <= high.x; ++x) {
                const Vec2 p = grid.centre({x, y});
                if (signedDistance(polygon, p) > within) continue;
                const std::int32_t region = routes.region(p);
                const Vec2 near = containsPoint(polygon, p) ? p : closestOnBoundary(polygon, p).point;
                const auto place = std::lower_bound(list.begin(), list.end(), region);
                if (region < 0 || (place != list.end() && *place == region)) continue;
                if (scene_.ground.clearStaticLine(p, near, 0.0)) list.insert(place, region);
            }
        return list;
    }

    const WarnedScene& scene_;
    std::map<std::int32_t, RouteGraph> graphs_;
    std::map<std::pair<std::size_t, std::int32_t>, std::vector<std::int32_t>> areas_;
};

/// Where an order leads, as indices of areas of those that bodies have room in.
std::vector<std::size_t> goalsOf(const WorldDef& def, const Order& order,
                                 const std::vector<std::size_t>& usable) {
    std::vector<std::size_t> goals;
    for (const std::size_t k : usable) {
        const auto is = [&](AreaId id) { return id.value == k + 1; };
        const bool exit = order.kind == OrderKind::Leave && def.areas[k].kind == AreaKind::Exit &&
                          (order.exits.empty() || std::any_of(order.exits.begin(), order.exits.end(), is));
        const bool waiting = order.kind == OrderKind::Wait && def.areas[k].kind == AreaKind::Waiting &&
                             is(order.area);
        if (exit || waiting) goals.push_back(k);
    }
    return goals;
}

/// The goals of an order as text.
std::string goalsText(const WorldDef& def, const Order& order) {
    return order.kind == OrderKind::Leave ? "an exit of theirs" : areaText(def, order.area.value - 1);
}

/// The members of a group who have no way to any of its goals.
struct Cut {
    std::size_t count = 0;    // How many.
    std::size_t large = 0;    // How many of them would have one if they were as small as usual.
    std::size_t example = 0;  // One of them.
};

/// Whether a body of a class has a way from a point to one of some areas.
bool hasWay(Vec2 p, std::int32_t groundClass, const std::vector<std::size_t>& goals, Regions& regions) {
    const std::int32_t region = regions.of(p, groundClass);
    return std::any_of(goals.begin(), goals.end(), [&](std::size_t goal) {
        const std::vector<std::int32_t>& list = regions.at(goal, groundClass);
        return std::binary_search(list.begin(), list.end(), region);
    });
}

Cut cutOff(const WarnedScene& scene, std::size_t g, const std::vector<std::size_t>& goals, Regions& regions) {
    const GroupDef& group = scene.def.groups[g];
    Cut cut;
    // By class: whose starts are not given are taken to be in the middle of the group.
    std::map<std::int32_t, bool> fromMiddle;
    for (std::size_t k = 0; k < scene.bodies[g].size(); ++k) {
        const std::int32_t groundClass = groundClassFor(scene.def.parameters.character.radius,
                                                        scene.radiusOf(g, k));
        const bool given = k < group.starts.size();
        const Vec2 p = given ? group.starts[k] : group.position;
        if (scene.clearance(p) < 0.0) continue;  // Starts in obstacles have a warning of their own.
        const auto known = fromMiddle.find(groundClass);
        const bool way = !given && known != fromMiddle.end() ? known->second
                                                             : hasWay(p, groundClass, goals, regions);
        if (!given) fromMiddle[groundClass] = way;
        if (way) continue;
        if (cut.count++ == 0) cut.example = k;
        cut.large += groundClass > 0 && hasWay(p, 0, goals, regions) ? 1 : 0;
    }
    return cut;
}

/// Warns of members of a group who have no way to where an order leads.
void warnOfMembers(const WarnedScene& scene, std::size_t g, const std::string& where,
                   const std::vector<std::size_t>& goals, Regions& regions, WarningList& warnings) {
    const GroupDef& group = scene.def.groups[g];
    const Cut cut = cutOff(scene, g, goals, regions);
    if (cut.count == 0) return;
    const std::string who = groupText(scene.def, g) + " has " + std::to_string(cut.count) + " of " +
                            std::to_string(scene.bodies[g].size()) + " persons ";
    const Vec2 start = cut.example < group.starts.size() ? group.starts[cut.example] : group.position;
    const char* const what = cut.large == cut.count ? "larger than every way to " : "without a way to ";
    warnings.add(who + what + where + ": the first, of radius " + metresText(scene.radiusOf(g, cut.example)) +
                 ", starts at " + pointText(start));
}

/// Warns of sources from which people of the usual size have no way to where an order leads.
void warnOfSources(const WarnedScene& scene, std::size_t g, const std::string& where,
                   const std::vector<std::size_t>& goals, Regions& regions, WarningList& warnings) {
    for (std::size_t k = 0; k < scene.def.areas.size(); ++k) {
        const AreaDef& area = scene.def.areas[k];
        if (area.kind != AreaKind::Source || !std::cmp_equal(area.group, g)) continue;
        const std::vector<std::int32_t>& from = regions.at(k, 0);
        const bool way = std::any_of(goals.begin(), goals.end(), [&](std::size_t goal) {
            const std::vector<std::int32_t>& to = regions.at(goal, 0);
            return std::find_first_of(from.begin(), from.end(), to.begin(), to.end()) != from.end();
        });
        if (!way && !from.empty())
            warnings.add(areaText(scene.def, k) + " sends people who have no way to " + where);
    }
}

}  // namespace

void warnOfWays(const WarnedScene& scene, WarningList& warnings) {
    if (scene.def.ring) return;  // Ways lead across its seam.
    const WorldDef& def = scene.def;
    // Areas without room have a warning of their own.
    std::vector<std::size_t> usable;
    for (std::size_t k = 0; k < def.areas.size(); ++k)
        if (def.areas[k].kind != AreaKind::Source && hasRoom(scene, def.areas[k], scene.leastRadius()))
            usable.push_back(k);
    Regions regions(scene);
    for (std::size_t g = 0; g < def.groups.size(); ++g)
        for (const Order& order : def.groups[g].orders) {
            const std::vector<std::size_t> goals = goalsOf(def, order, usable);
            if (goals.empty() || warnings.full()) continue;
            warnOfMembers(scene, g, goalsText(def, order), goals, regions, warnings);
            warnOfSources(scene, g, goalsText(def, order), goals, regions, warnings);
        }
}

}  // namespace muster
