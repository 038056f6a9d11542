// Finds exchanges that the sparse graph has no arc for.
#pragma once

#include <cstdint>
#include <vector>

#include "transport/sparse_matching_state.h"

namespace muster {

/// Column generation: each step a few seats, in turn, are held against all places. The straight line bounds a cost from
/// below; where even that could be violated the cost is asked for, and the most violated arc takes the row's priced lane.
/// So prices hold for the complete graph in the end, not only for its sixteen arcs. Owns its working memory.
class MatchingPricing {
public:
    /// Makes room and begins anew.
    void reset(std::int32_t seats);
    /// Prices some seats; arcs violated by more than `tolerance` are taken in.
    void run(const MatchingContext& context, MatchingState& state, double tolerance);
    std::int32_t found() const { return found_; }  ///< Arcs taken in by the last run.
    /// Makes room for what was read.
    void afterReading(std::int32_t seats) { makeRoom(seats); }

    /// Lets an archive read or write whose turn it is.
    template <class Archive>
    void visit(Archive& archive) {
        archive(turn_, hotTurn_, round_);
        if constexpr (Archive::kReading)
            if (turn_ < 0 || hotTurn_ < 0) archive.fail();
    }

private:
    void makeRoom(std::int32_t seats);
    void collect(const MatchingContext& context, const MatchingState& state, std::int32_t seat, double tolerance);
    void price(const MatchingContext& context, MatchingState& state, std::int32_t seat, double tolerance);

    std::int32_t turn_ = 0;     // The seat that is next...
    std::int32_t hotTurn_ = 0;  // ... of those far dearer than the mean.
    std::uint32_t round_ = 0;
    std::int32_t found_ = 0;
    std::vector<std::int32_t> candidates_;
    std::vector<Pair> pairs_;
    std::vector<float> answers_;
};

}  // namespace muster
