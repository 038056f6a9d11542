// The front of a fast marching solve (Sethian 1996): values of cells, upwind updates, pseudo-sources.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/fields/cost/unit_cost.h"
#include "engine/fields/eikonal/bucket_queue.h"
#include "engine/fields/eikonal/line_of_sight.h"

namespace muster {

/// Error that a value from upwind differences may have against one from a pseudo-source [cells]: where both
/// meet, the former wins only if it is lower by more than this error, and gives way if it is lower by less.
inline constexpr float kDifferenceError = 0.1f;
/// In place of a pseudo-source: the value was given and stays.
inline constexpr std::int32_t kFixedValue = -1;
/// In place of a pseudo-source: the value comes from cheaper ground, so that no straight path over this
/// ground can be better.
inline constexpr std::int32_t kFromCheaperGround = -2;

/// State of one cell of the front. It is one struct, since an update reads nearly all of it.
struct FrontNode {
    float accepted = kUnreachableCost;   ///< The value that neighbours have been updated from.
    float tentative = kUnreachableCost;  ///< The lowest value found so far.
    /// Origin of the value: index of a pseudo-source, > 0; 0 for upwind differences; kFixedValue or
    /// kFromCheaperGround.
    std::int32_t source = 0;
    /// Index of the pseudo-source last found to be occluded from this cell by a wall; 0 for none.
    std::int32_t occluded = 0;
};

/// The front. Values are costs divided by the edge of a cell. Rows are padded by one cell, which ends one
/// row and begins the next, and by two rows below and above, so that no index needs a check.
class Front {
public:
    /// Allocates for a grid; keeps the arrays where its size has not changed.
    void resize(const Grid& grid);
    /// Starts a solve over this unit cost, which has to stay until end().
    void begin(const UnitCost& cost, bool secondOrder);
    /// Makes the pseudo-source of the source itself, at (x, y) [cells], and returns its index.
    std::int32_t addSource(float x, float y, float unit);
    /// Sets the values of all cells visible from the source whose values are at most `limit`, from cell to
    /// cell, without the queue. Returns false, doing nothing, where the ground at `home`, the source's cell,
    /// has not the unit cost of the source.
    bool fillVisible(Cell home, std::int32_t source, float limit);
    /// Gives a cell a value that the march may still lower. `source` is as in FrontNode.
    void seed(Cell cell, float value, std::int32_t source);
    /// Gives a cell a value, and makes it a pseudo-source of that cost: every point that sees it goes
    /// straight to it.
    void seedSource(Cell cell, float value);
    /// The obstruction between a cell and a pseudo-source; `value` becomes the cost of the straight path
    /// where that is clear.
    Visibility visibility(Cell cell, std::int32_t source, float& value) const;
    /// Empties one bucket of the queue; false where nothing is left. level() is its lowest value then.
    bool step();
    /// Level below which all values are final.
    float level() const { return static_cast<float>(queue_.current() - 1) * bucketWidth_; }
    /// Value at the centre of a cell with a wall node, whose own value is that of the wall node.
    float centreValue(const WallNode& wallNode) const;
    /// Accepted value of a padded index; infinite where not reached.
    float value(std::int32_t node) const { return nodes_[node].accepted; }
    /// First row in which a cell may have been reached.
    std::int32_t firstRow() const { return lastNode_ < 0 ? 0 : firstNode_ / stride_ - 2; }
    /// Last such row; below the first where there is none.
    std::int32_t lastRow() const { return lastNode_ < 0 ? -1 : lastNode_ / stride_ - 2; }
    /// The cells of a row, from column 0 on.
    const FrontNode* row(std::int32_t y) const { return nodes_.data() + node(0, y); }
    /// All pseudo-sources by index; index 0 is none.
    const std::vector<PseudoSource>& pseudoSources() const { return sources_; }
    /// The padded index of a cell.
    std::int32_t node(std::int32_t x, std::int32_t y) const { return (y + 2) * stride_ + x + 1; }
    /// Both indices of a cell.
    FrontCell at(Cell c) const { return {grid_.index(c), node(c.x, c.y)}; }
    /// Ends the solve and resets the written cells. Accepted values lie between `low` and `high` only.
    void end(Cell low, Cell high);

private:
    enum class Side { East, North, West, South };

    // The cheapest corners to go round an occluder by, in ascending order of cost.
    struct Corners {
        static constexpr int kMax = 3;
        float cost[kMax];         // Cost of the path over the corner.
        std::int32_t cell[kMax];  // Cell of the corner's wall node.
        int count = 0;

        void insert(float pathCost, std::int32_t atCell);
    };

    // A row of fillVisible(), in columns from the source's.
    struct RowSpan {
        std::int32_t width;    // Number of columns up to the edge of the grid.
        std::int32_t visible;  // Last visible column of the row before.
    };

    template <Side kSide>
    static float towards(const CellCost& c);
    template <Side kSide>
    void relax(FrontCell from, const FrontNode* here, const CellCost* fromCost);
    void relaxNeighbours(FrontCell from, const FrontNode* here);
    bool relaxFromSource(FrontCell from, FrontCell to, float old);
    Visibility findVisibility(FrontCell to, float x, float y, std::int32_t source);
    Visibility traceAndNote(FrontCell to, float x, float y, std::int32_t source);
    bool seesSource(std::int32_t node, std::int32_t source, bool far) const;
    bool isCorner(std::int32_t cell) const;
    Corners bestCorners(std::int32_t occluder, const PseudoSource& target, float limit) const;
    bool relaxRoundOccluder(std::int32_t occluder, FrontCell to, float x, float y, float unit, float old);
    void relaxFromWall(FrontCell from, FrontCell to, float old);
    void relaxDiagonals(FrontCell from);
    std::int32_t pseudoSourceAt(FrontCell wallCell);
    void position(FrontCell cell, float& x, float& y) const;
    void fillAxis(Cell home, std::int32_t right, std::int32_t up, std::int32_t source);
    void fillQuadrant(Cell home, std::int32_t right, std::int32_t up, std::int32_t source);
    std::int32_t fillRow(Cell axis, Cell side, RowSpan span, std::int32_t source);
    bool fillCell(FrontCell cell, bool certain, std::int32_t source);
    void queueBorder(std::int32_t source);
    void noteWritten(Cell low, Cell high) {
        writtenLow_ = {std::min(writtenLow_.x, low.x), std::min(writtenLow_.y, low.y)};
        writtenHigh_ = {std::max(writtenHigh_.x, high.x), std::max(writtenHigh_.y, high.y)};
    }
    void noteReached(std::int32_t node) {
        if (node < firstNode_) firstNode_ = node;
        if (node > lastNode_) lastNode_ = node;
    }
    void put(FrontCell to, float old, float value, std::int32_t source) {
        FrontNode& at = nodes_[to.node];
        at.tentative = value;
        at.source = source;
        const std::int32_t bucket = queue_.number(value);
        // A cell that waits in the same bucket need not be put there twice.
        if (at.accepted != old && queue_.number(old) == bucket) return;
        queue_.push(bucket, to);
    }

    Grid grid_;
    std::int32_t stride_ = 0;  // Step from row to row of nodes_.
    const CellCost* cells_ = nullptr;
    float maxStepDifference_ = 0.0f;  // See kMaxStepDifference.
    float bucketWidth_ = 1.0f;        // Range of values in one bucket.
    float tolerance_ = 0.0f;          // Improvement below which a visit is not worth it.
    std::vector<FrontNode> nodes_;    // Nodes of all cells, padded.
    BucketQueue queue_;
    LineOfSight lineOfSight_;
    std::vector<PseudoSource> sources_;
    std::vector<std::int32_t> wallSource_;  // Per wall node, by its number: its pseudo-source, 0 for none.
    // Per node: the cell that occludes FrontNode::occluded; -1 once paths round it have been tried.
    std::vector<std::int32_t> occluderOf_;
    std::int32_t occluder_ = -1;  // The occluder found by the last findVisibility(); -1 for none.
    // The first and the last node reached: reading the result need not visit the whole grid.
    std::int32_t firstNode_ = 0;
    std::int32_t lastNode_ = -1;
    // Bounding rectangle of the cells that fillVisible() reached, and its limit.
    Cell visibleLow_;
    Cell visibleHigh_;
    float visibleLimit_ = 0.0f;
    // Bounding rectangle of seeded and visible cells, which may lie apart from those reached.
    Cell writtenLow_;
    Cell writtenHigh_;
};

// The point that the value of a cell belongs to, from the centre of cell (0, 0) [cells].
inline void Front::position(FrontCell cell, float& x, float& y) const {
    const std::int32_t row = cell.node - cell.cell - (2 * stride_ + 1);
    x = static_cast<float>(cell.cell - row * grid_.width);
    y = static_cast<float>(row);
    if (const std::int32_t number = lineOfSight_.wall(cell.cell); number != 0) {
        x += lineOfSight_.node(number).x;
        y += lineOfSight_.node(number).y;
    }
}

}  // namespace muster
