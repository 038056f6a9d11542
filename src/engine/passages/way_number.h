// The numbers of ways: each passage has two, one from either side.
#pragma once

#include <cstddef>
#include <cstdint>

namespace muster {

/// The number of a way: twice that of its passage, plus 1 for the way that comes from the left side. `side`
/// is the side from which it comes, 1 for left and -1 for right, as in Walk::side.
constexpr std::int32_t wayNumber(std::int32_t passage, std::int32_t side) {
    return 2 * passage + (side > 0 ? 1 : 0);
}
/// Number of ways through a number of passages.
constexpr std::size_t wayCount(std::size_t passages) {
    return 2 * passages;
}
/// The passage of a way, which is not negative.
constexpr std::size_t passageOf(std::int32_t way) {
    return static_cast<std::size_t>(way) / 2;
}
/// True for a way that comes from the left side of its passage.
constexpr bool fromLeft(std::int32_t way) {
    return way % 2 == 1;
}
/// The side from which a way comes, 1 for left and -1 for right.
constexpr std::int32_t sideBefore(std::int32_t way) {
    return fromLeft(way) ? 1 : -1;
}
/// The side to which a way leads.
constexpr std::int32_t sideBehind(std::int32_t way) {
    return -sideBefore(way);
}

}  // namespace muster
