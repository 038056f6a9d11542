// Pairs those who wait with places that are free.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dense/unit_matching.h"
#include "assignment/dynamic/sparse_matching_state.h"

namespace muster {

/// Seats as many of those who wait as there are free places. A few: nearest first. Many: both sets are
/// divided into parts of equal counts, the parts are assigned exactly by the costs between their middles, and
/// within each pair of parts smaller and smaller parts meet. Owns its working memory.
class MatchingStart {
public:
    /// Room for the few.
    MatchingStart();
    /// Reads and shortens the lists made by MatchingSeats::follow.
    void seat(const MatchingContext& context, MatchingState& state);

private:
    struct Choice {
        double cost;
        std::int32_t character;
        std::int32_t seat;
    };

    void keepOpen(const MatchingSeats& seats);
    void few(const MatchingContext& context, MatchingSeats& seats);
    void nearestOfMany(const MatchingContext& context, MatchingSeats& seats);
    void parts(const MatchingContext& context, MatchingSeats& seats);
    void within(const MatchingContext& context, MatchingSeats& seats, std::span<std::int32_t> people,
                std::span<std::int32_t> places, Vec2 shift);
    void exactly(const MatchingContext& context, MatchingSeats& seats, std::span<const std::int32_t> people,
                 std::span<const std::int32_t> places, Vec2 shift);

    std::vector<std::int32_t> people_;
    std::vector<std::int32_t> places_;
    std::vector<Choice> choices_;
    // Parts.
    std::vector<std::int32_t> peopleEnds_;
    std::vector<std::int32_t> placeEnds_;
    std::vector<std::int32_t> placeMiddles_;
    std::vector<Pair> pairs_;
    std::vector<float> answers_;
    std::vector<double> matrix_;
    UnitMatching dense_;
    UnitMatching small_;
};

}  // namespace muster
