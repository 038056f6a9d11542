// Which changes of places are worth making (SPEC A1: a threshold against endless swapping).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "planning/plan.h"

namespace muster {

/// Compares the best flows with those of the incumbents. Where they differ, the difference falls into pieces
/// that touch no common character or place (with units: cycles of exchanges, and chains that begin or end at
/// an unmatched character or an unused place); each piece is taken or left as a whole. Owns its working
/// memory.
class CommitRule {
public:
    /// `cost` is characters x places, row-major, to the power of the objective, finite wherever something
    /// flows. Both lists of flows are ordered by character, then place. Writes the flows to be committed in
    /// the same order.
    void choose(const PlanDef& def, std::int32_t characters, std::int32_t places,
                std::span<const double> cost, std::span<const Flow> incumbent, std::span<const Flow> best,
                std::vector<Flow>& committed);

private:
    struct Piece {
        double moreMatched = 0.0;  // Amount that the best flows send beyond the incumbents.
        double incumbentCost = 0.0;
        double bestCost = 0.0;
        double incumbentDearest = 0.0;
        bool take = false;
    };
    bool worthwhile(const PlanDef& def, const Piece& piece, double dearest) const;
    std::int32_t find(std::int32_t node);
    void join(std::int32_t a, std::int32_t b);
    template <class Visit>
    void merge(std::span<const Flow> incumbent, std::span<const Flow> best, Visit visit) const;

    double dust_ = 0.0;                 // Amounts that do not count.
    std::vector<std::int32_t> parent_;  // Characters, then places.
    std::vector<Piece> pieces_;         // At the root of each.
};

}  // namespace muster
