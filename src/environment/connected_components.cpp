#include "environment/connected_components.h"

#include "base/grid_search.h"

namespace muster {

void ConnectedComponents::clear() {
    const std::lock_guard lock(mutex_);
    last_.store(nullptr, std::memory_order_release);
    for (Entry& entry : entries_) entry.valid = false;
}

const RegionLabels& ConnectedComponents::labels(const Grid& grid, std::span<const float> clearance,
                                                double radius) {
    // Most queries repeat the last radius, from many threads at once: they take no lock.
    if (const Entry* last = last_.load(std::memory_order_acquire); last != nullptr && last->radius == radius)
        return *last;
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_) {
        if (!entry.valid || entry.radius != radius) continue;
        last_.store(&entry, std::memory_order_release);
        return entry;
    }
    last_.store(nullptr, std::memory_order_release);
    Entry& entry = entries_[next_];
    next_ = (next_ + 1) % kCachedRadii;
    entry.radius = radius;
    entry.valid = true;
    label(grid, clearance, entry);
    return entry;
}

void ConnectedComponents::label(const Grid& grid, std::span<const float> clearance, Entry& entry) {
    constexpr std::int32_t kBlocked = -1;
    const std::int32_t count = grid.count();
    entry.label.resize(count);
    for (std::int32_t i = 0; i < count; ++i)
        entry.label[i] = clearance[i] >= entry.radius ? kUnlabelled : kBlocked;
    entry.count = labelRegions(grid, entry.label, stack_);
}

}  // namespace muster
