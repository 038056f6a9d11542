// Pairs those who wait with places that are free.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dense/jonker_volgenant.h"
#include "assignment/dynamic/exchange_graph.h"

namespace muster {

/// Seats as many of those who wait as there are free places. A few: nearest first. Many: both sets are
/// divided into parts of equal counts, the parts are assigned exactly by the costs between their middles, and
/// within each pair of parts smaller and smaller parts meet. Owns its working memory.
class InitialAssignment {
public:
    /// Room for the few.
    InitialAssignment();
    /// Reads and shortens the lists made by AssignmentNodes::follow.
    void seat(const AssignmentStep& context, ExchangeGraph& state);

private:
    struct Choice {
        double cost;
        std::int32_t character;
        std::int32_t seat;
    };

    void keepOpen(const AssignmentNodes& seats);
    void few(const AssignmentStep& context, AssignmentNodes& seats);
    void nearestOfMany(const AssignmentStep& context, AssignmentNodes& seats);
    void parts(const AssignmentStep& context, AssignmentNodes& seats);
    void within(const AssignmentStep& context, AssignmentNodes& seats, std::span<std::int32_t> people,
                std::span<std::int32_t> places, Vec2 shift);
    void exactly(const AssignmentStep& context, AssignmentNodes& seats, std::span<const std::int32_t> people,
                 std::span<const std::int32_t> places, Vec2 shift);

    std::vector<std::int32_t> people_;
    std::vector<std::int32_t> places_;
    std::vector<Choice> choices_;
    // Parts.
    std::vector<std::int32_t> peopleEnds_;
    std::vector<std::int32_t> placeEnds_;
    std::vector<std::int32_t> placeMiddles_;
    std::vector<AssignmentPair> pairs_;
    std::vector<float> answers_;
    std::vector<double> matrix_;
    JonkerVolgenantSolver dense_;
    JonkerVolgenantSolver small_;
};

}  // namespace muster
