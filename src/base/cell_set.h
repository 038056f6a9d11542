// Sets of grid cells that are cleared at the cost of their members.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace muster {

/// A sparse set (Briggs and Torczon 1993): one flag per cell, and the members in order of insertion.
class CellSet {
public:
    /// Makes it an empty set of cells with indices below `count`. Allocates, so that insert() does not.
    void reset(std::size_t count) {
        flags_.assign(count, 0);
        members_.clear();
        members_.reserve(count);
    }
    /// Removes all members.
    void clear() {
        for (const std::int32_t cell : members_) flags_[cell] = 0;
        members_.clear();
    }
    /// Adds a cell; false where it is a member already.
    bool insert(std::int32_t cell) {
        if (flags_[cell] != 0) return false;
        flags_[cell] = 1;
        members_.push_back(cell);
        return true;
    }
    bool contains(std::int32_t cell) const { return flags_[cell] != 0; }  ///< True for a member.
    bool empty() const { return members_.empty(); }                       ///< True without members.
    std::size_t capacity() const { return flags_.size(); }                ///< The count given to reset().
    std::span<const std::int32_t> members() const { return members_; }    ///< Members in order of insertion.
    /// Per cell: 1 for a member, 0 otherwise.
    const std::vector<std::uint8_t>& flags() const { return flags_; }

private:
    std::vector<std::uint8_t> flags_;
    std::vector<std::int32_t> members_;
};

}  // namespace muster
