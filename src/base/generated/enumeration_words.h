// Made by schema/generate.mjs from schema/enumerations.txt: change these, not this file.
// The words of enumerations in files and messages, in the order of their values.
#pragma once

#include <array>

namespace muster {

// clang-format off
inline constexpr std::array kFormationKindWords{
    "square", "line", "column", "wedge", "ring", "circle", "crescent", "pacman", "outline", "points"};
// clang-format on
inline constexpr std::array kBodyBuildWords{"broad", "narrow"};
inline constexpr std::array kMotionSetWords{"march", "weary"};
inline constexpr std::array kMotionPhaseWords{"steady", "entering", "leaving", "locked"};
inline constexpr std::array kControlKindWords{"point", "line", "area"};
inline constexpr std::array kAreaKindWords{"exit", "source", "waiting"};
inline constexpr std::array kThingKindWords{"obstacle", "patch", "item", "checkpoint", "area"};
inline constexpr std::array kCheckpointTriggerWords{"crowd", "mesh"};
inline constexpr std::array kSpreadWords{"constant", "uniform", "normal", "logNormal", "gamma", "weibull"};
// clang-format off
inline constexpr std::array kRoleAreaWords{
    "front", "rear", "rim", "centre", "leftFlank", "rightFlank", "flanks"};
// clang-format on
inline constexpr std::array kDriverWords{"muster", "outside"};
inline constexpr std::array kSplitByWords{"ids", "line", "lasso", "shares"};
inline constexpr std::array kPartShapeWords{"asHeld", "smaller"};
inline constexpr std::array kOrderKindWords{"move", "face", "follow", "guard", "leave", "wait", "walk"};
inline constexpr std::array kExitChoiceWords{"quickest", "nearest"};
inline constexpr std::array kMannerWords{"march", "free", "continuum"};
inline constexpr std::array kTurnWords{"wheel", "reverse", "keep", "flow"};
inline constexpr std::array kTouchPhaseWords{"down", "move", "up", "cancel"};
inline constexpr std::array kControlEditWords{"pin", "release", "remove"};
inline constexpr std::array kQueueModeWords{"replace", "append", "insert"};
inline constexpr std::array kQueueEditWords{"cancel", "hold", "resume", "patrol", "endPatrol", "stop"};
inline constexpr std::array kStanceWords{"normal", "hold", "yield"};
// clang-format off
inline constexpr std::array kStandingWords{
    "inPlace", "onTheWay", "held", "stuck", "outside", "obstacle", "narrow", "noWay", "crowded"};
// clang-format on
// clang-format off
inline constexpr std::array kEventKindWords{
    "enterPatch", "leavePatch", "transitionStart", "transitionEnd", "singleStep", "collect",
    "formationChange", "swap", "arrived", "stuck", "blocked", "free", "noPath", "partial", "orderGiven",
    "orderBegun", "orderDone", "orderSkipped", "passed", "groupAdded", "groupRemoved", "joined", "left",
    "transferred", "exited", "entered"};
// clang-format on

}  // namespace muster
