// Finds exchanges that the sparse graph has no arc for.
#pragma once

#include <cstdint>
#include <vector>

#include "assignment/dynamic/exchange_graph.h"

namespace muster {

/// Column generation: each step a few seats, in turn, are held against all others: their holders against all
/// places, their places against all characters. The straight line bounds a cost from below; where even that
/// could be violated the cost is asked for, and the most violated arc takes the row's priced lane. So prices
/// hold for the complete graph in the end, not only for its sixteen arcs. Owns its working memory.
class ColumnGeneration {
public:
    /// Makes room and begins anew.
    void reset(std::int32_t seats);
    /// Prices some seats; arcs violated by more than `tolerance` are taken in.
    void run(const AssignmentStep& context, ExchangeGraph& state, double tolerance);
    std::int32_t found() const { return found_; }  ///< Arcs taken in by the last run.
    /// Makes room for what was read.
    void afterReading(std::int32_t seats) { makeRoom(seats); }

    /// Lets an archive read or write whose turn it is.
    template <class Archive>
    void visit(Archive& archive) {
        archive(all_, hot_);
        if constexpr (Archive::kReading)
            if (all_.next < 0 || hot_.next < 0) archive.fail();
    }

private:
    /// Seats take turns; each time round other pairs of theirs are looked at.
    struct Turns {
        std::int32_t next = 0;
        std::uint32_t round = 0;

        template <class Archive>
        void visit(Archive& archive) {
            archive(next, round);
        }
    };
    void makeRoom(std::int32_t seats);
    void noteEnds(const AssignmentStep& context, const ExchangeGraph& state);
    void price(const AssignmentStep& context, ExchangeGraph& state, std::int32_t seat, std::uint32_t round,
               double tolerance);
    void collectFrom(const AssignmentStep& context, const ExchangeGraph& state, std::int32_t seat,
                     double tolerance);
    void collectInto(const AssignmentStep& context, const ExchangeGraph& state, std::int32_t seat,
                     double tolerance);
    void consider(const AssignmentStep& context, const ExchangeGraph& state, std::int32_t from,
                  std::int32_t to, double rest);
    void ask(const AssignmentStep& context, ExchangeGraph& state, std::uint32_t round, double tolerance);

    Turns all_;
    Turns hot_;  // Of seats far dearer than the mean.
    std::int32_t found_ = 0;
    double perMetre_ = 0.0;  // Of this run.
    // Just below the least cost of a way of one metre, squared, where costs are; else 0.
    double squareOver_ = 0.0;
    std::vector<double> leaving_;  // Per seat, in this run.
    std::vector<double> arriving_;
    std::vector<AssignmentPair> candidates_;
    std::vector<AssignmentPair> pairs_;
    std::vector<float> answers_;
};

}  // namespace muster
