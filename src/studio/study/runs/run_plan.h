// The plan of one run with a person: which trials in which order, with which layouts (SPEC X12).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "muster/status.h"
#include "studio/study/trial/trial.h"

namespace muster {

/// What a run with a person compares.
struct PeopleSettings {
    std::string mouse = "mouse-full-continuum";  ///< The scheme that touch is compared with.
    std::int32_t crowd = 36;                     ///< Number of characters.
};

/// One trial to come.
struct PlannedTrial {
    TrialDef def;               ///< What it is of.
    bool practice = false;      ///< It does not count.
    std::int32_t period = 1;    ///< The block of its control, 1 or 2.
    std::int32_t position = 0;  ///< Its number within the block, 1 to 4; 0 for the practice.
};

/// All trials of one run.
struct PeoplePlan {
    std::int32_t order = 0;  ///< 0 to 7: the row of the square, and 4 more where the mouse is first.
    std::array<std::string, 2> schemes;  ///< The two controls, in the order of their blocks.
    std::vector<PlannedTrial> trials;    ///< For each control its practice, then its four trials.
};

/// Number of orders; people are balanced over them, and over twice as many with their layouts.
inline constexpr std::int32_t kPeopleOrders = 8;

/// The plan of the run of that number, counted from 0. Environments follow a balanced 4 by 4 Latin square:
/// each stands once at each place and once right after each other one. Both controls have the same layout of
/// items, mirrored; who gets which of the two is swapped over people. Fails with InvalidArgument where the
/// number is negative, the mouse is no other scheme than touch, or the crowd out of range.
Result<PeoplePlan> planPeople(const PeopleSettings& settings, std::int64_t number);

}  // namespace muster
