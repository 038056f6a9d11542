// A search for the route of a formation: A* (Hart, Nilsson and Raphael 1968) over coarse cells, whose cost
// rises where there is less room than the formation needs; then the route is pulled taut at no higher cost.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/orders/way_ground.h"
#include "engine/orders/way_needs.h"

namespace muster {

/// Status of a search.
enum class WayStatus : std::uint8_t {
    Searching,  ///< The search goes on.
    Found,      ///< There is a route.
    None,       ///< There is no route over the cells.
};

/// One search at a time, which may take several steps. Memory is reused.
class WaySearch {
public:
    /// Begins a search. The ground must stay as it is until the search has ended.
    void start(const WayGround& ground, const WayQuery& query);
    /// Goes on for at most `cells` cells.
    WayStatus advance(const WayGround& ground, std::int32_t cells);

    WayStatus status() const { return status_; }         ///< Status after the last start() or advance().
    const WayQuery& query() const { return query_; }     ///< Query of the last start().
    std::int32_t expanded() const { return expanded_; }  ///< Number of cells expanded since the start.
    /// The route once found, both ends included [m].
    const std::vector<Vec2>& path() const { return path_; }

private:
    struct Open {
        double estimate;
        std::int32_t cell;
        friend bool operator<(const Open& a, const Open& b) {
            return a.estimate != b.estimate ? a.estimate > b.estimate : a.cell > b.cell;
        }
    };

    std::int32_t cellNear(const WayGround& ground, Vec2 p) const;
    void reach(std::int32_t cell, std::int32_t from, double cost, double estimate);
    void markHeld(const WayGround& ground);
    void expand(const WayGround& ground, std::int32_t cell);
    void trace(const WayGround& ground);

    WayQuery query_;
    WayStatus status_ = WayStatus::None;
    std::int32_t expanded_ = 0;
    std::int32_t goal_ = -1;
    std::uint32_t mark_ = 0;           // Mark of the cells of this search.
    std::vector<std::uint32_t> seen_;  // Marks by cell.
    // Per cell: mark_ where an agent that holds its ground may block a step.
    std::vector<std::uint32_t> held_;
    std::vector<double> cost_;  // Costs from the start.
    std::vector<std::int32_t> parent_;
    std::vector<std::uint8_t> closed_;
    std::vector<Open> open_;  // Heap of open cells.
    std::vector<Vec2> path_, scratch_;
    std::vector<double> prefix_;
};

/// Cost of a straight stretch; infinite where bodies do not pass.
double stretchCost(const WayGround& ground, const WayNeeds& needs, Vec2 a, Vec2 b);
/// Leaves out corners, and cuts them, where that costs no more. `scratch` and `prefix` are working memory.
void pullWay(const WayGround& ground, const WayNeeds& needs, std::vector<Vec2>& points,
             std::vector<Vec2>& scratch, std::vector<double>& prefix);

}  // namespace muster
