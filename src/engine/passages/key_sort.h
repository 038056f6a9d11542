// Sorting of many numbers by digits.
#pragma once

#include <cstdint>
#include <vector>

namespace muster {

/// A number to sort by, and the index that it belongs to.
struct SortKey {
    double key = 0.0;
    std::int32_t index = 0;

    /// Orders by key, then by index.
    friend bool operator<(const SortKey& x, const SortKey& y) {
        return x.key < y.key || (x.key == y.key && x.index < y.index);
    }
};

/// Sorts keys in linear time (radix sort, least significant digit first). Owns the working memory.
class KeySort {
public:
    /// Sorts by key, then by index. Keys are finite.
    void sort(std::vector<SortKey>& keys);

private:
    struct Digits {
        std::uint32_t bits;
        std::int32_t at;
    };
    void sortDigits();

    std::vector<Digits> digits_, other_;
    std::vector<SortKey> before_;
};

}  // namespace muster
