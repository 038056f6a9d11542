// Gaps of the ground that are too narrow for characters of one radius, found by position.
#pragma once

#include <vector>

#include "engine/ground/environment/box_grid.h"
#include "engine/ground/environment/environment.h"

namespace muster {

/// All closed gaps between static obstacles. A raster of clearances at cell centres does not show them: one
/// may lie between two free centres. Paths are kept out of them by their segments.
class GapIndex {
public:
    /// Empties it, for gaps narrower than `width` [m]; update() of the whole world must follow.
    void reset(const Environment& environment, double width);
    /// Finds the gaps in the changed cells of `area` again.
    void update(const Environment& environment, const CellRect& area);
    /// True without any gap.
    bool empty() const { return gaps_.empty(); }
    /// True where the segment from `a` to `b` crosses a gap that is at most kReach from `near`, a point of
    /// the world.
    bool crossed(Vec2 a, Vec2 b, Vec2 near) const {
        for (const std::int32_t gap : grid_.at(near))
            if (crosses(gaps_[gap], a, b)) return true;
        return false;
    }
    /// Appends the gaps whose bounding boxes meet `box`, in a fixed order.
    void within(const Box& box, std::vector<ClosedGap>& gaps) const;

    static constexpr double kReach = 1.0;  ///< Greatest distance of a gap from the point of a query [m].

private:
    double width_ = 0.0;           // Width below which a gap is closed [m].
    std::vector<ClosedGap> gaps_;  // Gaps, sorted so that their history does not show.
    std::vector<Box> boxes_;       // Bounding boxes of the gaps, grown by kReach [m].
    std::vector<std::int32_t> numbers_;
    BoxGrid grid_;
};

}  // namespace muster
