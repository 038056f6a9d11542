// Far fields that several groups ask for.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/fields/geodesics/field_cache.h"

namespace muster {

/// Distance from a landmark to the edge of its far field, where that does not cover all ground [coarse
/// cells].
inline constexpr std::int32_t kFarFieldHalfWidth = 64;

/// The cells of the coarse ground that the far field of a landmark covers, where it does not cover all.
CellRect farFieldBox(const StaticGround& ground, std::int32_t landmark);
/// Drops the far fields from a cache that changes of the ground since a version have made wrong. `changes` is
/// working memory.
void dropChangedFarFields(const StaticGround& ground, std::uint32_t since, std::vector<CellRect>& changes,
                          FieldCache& cache);

/// Copies of the far fields of one ground that were solved lately for any group. Groups still count the
/// fields that they take from here as solved. A cache.
class SharedFarFields {
public:
    /// Begins a step of the world.
    void beginStep() { cache_.beginStep(); }
    /// Takes over the ground: always the same one.
    void update(const StaticGround& ground);
    /// The field of a landmark, null for none. Several threads may ask at once.
    const CostField* find(std::int32_t landmark) const;
    /// Keeps a copy of the field of a landmark, or notes that it was used.
    void keep(std::int32_t landmark, const CostField& field, ThreadPool& pool);

private:
    static constexpr std::int32_t kCapacity = 384;

    FieldCache cache_{kCapacity};
    std::uint32_t version_ = 0;  // Version of the ground.
    std::vector<CellRect> changes_;
};

}  // namespace muster
