#include "engine/assignment/planning/exact/unit_cost_archive.h"

#include <cmath>
#include <cstring>

namespace muster {
namespace {

constexpr std::int64_t kMaxCells = 16'000'000;  // Greatest number of cells: the limit of Environment.
// Bounds far beyond any real unit cost; damaged values outside could keep fast marching from ending.
constexpr float kMinCost = 1e-6f;
constexpr float kMaxCost = 1e9f;

bool sameBits(const CellCost& a, const CellCost& b) {
    return std::memcmp(&a, &b, sizeof(CellCost)) == 0;
}

bool plausible(const Grid& grid) {
    return grid.width > 0 && grid.height > 0 &&
           static_cast<std::int64_t>(grid.width) * grid.height <= kMaxCells && grid.cell > 1e-4 &&
           grid.cell < 1e4 && isFinite(grid.origin);
}

// Wall nodes must ascend and lie inside the grid, since solvers index cells with them.
bool plausible(const std::vector<WallNode>& nodes, std::int64_t cells) {
    std::int64_t before = -1;
    for (const WallNode& node : nodes) {
        if (node.cell <= before || node.cell >= cells) return false;
        if (!(std::fabs(node.x) <= 1.0f && std::fabs(node.y) <= 1.0f)) return false;
        if (!(std::fabs(node.normalX) <= 1.01f && std::fabs(node.normalY) <= 1.01f &&
              std::isfinite(node.unit)))
            return false;
        before = node.cell;
    }
    return true;
}

bool plausible(float cost) {
    return cost >= kMinCost && (cost <= kMaxCost || std::isinf(cost));
}

}  // namespace

void saveUnitCost(Writer& archive, const UnitCost& cost) {
    std::vector<std::uint32_t> lengths;
    std::vector<float> values;
    for (std::size_t k = 0; k < cost.cells.size(); ++k) {
        const CellCost& c = cost.cells[k];
        if (k > 0 && sameBits(c, cost.cells[k - 1])) {
            ++lengths.back();
            continue;
        }
        lengths.push_back(1);
        values.insert(values.end(), {c.east, c.north, c.west, c.south});
    }
    archive(cost.grid, cost.radius, cost.lowest, cost.nodes, lengths, values);
}

bool loadUnitCost(Reader& archive, UnitCost& cost) {
    std::vector<std::uint32_t> lengths;
    std::vector<float> values;
    archive(cost.grid, cost.radius, cost.lowest, cost.nodes, lengths, values);
    if (!archive.ok() || !plausible(cost.grid) || values.size() != 4 * lengths.size()) return false;
    for (const float value : values)
        if (!plausible(value)) return false;
    const std::int64_t count = cost.grid.count();
    std::int64_t total = 0;
    for (const std::uint32_t length : lengths) total += length;
    if (total != count || !std::isfinite(cost.radius) || !plausible(cost.lowest)) return false;
    if (!plausible(cost.nodes, count)) return false;
    cost.cells.clear();
    cost.cells.reserve(count);
    for (std::size_t run = 0; run < lengths.size(); ++run) {
        const float* v = values.data() + 4 * run;
        cost.cells.insert(cost.cells.end(), lengths[run], CellCost{v[0], v[1], v[2], v[3]});
    }
    return true;
}

}  // namespace muster
