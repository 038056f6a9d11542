#include "studio/words/stands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/maths.h"
#include "engine/formation/shapes/make_formation.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "muster/views.h"

namespace muster::words {
namespace {

constexpr double kGap = 1.0;           // Between a formation and what it stands beside [m].
constexpr double kMargin = 3.0;        // Between an edge of the place and who goes there [m].
constexpr double kShift = 10.0;        // How far "north" is where nothing is said [m].
constexpr double kMostSpacing = 20.0;  // [m]
constexpr int kPasses = 64;

/// What a spot is round: its centre, and how far it reaches.
struct Core {
    Vec2 centre;
    const ThingSpot* thing = nullptr;  // An obstacle.
    std::optional<Extent> crowd;       // A group.

    double reach(Vec2 direction) const {
        if (thing != nullptr) return thing->reach(direction);
        return crowd ? crowd->farthest() : 0.0;
    }
    /// The radius within which nobody can stand [m].
    double farthest() const {
        if (isFree()) return 0.0;
        double most = thing != nullptr ? thing->radius : crowd->farthest();
        if (thing != nullptr)
            for (const Vec2 p : thing->outline) most = std::max(most, distance(p, thing->centre));
        return most + kGap;
    }
    bool isFree() const { return thing == nullptr && !crowd; }
};

Vec2 edgePoint(Heading heading, const Box& box) {
    const Vec2 middle = (box.min + box.max) * 0.5;
    const Vec2 half = {std::max(0.0, box.width() / 2 - kMargin), std::max(0.0, box.height() / 2 - kMargin)};
    const Vec2 d = directionOf(heading, {});
    const auto sign = [](double v) { return v > 0.1 ? 1.0 : v < -0.1 ? -1.0 : 0.0; };
    return middle + Vec2{sign(d.x) * half.x, sign(d.y) * half.y};
}

Rotation frontOf(const World& world, GroupId group) {
    const auto g = inspect::indexOfGroup(world, group);
    return g ? world.group(*g).pose.rotation : Rotation{};
}

Core coreOf(const Spot& spot, const World& world, const Crew& from) {
    Core core;
    core.centre = pointOf(spot, world, from);
    if (spot.kind == SpotKind::Thing && spot.beside != Beside::Off) {
        const ThingSpot& thing = nearestOf(spot.things, from.middle);
        if (thing.kind == NamedKind::Obstacle) core.thing = &thing;
    }
    if (spot.kind == SpotKind::Group && spot.beside != Beside::Off)
        if (const auto g = inspect::indexOfGroup(world, spot.group))
            core.crowd = extentOf(inspect::ownFormation(world, *g), world.group(*g).count);
    return core;
}

/// The direction from the core in which a crew stands.
Vec2 sideOf(const Spot& spot, const World& world, const Core& core, const Crew& crew) {
    const Vec2 towards = normalized(crew.middle - core.centre, {0.0, -1.0});
    const Vec2 front = spot.kind == SpotKind::Group ? frontOf(world, spot.group).apply({1.0, 0.0}) : towards;
    if (spot.beside == Beside::InFront) return front;
    if (spot.beside == Beside::Behind) return -front;
    return towards;
}

/// The direction of one of several who stand round a core.
struct Bearing {
    double angle = 0.0;
    double half = 0.0;  // Half the angle that it takes up.
    std::size_t crew = 0;
};

/// Pushes them apart until none is in another one. False where there is no room for all.
bool part(std::vector<Bearing>& bearings) {
    double sum = 0.0;
    for (const Bearing& bearing : bearings) sum += 2.0 * bearing.half;
    if (sum > 2.0 * kPi) return false;
    std::sort(bearings.begin(), bearings.end(), [](const Bearing& a, const Bearing& b) {
        return std::pair(a.angle, a.crew) < std::pair(b.angle, b.crew);
    });
    for (int pass = 0; pass < kPasses; ++pass)
        for (std::size_t k = 0; k < bearings.size(); ++k) {
            Bearing &a = bearings[k], &b = bearings[(k + 1) % bearings.size()];
            const double turn = k + 1 == bearings.size() ? 2.0 * kPi : 0.0;
            const double missing = a.half + b.half - (b.angle + turn - a.angle);
            if (missing <= 0.0 || bearings.size() < 2) continue;
            a.angle -= missing / 2.0;
            b.angle += missing / 2.0;
        }
    return true;
}

/// Rings round the core, one round the other.
std::vector<Stand> rings(const Core& core, const std::vector<Crew>& crews,
                         const std::vector<FormationDef>& formations) {
    std::vector<Stand> stands;
    double free = core.farthest();
    for (std::size_t k = 0; k < crews.size(); ++k) {
        const Extent extent = extentOf(formations[k], crews[k].count());
        Stand stand{core.centre, {}, {}};
        double factor = 1.0;
        if (extent.inner > 1e-9) factor = std::max(1.0, free / extent.inner);
        if (factor > 1.0) stand.spacing = std::min(kMostSpacing, formations[k].spacing * factor);
        free = extent.farthest() * factor + kGap;
        stands.push_back(stand);
    }
    return stands;
}

}  // namespace

const ThingSpot& nearestOf(const std::vector<ThingSpot>& things, Vec2 from) {
    return *std::min_element(things.begin(), things.end(), [&](const ThingSpot& a, const ThingSpot& b) {
        return distance(a.centre, from) < distance(b.centre, from);
    });
}

Extent extentOf(const FormationDef& formation, std::int32_t count) {
    Extent extent;
    if (count < 1) return extent;
    const Result<Formation> made = makeFormation(formation, count);
    if (!made.ok()) return extent;
    extent = {-1e9, -1e9, 0.0, 1e9};
    for (const MeshPoint& point : made->places) {
        const Vec2 p = point.position(made->mesh.triangles, made->mesh.vertices);
        extent.front = std::max(extent.front, p.x);
        extent.rear = std::max(extent.rear, -p.x);
        extent.side = std::max(extent.side, std::fabs(p.y));
        extent.inner = std::min(extent.inner, length(p));
    }
    return extent;
}

Vec2 directionOf(Heading heading, Rotation front) {
    const auto number = static_cast<double>(heading);
    if (isCompass(heading)) return {cosine(number * kPi / 4.0), sine(number * kPi / 4.0)};
    switch (heading) {
        case Heading::Left:
            return front.apply({0.0, 1.0});
        case Heading::Right:
            return front.apply({0.0, -1.0});
        case Heading::Back:
            return front.apply({-1.0, 0.0});
        default:
            return front.apply({1.0, 0.0});
    }
}

Vec2 pointOf(const Spot& spot, const World& world, const Crew& from) {
    const Box box = inspect::environment(world).def().box;
    Vec2 point = spot.point;
    Rotation front = from.front;
    switch (spot.kind) {
        case SpotKind::Point:
            break;
        case SpotKind::Thing:
            point = nearestOf(spot.things, from.middle).centre;
            break;
        case SpotKind::Group:
            if (const auto g = inspect::indexOfGroup(world, spot.group))
                point = world.group(*g).pose.position;
            front = frontOf(world, spot.group);
            break;
        case SpotKind::Middle:
            point = (box.min + box.max) * 0.5;
            break;
        case SpotKind::Edge:
            point = edgePoint(spot.heading, box);
            break;
        case SpotKind::Shift:
            point = from.middle + directionOf(spot.heading, front) * spot.metres.value_or(kShift);
            break;
        case SpotKind::Between:
            point = (spot.things[0].centre + spot.things[1].centre) * 0.5;
            break;
    }
    if (spot.beside == Beside::Off) {
        const Vec2 away = directionOf(spot.heading, front);
        const double reach = spot.kind == SpotKind::Thing ? nearestOf(spot.things, from.middle).reach(away)
                                                          : 0.0;
        point += away * (spot.metres ? *spot.metres + reach
                                     : reach + extentOf(from.formation, from.count()).farthest() + kGap);
    }
    return point;
}

std::vector<Stand> standsAt(const Spot& spot, const World& world, const std::vector<Crew>& crews,
                            const std::vector<FormationDef>& formations) {
    const Core core = coreOf(spot, world, crews.front());
    const bool round = std::all_of(formations.begin(), formations.end(), [](const FormationDef& formation) {
        return formation.kind == FormationKind::Ring;
    });
    if (spot.kind == SpotKind::Shift) {
        std::vector<Stand> stands;
        for (const Crew& crew : crews) {
            Stand stand{pointOf(spot, world, crew), {}, {}};
            if (!isCompass(spot.heading)) stand.facing = crew.heading();
            stands.push_back(stand);
        }
        return stands;
    }
    if (round && spot.beside != Beside::Near) return rings(core, crews, formations);
    if (core.isFree() && crews.size() == 1) return {Stand{core.centre, {}, {}}};
    std::vector<Vec2> sides;
    std::vector<Extent> extents;
    for (std::size_t k = 0; k < crews.size(); ++k) {
        sides.push_back(sideOf(spot, world, core, crews[k]));
        extents.push_back(extentOf(formations[k], crews[k].count()));
    }
    std::vector<Bearing> bearings;
    std::vector<Stand> stands(crews.size());
    for (double away = kGap; stands.size() > 0; away = away * 1.25 + 0.5) {
        bearings.clear();
        std::vector<double> distances;
        for (std::size_t k = 0; k < crews.size(); ++k) {
            const Vec2 side = sides[k];
            const Extent& extent = extents[k];
            const double far = core.reach(side) + extent.front + away;
            distances.push_back(far);
            const double near = std::max(0.5, far - extent.front);
            bearings.push_back({arcTangent2(side.y, side.x), arcTangent2(extent.side + kGap / 2.0, near), k});
        }
        if (!part(bearings) && away < 1e3) continue;
        for (const Bearing& bearing : bearings) {
            const Vec2 side{cosine(bearing.angle), sine(bearing.angle)};
            const double far = std::max(distances[bearing.crew], core.reach(side) + away);
            stands[bearing.crew] = {core.centre + side * far, arcTangent2(-side.y, -side.x), {}};
        }
        break;
    }
    return stands;
}

}  // namespace muster::words
