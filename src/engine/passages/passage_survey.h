// Finds the passages through which a crowd can go, the shortest way first.
#pragma once

#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/passages/survey_state.h"
#include "engine/passages/walk_field.h"

namespace muster {

/// Looks for alternatives: the way is searched again with the passages closed that are known already. It goes
/// on over several steps.
class PassageSurvey {
public:
    /// At most so many passages are known at a time.
    explicit PassageSurvey(std::size_t most) : most_(most) {}

    /// Goes on with the first of `state.orders`, and those after it, for `cells` cells, about, which it takes
    /// off. True when all are done. Appends passages to `state.passages` for as long as another could help:
    /// nothing where the first one lets everybody through within two seconds, none that costs more detour
    /// than all need to go through those that are nearer. Where more than six could help, one passage is all
    /// there is, or many of the crowd need none of them, nothing is appended: then nobody has to choose. The
    /// ground must be the same until all are done.
    bool advance(const Environment& environment, const StaticGround& ground, SurveyState& state,
                 std::int64_t& cells);
    /// The next advance() repeats the present search up to where it was: after loading.
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
    bool begun_ = false;              // The present search is in `solver_`.
    std::vector<double> closedCost_;  // From the crowd, with the passages closed [m].
    WalkEdges edges_;
    WalkSolver solver_;
    WalkField field_;
    std::vector<Vec2> way_;
};

}  // namespace muster
