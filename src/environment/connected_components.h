// Connected-component labelling of the free ground, per radius.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// The regions of the ground that are free for discs of one radius.
struct RegionLabels {
    double radius = -1.0;  ///< [m]
    /// Per cell: -1 where the clearance is below the radius, else the number of its region. Regions are
    /// numbered from 0 in row-major order of their first cells.
    std::vector<std::int32_t> label;
    std::int32_t count = 0;  ///< Number of regions.
};

/// Labels the four-connected regions of cells with enough clearance, so regions joined only at a corner stay
/// apart. The labels of the radii queried last are cached.
class ConnectedComponents {
public:
    /// Drops all cached labels.
    void clear();
    /// The labels for a radius [m]; valid until clear() or until kCachedRadii other radii were queried.
    const RegionLabels& labels(const Grid& grid, std::span<const float> clearance, double radius);
    /// Number of radii whose labels are cached.
    static constexpr std::size_t kCachedRadii = 16;

private:
    struct Entry : RegionLabels {
        bool valid = false;
    };
    void label(const Grid& grid, std::span<const float> clearance, Entry& entry);

    std::mutex mutex_;
    std::atomic<const Entry*> last_{nullptr};  // Queried last; null where the labels were dropped since.
    std::array<Entry, kCachedRadii> entries_;
    std::size_t next_ = 0;  // Index of the entry to overwrite next.
    std::vector<std::int32_t> stack_;
};

}  // namespace muster
