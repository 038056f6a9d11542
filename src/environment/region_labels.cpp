#include "environment/region_labels.h"

namespace muster {

void RegionLabels::clear() {
    const std::lock_guard lock(mutex_);
    for (Entry& entry : entries_) entry.valid = false;
}

std::span<const std::int32_t> RegionLabels::labels(const Grid& grid, std::span<const float> clearance, double radius) {
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_) {
        if (entry.valid && entry.radius == radius) return entry.label;
    }
    Entry& entry = entries_[next_];
    next_ = (next_ + 1) % kKept;
    entry.radius = radius;
    entry.valid = true;
    flood(grid, clearance, entry);
    return entry.label;
}

void RegionLabels::flood(const Grid& grid, std::span<const float> clearance, Entry& entry) {
    constexpr std::int32_t kBlocked = -1, kUnseen = -2;
    const std::int32_t count = grid.count();
    entry.label.resize(static_cast<std::size_t>(count));
    for (std::int32_t i = 0; i < count; ++i) entry.label[i] = clearance[i] >= entry.radius ? kUnseen : kBlocked;
    std::int32_t label = 0;
    for (std::int32_t first = 0; first < count; ++first) {
        if (entry.label[first] != kUnseen) continue;
        entry.label[first] = label;
        queue_.assign(1, first);
        const auto reach = [&](std::int32_t i) {
            if (entry.label[i] != kUnseen) return;
            entry.label[i] = label;
            queue_.push_back(i);
        };
        while (!queue_.empty()) {
            const std::int32_t i = queue_.back();
            queue_.pop_back();
            const Cell c = grid.at(i);
            if (c.x > 0) reach(i - 1);
            if (c.x + 1 < grid.width) reach(i + 1);
            if (c.y > 0) reach(i - grid.width);
            if (c.y + 1 < grid.height) reach(i + grid.width);
        }
        ++label;
    }
}

}  // namespace muster
