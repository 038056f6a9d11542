#include "studio/gestures/group_lookup.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

double distanceToSegment(Vec2 p, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double squared = lengthSquared(along);
    const double t = squared > 0.0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return distance(p, a + along * t);
}

// To the nearest triangle; 0 inside. Bent triangles may have either sense.
double distanceToMesh(const GroupView& group, Vec2 p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& t : group.triangles) {
        const Vec2 a = group.finalMesh[t[0]];
        const Vec2 b = group.finalMesh[t[1]];
        const Vec2 c = group.finalMesh[t[2]];
        const double ab = cross(b - a, p - a);
        const double bc = cross(c - b, p - b);
        const double ca = cross(a - c, p - c);
        if ((ab >= 0.0 && bc >= 0.0 && ca >= 0.0) || (ab <= 0.0 && bc <= 0.0 && ca <= 0.0)) return 0.0;
        nearest = std::min(
            {nearest, distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
    }
    return nearest;
}

}  // namespace

std::int32_t groupIndex(const World& world, GroupId id) {
    for (std::size_t g = 0; g < world.groupCount(); ++g)
        if (world.group(g).id == id) return static_cast<std::int32_t>(g);
    return -1;
}

GroupId groupAt(const World& world, Vec2 ground, double reach) {
    GroupId best;
    double nearest = reach;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView group = world.group(g);
        if (group.members.empty()) continue;
        const double away = distanceToMesh(group, ground);
        if (away > nearest || (best && away >= nearest)) continue;
        nearest = away;
        best = group.id;
    }
    return best;
}

double metresFor(const GroundView& view, Vec2 screen, double millimetres) {
    const double px = millimetres / view.mmPerPixel;
    const auto a = view.groundAt(screen);
    const auto b = view.groundAt(screen + Vec2{px, 0.0});
    return a && b ? distance(*a, *b) : 0.0;
}

std::int32_t characterAt(const World& world, const GroundView& view, Vec2 screen, double millimetres) {
    const std::span<const Vec2> positions = world.characters().position;
    std::int32_t best = -1;
    double nearest = millimetres / view.mmPerPixel;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        const auto at = view.screenOf(positions[i]);
        if (!at || distance(*at, screen) > nearest) continue;
        nearest = distance(*at, screen);
        best = static_cast<std::int32_t>(i);
    }
    return best;
}

std::vector<std::uint32_t> charactersIn(const World& world, const GroundView& view, Vec2 from, Vec2 to) {
    const CharactersView characters = world.characters();
    const Box box{{std::min(from.x, to.x), std::min(from.y, to.y)},
                  {std::max(from.x, to.x), std::max(from.y, to.y)}};
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const auto at = view.screenOf(characters.position[i]);
        if (at && box.contains(*at)) ids.push_back(characters.id[i]);
    }
    return ids;
}

std::vector<std::uint32_t> membersOf(const World& world, std::int32_t index) {
    const CharactersView characters = world.characters();
    std::vector<std::uint32_t> ids;
    for (const std::int32_t i : world.group(static_cast<std::size_t>(index)).members)
        ids.push_back(characters.id[i]);
    return ids;
}

Vec2 middleOf(const World& world, std::int32_t index) {
    const GroupView group = world.group(static_cast<std::size_t>(index));
    Vec2 sum;
    for (const std::int32_t i : group.members) sum += world.characters().position[i];
    return group.members.empty() ? group.pose.position : sum / static_cast<double>(group.members.size());
}

std::vector<Vec2> cornersOf(const GroundView& view, Vec2 from, Vec2 to) {
    std::vector<Vec2> corners;
    for (const Vec2 corner : {from, Vec2{to.x, from.y}, to, Vec2{from.x, to.y}})
        if (const auto ground = view.groundAt(corner)) corners.push_back(*ground);
    return corners;
}

}  // namespace muster
