// Which formations and characters lie under a pointer, and who comes where somebody is called to
// (docs/method/gestures.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "muster/world.h"
#include "studio/gestures/input_event.h"

namespace muster {

/// Index of the group of that id; -1 for none.
std::int32_t groupIndex(const World& world, GroupId id);
/// The group whose final mesh holds a point of the ground, or whose rim is nearest within `reach` [m]; none
/// for free ground.
GroupId groupAt(const World& world, Vec2 ground, double reach);
/// How far a reach on the display leads on the ground near a point [m].
double metresFor(const GroundView& view, Vec2 screen, double millimetres);
/// The character that is nearest to a point of the screen within `millimetres`; -1 for none.
std::int32_t characterAt(const World& world, const GroundView& view, Vec2 screen, double millimetres);
/// Ids of the characters in a box on the screen, ascending.
std::vector<std::uint32_t> charactersIn(const World& world, const GroundView& view, Vec2 from, Vec2 to);
/// Ids of a group's characters, ascending.
std::vector<std::uint32_t> membersOf(const World& world, std::int32_t index);
/// Where a group's people are on average [m].
Vec2 middleOf(const World& world, std::int32_t index);
/// The four corners on the ground of a box on the screen; fewer where the camera sees none.
std::vector<Vec2> cornersOf(const GroundView& view, Vec2 from, Vec2 to);

/// Id of the character that is nearest to a point [m]; a way that an obstacle bars counts twice. Who is alone
/// and still on the way to an order does not turn round. None where nobody is left. Of two that are as near
/// the one with the smaller id comes.
std::optional<std::uint32_t> whoComes(const World& world, Vec2 to);

}  // namespace muster
