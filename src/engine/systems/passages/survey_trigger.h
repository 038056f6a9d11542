// Decides when passages are looked for.
#pragma once

#include <utility>
#include <vector>

#include "engine/passages/survey_state.h"
#include "engine/state/world_state.h"
#include "engine/systems/passages/way_fields.h"

namespace muster {

/// Decides from a sample of the characters of a group.
class SurveyTrigger {
public:
    /// True where a character has to go through a known passage. Where many goals are hidden by something
    /// that no known passage explains, appends an order to `survey` and notes its ends in the group.
    bool look(const WorldState& state, const WayFields& fields, Group& group, SurveyState& survey);

private:
    // Position of a character, and its goal.
    using Line = std::pair<Vec2, Vec2>;

    bool sample(const WorldState& state, const WayFields& fields, const Group& group);
    const Line& middleLine() const;

    std::size_t looked_ = 0;
    std::vector<Line> hidden_;  // Positions and goals with something in between.
};

}  // namespace muster
