// The marching front: padded arrays and the upwind update.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "cost/unit_cost.h"
#include "eikonal/bucket_queue.h"
#include "eikonal/line_of_sight.h"

namespace muster {

inline constexpr float kInfiniteCost = std::numeric_limits<float>::infinity();
/// Straight-line values are better than differences: where both meet, a value from differences wins only
/// where it is lower by more than this [cells], and gives way to a straight one that is higher by less.
inline constexpr float kDoubt = 0.1f;
/// In place of a root: the value is given and the march leaves it as it is.
inline constexpr std::int32_t kGiven = -1;
/// In place of a root: the value comes from cheaper ground, so that no straight way along this ground can be
/// better.
inline constexpr std::int32_t kCheaper = -2;

/// What a march knows of a cell. It is kept in one place, as a step of the march needs nearly all of it at
/// once.
struct FrontNode {
    float accepted = kInfiniteCost;   ///< Value that neighbours have been told of.
    float tentative = kInfiniteCost;  ///< Lowest value found so far.
    /// What the value comes from: number of a root above 0, 0 for none, kGiven or kCheaper.
    std::int32_t root = 0;
    std::int32_t hidden = 0;  ///< The root last found hidden from here by a wall; 0 for none.
};

/// Values of a march in units of cost per metre times the cell's edge. Rows are padded by one cell that ends
/// one row and begins the next, and by two rows below and above, so that no index needs a check.
class Front {
public:
    /// Makes ready for a grid; keeps the arrays where its size has not changed.
    void fit(const Grid& grid);
    /// Starts a march over these costs.
    void begin(const UnitCost& cost, bool secondOrder);
    /// Makes a root at the source, of cost 0; cells seeded with its number get straight-line costs.
    std::int32_t addSource(float x, float y, float unit);
    /// Gives the cells that the source's root sees within `limit` [cost of cells] their values at once, from
    /// cell to cell, and leaves to the march what lies behind them. False, doing nothing, where the ground at
    /// `home` is not the root's.
    bool flood(Cell home, std::int32_t root, float limit);
    /// Gives a cell a value that the march may still lower; `root` 0 where it comes from no root, kGiven
    /// where it may not.
    void seed(Cell cell, float value, std::int32_t root);
    /// What lies between a cell and the source's root; `value` is the cost of the straight way where it is
    /// clear.
    Ray seen(Cell cell, std::int32_t root, float& value) const;
    /// Empties one bucket of the queue; false where nothing is left. Its lowest value is then in level().
    bool step();
    /// All values below it are final.
    float level() const { return static_cast<float>(queue_.current() - 1) * width_; }
    /// Value at the centre of a cell beside a wall, whose own value is that of its point at the wall.
    float centreValue(const WallNode& beside) const;
    /// Value of a node, infinite where not reached.
    float value(std::int32_t node) const { return nodes_[node].accepted; }
    /// First and last row in which a cell may have been reached; the last lies below the first where there is
    /// none.
    std::int32_t firstRow() const { return lastNode_ < 0 ? 0 : firstNode_ / stride_ - 2; }
    std::int32_t lastRow() const { return lastNode_ < 0 ? -1 : lastNode_ / stride_ - 2; }
    /// The cells of a row, from column 0 on.
    const FrontNode* row(std::int32_t y) const { return nodes_.data() + node(0, y); }
    /// All roots by number; number 0 is none.
    const std::vector<PseudoSource>& roots() const { return roots_; }
    /// The padded index of a cell.
    std::int32_t node(std::int32_t x, std::int32_t y) const { return (y + 2) * stride_ + x + 1; }
    /// Both indices of a cell.
    FrontCell at(Cell c) const { return {grid_.index(c), node(c.x, c.y)}; }
    /// Ends the march: forgets what it wrote. Values stand in these rows and columns only.
    void end(Cell low, Cell high);

private:
    enum class Side { East, North, West, South };

    // The cheapest ways bent at wall cells.
    struct Bends {
        static constexpr int kMost = 3;
        float value[kMost];
        std::int32_t cell[kMost];
        int count = 0;

        void take(float cost, std::int32_t at);
    };

    // Of a row of the flood, in columns from the root's: as far as the ground goes, and as the row before was
    // seen.
    struct FloodSpan {
        std::int32_t width;
        std::int32_t reached;
    };

    template <Side kSide>
    static float towards(const CellCost& c);
    template <Side kSide>
    void relax(FrontCell from, const FrontNode* here, const CellCost* fromCost);
    void spread(FrontCell from, const FrontNode* here);
    bool relaxStraight(FrontCell from, FrontCell to, float old);
    Ray sees(FrontCell to, float x, float y, std::int32_t number);
    Ray look(FrontCell to, float x, float y, std::int32_t number);
    bool shows(std::int32_t node, std::int32_t number, bool far) const;
    bool bends(std::int32_t cell) const;
    Bends bestBends(std::int32_t hiding, const PseudoSource& target, float limit) const;
    bool bendAt(std::int32_t hiding, FrontCell to, float x, float y, float unit, float old);
    void bend(FrontCell from, FrontCell to, float old);
    void bendRound(FrontCell from);
    std::int32_t rootAt(FrontCell wallCell);
    void place(FrontCell cell, float& x, float& y) const;
    void floodAxis(Cell home, std::int32_t right, std::int32_t up, std::int32_t root);
    void floodQuadrant(Cell home, std::int32_t right, std::int32_t up, std::int32_t root);
    std::int32_t floodRow(Cell axis, Cell side, FloodSpan span, std::int32_t root);
    bool floodCell(FrontCell cell, bool certain, std::int32_t root);
    void queueRim(std::int32_t root);
    void noteWritten(Cell low, Cell high) {
        writtenLow_ = {std::min(writtenLow_.x, low.x), std::min(writtenLow_.y, low.y)};
        writtenHigh_ = {std::max(writtenHigh_.x, high.x), std::max(writtenHigh_.y, high.y)};
    }
    void noteReached(std::int32_t node) {
        if (node < firstNode_) firstNode_ = node;
        if (node > lastNode_) lastNode_ = node;
    }
    void put(FrontCell to, float old, float value, std::int32_t root) {
        FrontNode& at = nodes_[to.node];
        at.tentative = value;
        at.root = root;
        const std::int32_t bucket = queue_.number(value);
        // A cell that waits in the same bucket need not be put there twice.
        if (at.accepted != old && queue_.number(old) == bucket) return;
        queue_.push(bucket, to);
    }

    Grid grid_;
    std::int32_t stride_ = 0;
    const CellCost* cells_ = nullptr;
    float even_ = 0.0f;       // Costs of two steps that differ by a smaller share are even.
    float width_ = 1.0f;      // Of a bucket.
    float tolerance_ = 0.0f;  // Smaller gains are not worth a visit.
    std::vector<FrontNode> nodes_;
    BucketQueue queue_;
    // Straight ways, and the root that stands at each wall node.
    LineOfSight sight_;
    std::vector<PseudoSource> roots_;
    // The cell that hid a node's hidden root; -1 where ways bent there were offered.
    std::vector<std::int32_t> hidingCell_;
    std::int32_t hiding_ = -1;  // The same of the root asked for last.
    std::vector<std::int32_t> wallRoot_;
    // The lowest and the highest node reached, so that reading the result need not visit the whole ground.
    std::int32_t firstNode_ = 0;
    std::int32_t lastNode_ = -1;
    Cell floodLow_;
    Cell floodHigh_;
    float floodLimit_ = 0.0f;
    // Seeded and flooded cells, which may lie apart from those reached.
    Cell writtenLow_;
    Cell writtenHigh_;
};

// Where the value of a cell belongs, from the centre of cell (0, 0) [cells].
inline void Front::place(FrontCell cell, float& x, float& y) const {
    const std::int32_t row = cell.node - cell.cell - (2 * stride_ + 1);
    x = static_cast<float>(cell.cell - row * grid_.width);
    y = static_cast<float>(row);
    if (const std::int32_t number = sight_.wall(cell.cell); number != 0) {
        x += sight_.node(number).x;
        y += sight_.node(number).y;
    }
}

}  // namespace muster
