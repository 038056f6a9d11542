// Crossings between neighbouring tiles.
#include <algorithm>

#include "engine/ground/routes/tile_components.h"

namespace muster {
namespace {

constexpr std::int32_t kSpacing = 8;   // Approximate number of cells between the crossings of a long run.
constexpr std::int32_t kShortRun = 3;  // Number of cells up to which a run has one crossing.

// Finds the crossings of one border.
class Border {
public:
    Border(const RouteGround& ground, const BorderTile& tile, const BorderTile& neighbour,
           std::int32_t direction, std::vector<BorderCrossing>& out)
        : ground_(ground),
          tile_(tile),
          neighbour_(neighbour),
          direction_(direction),
          out_(out),
          first_(out.size()) {}

    void run() {
        const std::int32_t length = direction_ == 0 ? tile_.cells.high.y - tile_.cells.low.y + 1
                                                    : tile_.cells.high.x - tile_.cells.low.x + 1;
        if (direction_ >= 2) {
            findAtCorner();
            return;
        }
        std::int32_t start = -1;
        BorderCrossing last;
        for (std::int32_t k = 0; k <= length; ++k) {
            BorderCrossing next;
            const bool passes = k < length && crossing(ownCell(k), otherCell(k), next);
            const bool same = passes && start >= 0 && next.fromComponent == last.fromComponent &&
                              next.toComponent == last.toComponent;
            if (start >= 0 && !same) addRun(start, k - 1, length, last);
            if (!passes) start = -1;
            if (passes && !same) start = k;
            last = next;
        }
        for (std::int32_t k = 0; k < length; ++k)
            for (const std::int32_t aside : {k - 1, k + 1})
                if (aside >= 0 && aside < length) addAlone(ownCell(k), otherCell(aside));
    }

private:
    Cell ownCell(std::int32_t k) const {
        return direction_ == 0 ? Cell{tile_.cells.high.x, tile_.cells.low.y + k}
                               : Cell{tile_.cells.low.x + k, tile_.cells.high.y};
    }
    Cell otherCell(std::int32_t k) const {
        return direction_ == 0 ? Cell{neighbour_.cells.low.x, tile_.cells.low.y + k}
                               : Cell{tile_.cells.low.x + k, neighbour_.cells.low.y};
    }

    bool joined(Cell from, Cell to, BorderCrossing& found) const {
        const std::int32_t a = tile_.components->at(TileGrid::localOf(from));
        const std::int32_t b = neighbour_.components->at(TileGrid::localOf(to));
        found = {from, to, a, b};
        return a >= 0 && b >= 0;
    }
    bool crossing(Cell from, Cell to, BorderCrossing& found) const {
        if (!joined(from, to, found)) return false;
        const std::optional<Vec2> a = ground_.standPoint(from), b = ground_.standPoint(to);
        return a && b && ground_.stepClear(from, *a, to, *b);
    }

    // Adds crossings at the ends of a run that obstacles limit, and between.
    void addRun(std::int32_t start, std::int32_t end, std::int32_t length, const BorderCrossing& pair) {
        const std::int32_t count = end - start + 1;
        const auto add = [&](std::int32_t k) {
            out_.push_back({ownCell(k), otherCell(k), pair.fromComponent, pair.toComponent});
        };
        if (count <= kShortRun) {
            add(start + (count - 1) / 2);
            return;
        }
        if (start > 0) add(start);
        const std::int32_t between = std::max(1, count / kSpacing);
        for (std::int32_t i = 0; i < between; ++i) add(start + (2 * i + 1) * count / (2 * between));
        if (end + 1 < length) add(end);
    }

    void addAlone(Cell from, Cell to) {
        BorderCrossing found;
        if (!joined(from, to, found)) return;
        const bool known = std::any_of(
            out_.begin() + static_cast<std::ptrdiff_t>(first_), out_.end(), [&](const BorderCrossing& c) {
                return c.fromComponent == found.fromComponent && c.toComponent == found.toComponent;
            });
        if (!known && crossing(from, to, found)) out_.push_back(found);
    }

    // Four tiles meet at a corner. The step across it counts where both cells beside it are blocked.
    void findAtCorner() {
        const CellRect& t = tile_.cells;
        const Cell from{direction_ == 2 ? t.high.x : t.low.x, t.high.y};
        const Cell to{from.x + kOffsets[direction_].x, from.y + 1};
        if (ground_.standPoint({from.x, to.y}) || ground_.standPoint({to.x, from.y})) return;
        addAlone(from, to);
    }

    const RouteGround& ground_;
    const BorderTile& tile_;
    const BorderTile& neighbour_;
    std::int32_t direction_;
    std::vector<BorderCrossing>& out_;
    std::size_t first_;  // Index in `out_` of the first crossing of this border.
};

}  // namespace

void findCrossings(const RouteGround& ground, const BorderTile& tile, const BorderTile& neighbour,
                   std::int32_t direction, std::vector<BorderCrossing>& crossings) {
    if (tile.components->count == 0 || neighbour.components->count == 0) return;
    Border(ground, tile, neighbour, direction, crossings).run();
}

}  // namespace muster
