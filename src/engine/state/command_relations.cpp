#include "engine/state/generated/command_relations.h"

#include <algorithm>

#include "engine/state/command_checks.h"
#include "engine/state/group_change.h"
#include "engine/state/validation.h"
#include "engine/state/validation_parts.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

constexpr std::size_t kMaxTouches = 64;  // Of one control.

Status differInNumber(const char* fields) {
    return invalidArgument(std::string(fields) + " differ in number");
}

Status nothingGiven() {
    return invalidArgument("found nothing that it changes, expected one field or more");
}

}  // namespace

Status place(const char* field, Vec2 p) {
    if (isInWorld(p)) return {};
    return invalidArgument(std::string(field) + " is not finite or farther than 1e6 m from the origin");
}

Status places(const char* field, const std::vector<Vec2>& points, std::size_t least, std::size_t most) {
    if (points.size() < least)
        return invalidArgument(std::string(field) + " are empty, expected at least one");
    if (points.size() > most)
        return {StatusCode::LimitExceeded, std::string(field) + " are more than " + std::to_string(most)};
    for (const Vec2 p : points)
        if (Status s = place("position", p); !s.ok()) return s.within(field);
    return {};
}

Status eachOnce(const std::vector<std::uint32_t>& ids) {
    if (ids.empty() || ids.size() > static_cast<std::size_t>(kMaxCharacters))
        return invalidArgument("found " + std::to_string(ids.size()) + " ids, expected 1 to " +
                               std::to_string(kMaxCharacters));
    std::vector<std::uint32_t> sorted = ids;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) return invalidArgument("id " + std::to_string(*twice) + " is named twice");
    return {};
}

Status numberIn(const char* field, double value, double low, double high, const char* range) {
    if (value >= low && value <= high) return {};
    return invalidArgument(std::string(field) + " is not in " + range);
}

Status countIn(const char* field, std::int32_t value, std::int32_t low, std::int32_t high) {
    if (value >= low && value <= high) return {};
    return invalidArgument(std::string(field) + " is " + std::to_string(value) + ", expected " +
                           std::to_string(low) + " to " + std::to_string(high));
}

Status relations(const AddControl& c) {
    const std::size_t n = c.positions.size();
    if (c.touches.size() != n) return differInNumber("touches and positions");
    if (n == 0 || n > kMaxTouches) return invalidArgument("a control has 1 to 64 points");
    if (std::min<std::size_t>(n, 3) != static_cast<std::size_t>(c.kind) + 1)
        return invalidArgument("the number of points does not suit the kind of control");
    for (const Vec2 p : c.positions)
        if (Status s = place("position", p); !s.ok()) return s;
    return {};
}

Status relations(const PutThing& c) {
    const int given = int{c.obstacle.has_value()} + int{c.patch.has_value()} + int{c.item.has_value()} +
                      int{c.checkpoint.has_value()} + int{c.area.has_value()};
    if (given == 1) return {};
    return invalidArgument("found " + std::to_string(given) + " definitions, expected one");
}

Status relations(const SetParameter& c) {
    if (c.name == "time.step") return invalidArgument("time.step cannot change while a world runs");
    Parameters scratch;
    return setParameter(scratch, c.name, c.value);
}

Status relations(const AddCharacters& c) {
    return validateBodies(c.bodies, c.positions.size(), true);
}

Status relations(const SplitGroup& c) {
    if (c.by == SplitBy::Ids) return eachOnce(c.ids);
    if (c.by == SplitBy::Line && (c.points.size() != 2 || c.points[0] == c.points[1]))
        return invalidArgument("a line needs two different points");
    if (c.by == SplitBy::Lasso && c.points.size() < 3)
        return invalidArgument("a lasso needs 3 to " + std::to_string(kMaxCorners) + " corners");
    if (c.by != SplitBy::Shares) return {};
    if (c.shares.size() < 2 || c.shares.size() > kMaxGroups)
        return invalidArgument("found " + std::to_string(c.shares.size()) + " shares, expected 2 or more");
    for (const double share : c.shares)
        if (!(share > 0.0 && share <= 1e6)) return invalidArgument("a share is not in (0, 1e6]");
    return {};
}

Status relations(const MergeGroups& c) {
    if (c.groups.size() < 2 || c.groups.size() > kMaxGroups)
        return invalidArgument("found " + std::to_string(c.groups.size()) + " groups, expected 2 or more");
    std::vector<GroupId> sorted = c.groups;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        return invalidArgument("a group is named twice");
    return {};
}

Status relations(const ChangeCharacters& c) {
    if (!c.bodies && !c.driver) return nothingGiven();
    return c.bodies ? validateBodies(*c.bodies, c.ids.size(), false) : Status();
}

Status relations(const ChangeGroup& c) {
    if (givenFields(c).empty()) return nothingGiven();
    return c.demands ? validateDemands(*c.demands) : Status();
}

Status relations(const WriteMotion& c) {
    if (c.positions.size() == c.ids.size() && (c.velocities.empty() || c.velocities.size() == c.ids.size()))
        return {};
    return differInNumber("ids, positions and velocities");
}

}  // namespace muster
