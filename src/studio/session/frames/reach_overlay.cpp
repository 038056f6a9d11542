#include "studio/session/frames/overlay.h"

#include <algorithm>
#include <vector>

#include "base/grid.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"

namespace muster {
namespace {

constexpr std::uint8_t kReached = 0;
constexpr std::uint8_t kFree = 1;
constexpr std::uint8_t kBarred = 2;

/// Ground cells that a character's centre can be in.
class Reach {
public:
    Reach(const Environment& environment, double radius) : grid_(environment.grid()) {
        const auto clearance = environment.staticClearance();
        cells_.resize(clearance.size());
        for (std::size_t i = 0; i < cells_.size(); ++i) cells_[i] = clearance[i] >= radius ? kFree : kBarred;
    }

    /// Marks all that is connected with a cell, and counts it.
    std::size_t flood(std::int32_t from) {
        if (cells_[static_cast<std::size_t>(from)] != kFree) return 0;
        std::size_t count = 0;
        front_.assign(1, from);
        cells_[static_cast<std::size_t>(from)] = kReached;
        while (!front_.empty()) {
            const Cell at = grid_.at(front_.back());
            front_.pop_back();
            ++count;
            take({at.x + 1, at.y});
            take({at.x - 1, at.y});
            take({at.x, at.y + 1});
            take({at.x, at.y - 1});
        }
        return count;
    }

    /// Marks the largest connected ground alone.
    void floodLargest() {
        std::size_t most = 0;
        std::int32_t best = -1;
        for (std::int32_t i = 0; i < grid_.count(); ++i) {
            const std::size_t size = flood(i);
            if (size > most) most = size, best = i;
        }
        for (std::uint8_t& cell : cells_) cell = cell == kReached ? kFree : cell;
        if (best >= 0) (void)flood(best);
    }

    std::uint8_t operator[](std::int32_t cell) const { return cells_[static_cast<std::size_t>(cell)]; }

private:
    void take(Cell cell) {
        if (!grid_.contains(cell)) return;
        const std::int32_t index = grid_.index(cell);
        if (cells_[static_cast<std::size_t>(index)] != kFree) return;
        cells_[static_cast<std::size_t>(index)] = kReached;
        front_.push_back(index);
    }

    const Grid& grid_;
    std::vector<std::uint8_t> cells_;
    std::vector<std::int32_t> front_;
};

/// The value of a cell of the overlay: what most open part of it can be reached.
std::uint8_t coarse(const Reach& reach, const Grid& ground, const Grid& shown, Cell cell) {
    const auto step = static_cast<std::int32_t>(shown.cell / ground.cell + 0.5);
    const Cell corner = ground.nearestCell({shown.origin.x + cell.x * shown.cell + 0.5 * ground.cell,
                                            shown.origin.y + cell.y * shown.cell + 0.5 * ground.cell});
    std::uint8_t value = kBarred;
    for (std::int32_t y = corner.y; y < corner.y + step; ++y)
        for (std::int32_t x = corner.x; x < corner.x + step; ++x)
            if (ground.contains({x, y})) value = std::min(value, reach[ground.index({x, y})]);
    return value;
}

}  // namespace

ReachVersion reachVersion(const World& world) {
    const Environment& environment = inspect::environment(world);
    return {environment.staticVersion() ^ (environment.instance() << 32), world.groupCount() + 1};
}

protocol::Overlay buildReachOverlay(const World& world) {
    const Environment& environment = inspect::environment(world);
    const Grid& ground = environment.grid();
    const double radius = world.parameters().character.radius;
    Reach reach(environment, radius);
    for (const Vec2 p : world.characters().position) (void)reach.flood(ground.index(ground.nearestCell(p)));
    if (world.characters().size() == 0) reach.floodLargest();
    protocol::Overlay overlay;
    overlay.kind = protocol::OverlayKind::Reach;
    const Grid shown = putOverlayGrid(overlay, ground, ground.box());
    for (std::int32_t i = 0; i < shown.count(); ++i)
        overlay.values.push_back(coarse(reach, ground, shown, shown.at(i)));
    for (const NarrowGap& gap : environment.narrowGaps(2.0 * radius)) {
        overlay.gaps.push_back(static_cast<float>(gap.where.x));
        overlay.gaps.push_back(static_cast<float>(gap.where.y));
        overlay.gaps.push_back(static_cast<float>(gap.width));
    }
    return overlay;
}

}  // namespace muster
