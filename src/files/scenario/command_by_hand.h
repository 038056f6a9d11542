// The fields of those commands in gesture files that are not written field by field.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "files/scenario/describe_forms.h"
#include "muster/command.h"

namespace muster {

/// The fingers of a control are written as points, each with its number.
template <class Visitor>
void describeByHand(Visitor& v, AddControl& c, double& time) {
    v.whole("group", c.group.value, kId, "Group whose mesh it controls.", Need::Required);
    describeWord(v, "control", c.kind, kControlKindWords, "Kind of control.", Need::Required);
    std::vector<std::pair<std::uint32_t, Vec2>> points;
    for (std::size_t i = 0; i < c.positions.size(); ++i) points.emplace_back(c.touches[i], c.positions[i]);
    v.list(
        "points", points, 64, "Its fingers.",
        [](auto& item, std::pair<std::uint32_t, Vec2>& point) {
            item.whole("touch", point.first, kId, "Number of the finger.", Need::Required);
            item.number("x", point.second.x, kCoordinate, "World coordinate.", Need::Required);
            item.number("y", point.second.y, kCoordinate, "World coordinate.", Need::Required);
        },
        Need::Required);
    c.touches.clear();
    c.positions.clear();
    for (const auto& [touch, position] : points) {
        c.touches.push_back(touch);
        c.positions.push_back(position);
    }
    c.time = time;
}

}  // namespace muster
