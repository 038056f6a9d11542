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

/// A finger that lifts or is lost is nowhere.
template <class Visitor>
void describeByHand(Visitor& v, Touch& c, double& time) {
    describeWord(v, "phase", c.phase, kTouchPhaseWords, "What it does.", Need::Required);
    v.whole("touch", c.touch, kId, "Number of the finger.", Need::Required);
    const bool placed = c.phase == TouchPhase::Down || c.phase == TouchPhase::Move;
    const Need need = placed && !Visitor::kSchema ? Need::Required : Need::Optional;
    if (takesPart<Visitor>(placed)) {
        v.number("x", c.position.x, kCoordinate, "For down and move: world coordinate.", need);
        v.number("y", c.position.y, kCoordinate, "For down and move: world coordinate.", need);
    }
    if (takesPart<Visitor>(static_cast<bool>(c.group)))
        v.whole("group", c.group.value, kId, "For down: group to edit; left out: the nearest.");
    c.time = c.phase == TouchPhase::Cancel ? 0.0 : time;
}

}  // namespace muster
