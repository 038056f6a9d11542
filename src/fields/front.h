// The marching front: padded arrays and the upwind update.
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "fields/bucket_queue.h"
#include "muster/fields/unit_cost.h"

namespace muster {

inline constexpr float kInfiniteCost = std::numeric_limits<float>::infinity();

/// Values of a march in units of cost per metre times the cell's edge. Rows are padded by one cell that ends one
/// row and begins the next, and by two rows below and above, so that no index needs a check.
class Front {
public:
    /// Makes ready for a grid; keeps the arrays where its size has not changed.
    void fit(const Grid& grid);
    /// Starts a march over these costs.
    void begin(const UnitCost& cost, bool secondOrder);
    /// Gives a cell a value that the march may still lower.
    void seed(FrontCell cell, float value);
    /// Gives a cell a final value, which the march will not lower.
    void fix(FrontCell cell, float value) {
        accepted_[cell.node] = value;
        tentative_[cell.node] = -kInfiniteCost;
    }
    /// Offers the value of a fixed cell to its neighbours.
    void offer(FrontCell cell);
    /// Empties one bucket of the queue; false where nothing is left. Its lowest value is then in level().
    bool step();
    /// All values below it are final.
    float level() const { return static_cast<float>(queue_.current() - 1) * width_; }
    /// Value of a node, infinite where not reached.
    float value(std::int32_t node) const { return accepted_[node]; }
    /// Values of a row, from column 0 on.
    const float* row(std::int32_t y) const { return accepted_.data() + node(0, y); }
    /// The padded index of a cell.
    std::int32_t node(std::int32_t x, std::int32_t y) const { return (y + 2) * stride_ + x + 1; }
    /// Both indices of a cell.
    FrontCell at(Cell c) const { return {grid_.index(c), node(c.x, c.y)}; }
    /// Forgets the values of these rows and columns and one cell around them.
    void forget(Cell low, Cell high);

private:
    enum class Side { East, North, West, South };

    template <Side kSide>
    static float towards(const CellCost& c);
    template <Side kSide>
    void relax(FrontCell from, float value, const CellCost& fromCost);
    void spread(FrontCell from, float value);

    Grid grid_;
    std::int32_t stride_ = 0;
    const CellCost* cells_ = nullptr;
    bool secondOrder_ = true;
    float width_ = 1.0f;      // Of a bucket.
    float tolerance_ = 0.0f;  // Smaller gains are not worth a visit.
    std::vector<float> accepted_;
    std::vector<float> tentative_;
    BucketQueue queue_;
};

}  // namespace muster
