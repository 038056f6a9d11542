#include "studio/gestures/ground_strokes.h"

#include <algorithm>
#include <limits>

#include "studio/gestures/group_lookup.h"

namespace muster {
namespace {

constexpr double kAcross = 0.7;     // A cut covers so much of the way across a formation.
constexpr double kShortest = 0.5;   // Shorter strokes do nothing [m].
constexpr double kClosed = 0.25;    // A loop ends so near to its beginning, as a share of its length.
constexpr double kLoopRound = 0.6;  // Of those whom it holds: so many, and the whole formation is meant.

double lengthOf(std::span<const Vec2> stroke) {
    double sum = 0.0;
    for (std::size_t i = 1; i < stroke.size(); ++i) sum += distance(stroke[i - 1], stroke[i]);
    return sum;
}

bool inside(std::span<const Vec2> loop, Vec2 p) {
    bool odd = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Vec2 a = loop[i];
        const Vec2 b = loop[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) odd = !odd;
    }
    return odd;
}

// Whether the line goes through a formation's places from side to side.
bool crosses(const GroupView& group, Vec2 from, Vec2 to) {
    const Vec2 along = normalized(to - from, {1.0, 0.0});
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    bool left = false;
    bool right = false;
    for (const Vec2 p : group.placePositions) {
        const double side = cross(along, p - from);
        left = left || side > 0.0;
        right = right || side <= 0.0;
        least = std::min(least, dot(along, p - from));
        most = std::max(most, dot(along, p - from));
    }
    if (!left || !right) return false;
    const double covered = std::min(distance(from, to), most) - std::max(0.0, least);
    return covered >= kAcross * (most - least);
}

// Ids of a group's characters in a loop. One sees people, not places: they count where they are.
std::vector<std::uint32_t> idsInside(const World& world, const GroupView& group, std::span<const Vec2> loop) {
    std::vector<std::uint32_t> ids;
    for (const std::int32_t member : group.members)
        if (inside(loop, world.characters().position[member])) ids.push_back(world.characters().id[member]);
    std::sort(ids.begin(), ids.end());
    return ids;
}

std::string finishLoop(const World& world, std::span<const Vec2> loop, std::vector<CommandBody>& commands) {
    MergeGroups merge;
    merge.shape = PartShape::Smaller;
    SplitGroup part;
    part.by = SplitBy::Ids;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView group = world.group(g);
        std::vector<std::uint32_t> ids = idsInside(world, group, loop);
        if (ids.empty()) continue;
        if (static_cast<double>(ids.size()) >= kLoopRound * static_cast<double>(group.members.size()))
            merge.groups.push_back(group.id);
        if (ids.size() <= part.ids.size() || ids.size() == group.members.size()) continue;
        part.ids = std::move(ids);
        part.group = group.id;
    }
    if (merge.groups.size() >= 2) {
        commands.emplace_back(std::move(merge));
        return {};
    }
    if (part.ids.empty())
        return merge.groups.empty() ? "The loop holds nobody"
                                    : "The loop holds one whole formation: there is nothing to join";
    commands.emplace_back(std::move(part));
    return {};
}

}  // namespace

std::string finishStroke(const World& world, std::span<const Vec2> stroke,
                         std::vector<CommandBody>& commands) {
    if (stroke.size() < 2 || lengthOf(stroke) < kShortest) return {};
    const Vec2 from = stroke.front();
    const Vec2 to = stroke.back();
    if (stroke.size() > 3 && distance(from, to) < kClosed * lengthOf(stroke))
        return finishLoop(world, stroke, commands);
    bool any = false;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView group = world.group(g);
        if (group.members.size() < 2 || !crosses(group, from, to)) continue;
        SplitGroup split;
        split.group = group.id;
        split.by = SplitBy::Line;
        split.points = {from, to};
        commands.emplace_back(std::move(split));
        any = true;
    }
    return any ? "" : "The stroke crosses no formation: draw it from one side to the other";
}

}  // namespace muster
