#include "engine/systems/passages/survey_trigger.h"

#include <algorithm>

#include "engine/passages/specific_flow.h"
#include "engine/systems/passages/goals.h"

namespace muster {
namespace {

constexpr std::size_t kSamples = 32;  // Characters of a group that are looked at in each choice.
// The reciprocal of the share of hidden goals that calls for a survey.
constexpr std::size_t kHiddenFraction = 8;
// Distance that an end of a survey moves before another survey is made [m].
constexpr double kSurveyMoved = 2.0;
constexpr double kLeastSurveyLength = 5.0;  // Least distance from a character to its goal for a survey [m].

}  // namespace

// Samples characters: true where one has to go through a known passage. Lists the goals that no known passage
// explains.
bool SurveyTrigger::sample(const WorldState& state, const WayFields& fields, const Group& group) {
    const std::size_t stride = std::max<std::size_t>(1, group.members.size() / kSamples);
    bool crossing = false;
    looked_ = 0;
    hidden_.clear();
    for (std::size_t k = 0; k < group.members.size(); k += stride) {
        const std::int32_t i = group.members[k];
        const std::int32_t place = state.characters.place[i];
        if (place < 0) continue;
        ++looked_;
        const Vec2 from = fields.inRoom(state.characters.position[i]);
        const Vec2 to = fields.inRoom(goalOf(group, place));
        bool known = false;
        for (std::size_t p = 0; p < state.passages.size() && !known; ++p)
            known = onOppositeSides(fields.walk(p, from), fields.walk(p, to));
        crossing = crossing || known;
        // A foreseen goal may lie in a wall, which has two sides.
        const bool free = state.environment.distanceToObstacle(to) > state.parameters.character.radius;
        if (!known && free && !fields.ground().collisionFree(from, to)) hidden_.push_back({from, to});
    }
    return crossing;
}

const SurveyTrigger::Line& SurveyTrigger::middleLine() const {
    Vec2 mean;
    for (const auto& [from, to] : hidden_) mean += from / static_cast<double>(hidden_.size());
    return *std::min_element(hidden_.begin(), hidden_.end(), [&](const Line& x, const Line& y) {
        return lengthSquared(x.first - mean) < lengthSquared(y.first - mean);
    });
}

bool SurveyTrigger::look(const WorldState& state, const WayFields& fields, Group& group,
                         SurveyState& survey) {
    const bool crossing = sample(state, fields, group);
    if (hidden_.empty() || hidden_.size() * kHiddenFraction < looked_) return crossing;
    const auto& [from, to] = middleLine();
    // A character close behind its place needs no way chosen far ahead.
    if (distance(from, to) < kLeastSurveyLength) return crossing;
    if (distance(from, group.surveyFrom) < kSurveyMoved && distance(to, group.surveyTo) < kSurveyMoved)
        return crossing;
    group.surveyFrom = from;
    group.surveyTo = to;
    survey.orders.push_back({from, to, static_cast<double>(state.characters.size()),
                             metresPerSecond(state.parameters), specificFlow(state.parameters.character),
                             static_cast<std::uint32_t>(hidden_.size())});
    for (const Line& line : hidden_) survey.crowd.push_back(line.first);
    return crossing;
}

}  // namespace muster
