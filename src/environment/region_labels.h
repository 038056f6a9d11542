// Connected free regions of the ground, per radius.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// The regions for one radius.
struct Regions {
    double radius = -1.0;  ///< [m]
    /// Per cell: -1 where clearance is under the radius, else numbered from 0 in row-major order of first
    /// cells.
    std::vector<std::int32_t> label;
    std::int32_t count = 0;  ///< How many there are.
};

/// Floods the cells with enough clearance and keeps the labels of the radii asked for last.
/// Steps of the flood go to the four neighbours, so regions joined only at a corner stay apart.
class RegionLabels {
public:
    /// Forgets all labels.
    void clear();
    /// Valid until clear() or kKept other radii were asked for.
    const Regions& regions(const Grid& grid, std::span<const float> clearance, double radius);
    /// How many radii are remembered.
    static constexpr std::size_t kKept = 16;

private:
    struct Entry : Regions {
        bool valid = false;
    };
    void flood(const Grid& grid, std::span<const float> clearance, Entry& entry);

    std::mutex mutex_;
    std::atomic<const Entry*> last_{nullptr};  // Asked for last; null where labels were forgotten since.
    std::array<Entry, kKept> entries_;
    std::size_t next_ = 0;
    std::vector<std::int32_t> queue_;
};

}  // namespace muster
