#include "muster/generated/walk_totals.h"

#include <algorithm>
#include <cmath>

namespace muster {

void WalkTotals::add(double walk) {
    if (!std::isfinite(walk)) return;
    sum += walk;
    squares += walk * walk;
    longest = std::max(longest, walk);
}

void WalkTotals::add(const WalkTotals& others) {
    sum += others.sum;
    squares += others.squares;
    longest = std::max(longest, others.longest);
}

}  // namespace muster
