#include "engine/fields/geodesics/shared_far_fields.h"

#include <algorithm>
#include <cmath>

namespace muster {

CellRect farFieldBox(const StaticGround& ground, std::int32_t landmark) {
    const Grid& grid = ground.coarse().grid;
    const Cell middle = grid.at(landmark);
    return CellRect{{middle.x - kFarFieldHalfWidth, middle.y - kFarFieldHalfWidth},
                    {middle.x + kFarFieldHalfWidth, middle.y + kFarFieldHalfWidth}}
        .common({{0, 0}, {grid.width - 1, grid.height - 1}});
}

// A field depends on the ground in its box only, where it has one.
void dropChangedFarFields(const StaticGround& ground, std::uint32_t since, std::vector<CellRect>& changes,
                          FieldCache& cache) {
    changes.clear();
    if (!ground.hasWideCoarse() || !ground.changesSince(since, changes)) return cache.clear();
    const auto ratio = static_cast<std::int32_t>(
        std::floor(ground.coarse().grid.cell / ground.grid().cell + 0.5));
    // An edge reads the ground of its two cells, a partially blocked cell that of its neighbours too.
    for (CellRect& area : changes)
        area = {{area.low.x / ratio - 2, area.low.y / ratio - 2},
                {area.high.x / ratio + 2, area.high.y / ratio + 2}};
    cache.drop([&](std::int32_t landmark) {
        const CellRect box = farFieldBox(ground, landmark);
        return std::any_of(changes.begin(), changes.end(),
                           [&](const CellRect& area) { return !area.common(box).empty(); });
    });
}

void SharedFarFields::update(const StaticGround& ground) {
    if (version_ != ground.version()) dropChangedFarFields(ground, version_, changes_, cache_);
    version_ = ground.version();
}

const CostField* SharedFarFields::find(std::int32_t landmark) const {
    const std::int32_t slot = cache_.find(landmark);
    return slot < 0 ? nullptr : &cache_.field(slot);
}

void SharedFarFields::keep(std::int32_t landmark, const CostField& field, ThreadPool& pool) {
    if (cache_.use(landmark) >= 0) return;
    cache_.request(landmark);
    cache_.solveRequested(1, pool, [&](std::int32_t, CostField& copy, std::int32_t) { copy = field; });
}

}  // namespace muster
