// The interface of guidance: the direction and the cost of each character's path (SPEC A6).
#pragma once

#include <cstdint>
#include <span>

#include "base/parallel.h"
#include "engine/assignment/planning/plan_costs.h"

namespace muster {

/// Input of the guidance of a step. Spans stay valid during the call only.
struct GuidanceInput {
    std::span<const Vec2> characters;     ///< Positions of the characters [m].
    std::span<const std::int32_t> place;  ///< Place of each character, -1 for unmatched characters.
    std::span<const Vec2> places;         ///< Current positions [m].
    PlanCosts* costs = nullptr;           ///< Costs of the step; not null.
    /// Distance up to which a clear straight line to the place is followed instead of the cost field [m] >=
    /// 0.
    double directReach = 0.0;
};

/// Leads the characters of one group to their places.
class Navigator {
public:
    virtual ~Navigator() = default;

    /// Writes the guidance of each character by the last finished plan: the unit vector of its desired
    /// direction, and the remaining cost [m]; zero and infinite for unmatched characters and where no path is
    /// known. Where the line to the place is clear within GuidanceInput::directReach the cost is the straight
    /// distance. Elsewhere a plan that keeps cost fields leads to the position that the place had at start();
    /// off the field it leads straight to the place if the line is clear, else back to the field.
    virtual void guide(const GuidanceInput& input, ThreadPool& pool, std::span<Vec2> direction,
                       std::span<double> cost) = 0;
    /// The place near which an unmatched character waits, by the last finished plan: the nearest usable place
    /// in the character's region. -1 for none, and for characters that had a place at start().
    virtual std::int32_t waitingPlace(std::int32_t character) const = 0;
    /// Cost from `p` to a place by the last finished plan [m], for pictures; infinite where unknown.
    virtual double costAt(std::int32_t place, Vec2 p) const = 0;
};

}  // namespace muster
