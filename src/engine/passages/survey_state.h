// Surveys of passages that are under way, as a saved world holds them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/passages/passage.h"

namespace muster {

/// One who has to go somewhere, for all those who have to go about the same way.
struct SurveyDef {
    Vec2 from;                ///< [m]
    Vec2 to;                  ///< [m]
    double people = 0.0;      ///< How many have to go, about.
    double speed = 2.0;       ///< Cost of what they walk in a second [m].
    double flow = 4.5;        ///< Of them through a metre of a passage [1/(s m)].
    std::uint32_t crowd = 0;  ///< How many of SurveyState::crowd belong to them.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(from, to, people, speed, flow, crowd);
    }
};

/// Where the search for passages is.
enum class SurveyPhase : std::uint8_t {
    None,    ///< Nobody looks for passages.
    Search,  ///< Ways are searched.
    Fields,  ///< The walks to the new passages are solved.
};

/// What a survey has come to: the results of the searches that are done, and how far the present one is. The
/// march of that search is repeated after loading.
struct SurveyState {
    SurveyPhase phase = SurveyPhase::None;
    bool crossing = false;          ///< Somebody has to go through a passage that was known before.
    std::vector<SurveyDef> orders;  ///< Surveys to be made; the first one is under way.
    std::vector<Vec2> crowd;        ///< Positions of some who have to go, those of the first order first [m].
    std::vector<Passage> passages;  ///< Those known before, then those found.
    std::uint32_t known = 0;        ///< Of `passages`, those not found by the present survey.
    std::uint32_t searches = 0;     ///< Done by the present survey.
    double shortest = 0.0;          ///< Cost of the first way [m]; 0 while none is found.
    double capacity = 0.0;          ///< Of the passages that the present survey found [1/s].
    std::vector<double> openCost;   ///< From the crowd to the goal, in the first search [m].
    std::int64_t cells = 0;         ///< Solved in the present search, or of the walks.

    /// Those of the crowd who belong to the survey that is under way.
    std::span<const Vec2> presentCrowd() const { return std::span(crowd).first(orders.front().crowd); }

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(phase, crossing, orders, crowd, passages, known, searches, shortest, capacity, openCost,
                cells);
    }
};

}  // namespace muster
