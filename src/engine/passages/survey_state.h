// Surveys of passages that are under way, as a saved world holds them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/passages/passage.h"

namespace muster {

/// A survey for people that have about the same route.
struct SurveyDef {
    Vec2 from;                ///< Position of one of them [m].
    Vec2 to;                  ///< Its goal [m].
    double people = 0.0;      ///< Approximate number of people.
    double speed = 2.0;       ///< Cost that they walk in a second [m].
    double flow = 4.5;        ///< Flow of these people through a metre of a passage [1/(s m)].
    std::uint32_t crowd = 0;  ///< Number of entries of SurveyState::crowd that belong to them.

    /// Lets an archive read or write the survey.
    template <class Archive>
    void visit(Archive& archive) {
        archive(from, to, people, speed, flow, crowd);
    }
};

/// Phase of the search for passages.
enum class SurveyPhase : std::uint8_t {
    None,    ///< No search is under way.
    Search,  ///< Routes are searched.
    Fields,  ///< The walks to the new passages are solved.
};

/// State of a survey: the results of the searches that are done, and the progress of the present one, whose
/// march is repeated after loading.
struct SurveyState {
    SurveyPhase phase = SurveyPhase::None;
    bool crossing = false;          ///< True if an agent has to go through a passage that was known before.
    std::vector<SurveyDef> orders;  ///< Surveys to be made; the first one is under way.
    std::vector<Vec2> crowd;        ///< Positions of a sample of people, those of the first order first [m].
    std::vector<Passage> passages;  ///< The passages known before, then those found.
    std::uint32_t known = 0;        ///< Number of `passages` that were known before the present survey.
    std::uint32_t searches = 0;     ///< Number of searches done by the present survey.
    double shortest = 0.0;          ///< Cost of the first route [m]; 0 while none is found.
    double capacity = 0.0;          ///< Capacity of the passages that the present survey found [1/s].
    std::vector<double> openCost;   ///< Costs from the crowd to the goal, in the first search [m].
    std::int64_t cells = 0;         ///< Cells solved in the present search, or of the walks.

    /// The part of the crowd that belongs to the survey under way.
    std::span<const Vec2> presentCrowd() const { return std::span(crowd).first(orders.front().crowd); }

    /// Lets an archive read or write the state.
    template <class Archive>
    void visit(Archive& archive) {
        archive(phase, crossing, orders, crowd, passages, known, searches, shortest, capacity, openCost,
                cells);
    }
};

}  // namespace muster
