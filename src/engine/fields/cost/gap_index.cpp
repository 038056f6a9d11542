#include "engine/fields/cost/gap_index.h"

#include <algorithm>
#include <array>

namespace muster {
namespace {

std::array<double, 4> keyOf(const ClosedGap& gap) {
    return {gap.a.x, gap.a.y, gap.b.x, gap.b.y};
}

Box boundsOf(const ClosedGap& gap) {
    return {{std::min(gap.a.x, gap.b.x), std::min(gap.a.y, gap.b.y)},
            {std::max(gap.a.x, gap.b.x), std::max(gap.a.y, gap.b.y)}};
}

Vec2 middleOf(const ClosedGap& gap) {
    return 0.5 * (gap.a + gap.b);
}

}  // namespace

void GapIndex::reset(const Environment& environment, double width) {
    width_ = width;
    gaps_.clear();
    grid_.reset(environment.def().box);
}

// A gap belongs to the cell that holds its middle.
void GapIndex::update(const Environment& environment, const CellRect& area) {
    if (area.empty()) return;
    const Grid& grid = environment.grid();
    const Box box{grid.origin + Vec2{area.low.x * grid.cell, area.low.y * grid.cell},
                  grid.origin + Vec2{(area.high.x + 1) * grid.cell, (area.high.y + 1) * grid.cell}};
    std::erase_if(gaps_, [&](const ClosedGap& gap) { return box.contains(middleOf(gap)); });
    const auto kept = gaps_.size();
    environment.closedGaps(box, width_, gaps_);
    gaps_.erase(std::remove_if(gaps_.begin() + static_cast<std::ptrdiff_t>(kept), gaps_.end(),
                               [&](const ClosedGap& gap) { return !box.contains(middleOf(gap)); }),
                gaps_.end());
    std::sort(gaps_.begin(), gaps_.end(),
              [](const ClosedGap& a, const ClosedGap& b) { return keyOf(a) < keyOf(b); });
    boxes_.clear();
    numbers_.clear();
    for (const ClosedGap& gap : gaps_) {
        numbers_.push_back(static_cast<std::int32_t>(numbers_.size()));
        boxes_.push_back(boundsOf(gap).grown(kReach));
    }
    grid_.fill(boxes_, numbers_);
}

void GapIndex::within(const Box& box, std::vector<ClosedGap>& gaps) const {
    for (const ClosedGap& gap : gaps_) {
        const Box bounds = boundsOf(gap);
        if (bounds.max.x >= box.min.x && bounds.min.x <= box.max.x && bounds.max.y >= box.min.y &&
            bounds.min.y <= box.max.y)
            gaps.push_back(gap);
    }
}

}  // namespace muster
