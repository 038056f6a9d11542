// Whether people have a way to an exit of theirs, by the regions of ground that bodies of their size walk on.
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

/// The exits of an order that bodies have room in, as indices of areas.
std::vector<std::size_t> exitsOf(const Order& order, const std::vector<std::size_t>& usable) {
    std::vector<std::size_t> exits;
    for (const std::size_t k : usable) {
        const bool named = order.exits.empty() || std::any_of(order.exits.begin(), order.exits.end(),
                                                              [&](AreaId id) { return id.value == k + 1; });
        if (named) exits.push_back(k);
    }
    return exits;
}

/// The members of a group who have no way to any of its exits.
struct Cut {
    std::size_t count = 0;    // How many.
    std::size_t large = 0;    // How many of them would have one if they were as small as usual.
    std::size_t example = 0;  // One of them.
};

/// Whether a body of a class has a way from a point to one of some exits.
bool hasWay(Vec2 p, std::int32_t groundClass, const std::vector<std::size_t>& exits, Regions& regions) {
    const std::int32_t region = regions.of(p, groundClass);
    return std::any_of(exits.begin(), exits.end(), [&](std::size_t exit) {
        const std::vector<std::int32_t>& list = regions.at(exit, groundClass);
        return std::binary_search(list.begin(), list.end(), region);
    });
}

Cut cutOff(const WarnedScene& scene, std::size_t g, const std::vector<std::size_t>& exits, Regions& regions) {
    const GroupDef& group = scene.def.groups[g];
    Cut cut;
    // By class: whose starts are not given are taken to be in the middle of the group.
    std::map<std::int32_t, bool> fromMiddle;
    for (std::size_t k = 0; k < scene.bodies[g].size(); ++k) {
        const std::int32_t groundClass = groundClassFor(scene.def.parameters.character.radius,
                                                        scene.radiusOf(g, k));
        const bool given = k < group.starts.size();
        const Vec2 p = given ? group.starts[k] : group.position;
        if (scene.clearance(p) < 0.0) continue;  // Who stands in an obstacle is told of elsewhere.
        const auto known = fromMiddle.find(groundClass);
        const bool way = !given && known != fromMiddle.end() ? known->second
                                                             : hasWay(p, groundClass, exits, regions);
        if (!given) fromMiddle[groundClass] = way;
        if (way) continue;
        if (cut.count++ == 0) cut.example = k;
        cut.large += groundClass > 0 && hasWay(p, 0, exits, regions) ? 1 : 0;
    }
    return cut;
}

/// The first order of a group by which it leaves; null where it has none.
const Order* leaveOf(const GroupDef& group) {
    const auto at = std::find_if(group.orders.begin(), group.orders.end(),
                                 [](const Order& order) { return order.kind == OrderKind::Leave; });
    return at == group.orders.end() ? nullptr : &*at;
}

/// Warns of members of a group who have no way.
void warnOfMembers(const WarnedScene& scene, std::size_t g, const std::vector<std::size_t>& exits,
                   Regions& regions, WarningList& warnings) {
    const GroupDef& group = scene.def.groups[g];
    const Cut cut = cutOff(scene, g, exits, regions);
    if (cut.count == 0) return;
    const std::string who = groupText(scene.def, g) + " has " + std::to_string(cut.count) + " of " +
                            std::to_string(scene.bodies[g].size()) + " persons ";
    const Vec2 start = cut.example < group.starts.size() ? group.starts[cut.example] : group.position;
    const std::string example = ": the first, of radius " + metresText(scene.radiusOf(g, cut.example)) +
                                ", starts at " + pointText(start);
    const bool large = cut.large == cut.count;
    warnings.add(who +
                 (large ? "larger than every way to their exits" : "without a way to an exit of theirs") +
                 example);
}

/// Warns of sources from which people of the usual size have no way.
void warnOfSources(const WarnedScene& scene, std::size_t g, const std::vector<std::size_t>& exits,
                   Regions& regions, WarningList& warnings) {
    for (std::size_t k = 0; k < scene.def.areas.size(); ++k) {
        const AreaDef& area = scene.def.areas[k];
        if (area.kind != AreaKind::Source || !std::cmp_equal(area.group, g)) continue;
        const std::vector<std::int32_t>& from = regions.at(k, 0);
        const bool way = std::any_of(exits.begin(), exits.end(), [&](std::size_t exit) {
            const std::vector<std::int32_t>& to = regions.at(exit, 0);
            return std::find_first_of(from.begin(), from.end(), to.begin(), to.end()) != from.end();
        });
        if (!way && !from.empty())
            warnings.add(areaText(scene.def, k) + " sends people who have no way to an exit of theirs");
    }
}

}  // namespace

void warnOfWays(const WarnedScene& scene, WarningList& warnings) {
    if (scene.def.ring) return;  // Ways lead across its seam.
    const std::vector<AreaDef>& areas = scene.def.areas;
    // Exits without room are told of elsewhere.
    std::vector<std::size_t> usable;
    for (std::size_t k = 0; k < areas.size(); ++k)
        if (areas[k].kind == AreaKind::Exit && hasRoom(scene, areas[k], scene.leastRadius()))
            usable.push_back(k);
    Regions regions(scene);
    for (std::size_t g = 0; g < scene.def.groups.size() && !warnings.full(); ++g) {
        const Order* const order = leaveOf(scene.def.groups[g]);
        if (order == nullptr) continue;
        const std::vector<std::size_t> exits = exitsOf(*order, usable);
        if (exits.empty()) continue;
        warnOfMembers(scene, g, exits, regions, warnings);
        warnOfSources(scene, g, exits, regions, warnings);
    }
}

}  // namespace muster
