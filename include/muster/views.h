// Read access to a world: its characters, groups, controls, obstacles, patches, areas and stage times.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "muster/generated/characters.h"
#include "muster/generated/views.h"

namespace muster {

/// Number of stages of a step.
inline constexpr std::size_t kStageCount = 41;

/// A stage of the step.
struct StageInfo {
    std::string_view name;    ///< "commands", "orders", "controls"...
    std::string_view reads;   ///< What it reads of the state and of the stages before it.
    std::string_view writes;  ///< What it writes.
    std::string_view about;   ///< What it does, in one sentence.
};
/// The stages of a step, in their order.
std::span<const StageInfo, kStageCount> stepStages();

/// Some stages by their index in stepStages(), for programs that time them.
enum class Stage : std::uint8_t {
    Commands = 0,         ///< Commands are applied.
    Orders = 3,           ///< Orders and marches.
    Controls = 4,         ///< Controls follow touches.
    UserMesh = 5,         ///< Vu is solved.
    FinalMesh = 6,        ///< Vf is solved.
    Places = 12,          ///< Travelling places.
    DensityAndCost = 13,  ///< Density of the crowd.
    Plan = 21,            ///< Assignment of places.
    Steering = 31,        ///< Velocities of characters.
    Contacts = 32,        ///< Contacts are resolved.
    Patches = 33,         ///< Motions by patches.
    Events = 38,          ///< Arrivals of groups.
    Count = kStageCount   ///< Number of all stages.
};
/// The name of any stage, by its index: "commands", "orders", "controls"...
const char* stageName(Stage stage);

/// Wall time of the last step by stage; it is not part of the state. WebAssembly times the stages of every
/// eighth step only.
struct StageTimes {
    std::array<double, kStageCount>
        milliseconds{};  ///< Time of each stage [ms], in the order of stepStages().
    double total = 0.0;  ///< Time of the whole step [ms].
};

}  // namespace muster
