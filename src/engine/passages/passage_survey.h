// Finds the passages through which a crowd can go, the shortest route first.
#pragma once

#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/passages/survey_state.h"
#include "engine/passages/walk_field.h"

namespace muster {

/// Looks for alternatives: the route is searched again with the known passages closed. A survey goes on over
/// several steps.
class PassageSurvey {
public:
    /// `most`: the greatest number of passages known at a time.
    explicit PassageSurvey(std::size_t most) : most_(most) {}

    /// Goes on with the first of `state.orders`, and then the others, for about `cells` cells, from which it
    /// subtracts the cells used. True when all are done. Appends passages to `state.passages` for as long as
    /// another could help: none where the first one lets all people through within two seconds, and none with
    /// a greater detour than the nearer passages would cost by waiting. Where more than six could help, where
    /// there is only one passage, or where many of the crowd need none of them, nothing is appended: then
    /// nobody has to choose. The ground must be the same until all are done.
    bool advance(const Environment& environment, const StaticGround& ground, SurveyState& state,
                 std::int64_t& cells);
    /// Makes the next advance() repeat the present search up to where it was: after loading.
    void forget() { begun_ = false; }

private:
    enum class Verdict : std::uint8_t { GoOn, Enough, TooMany };

    void begin(const StaticGround& ground, const SurveyState& state);
    double costliest(const SurveyState& state) const;
    Verdict conclude(const Environment& environment, const StaticGround& ground, SurveyState& state);
    Verdict addGap(const Environment& environment, const StaticGround& ground, SurveyState& state);
    void finishOrder(SurveyState& state, Verdict verdict);
    void readCosts(const SurveyState& state, std::vector<double>& costs) const;
    bool partsCrowd(const SurveyState& state);

    std::size_t most_;
    bool begun_ = false;              // True if the present search is in `solver_`.
    std::vector<double> closedCost_;  // Costs from the crowd, with the passages closed [m].
    WalkEdges edges_;
    WalkSolver solver_;
    WalkField field_;
    std::vector<Vec2> way_;
};

}  // namespace muster
