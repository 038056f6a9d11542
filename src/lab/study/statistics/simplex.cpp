#include "lab/study/statistics/numerics.h"

#include <algorithm>
#include <cmath>

namespace muster::statistics {
namespace {

constexpr int kMostValues = 2000;
constexpr double kSpreadEnough = 1e-11;

struct Corner {
    std::vector<double> at;
    double value = 0.0;
};

using Function = std::function<double(const std::vector<double>&)>;

/// The corner on the line from `from` through `middle`: `share` 1 mirrors it, -0.5 halves the way.
Corner along(const Function& value, const std::vector<double>& middle, const std::vector<double>& from,
             double share) {
    Corner corner{middle, 0.0};
    for (std::size_t i = 0; i < middle.size(); ++i) corner.at[i] += share * (middle[i] - from[i]);
    corner.value = value(corner.at);
    return corner;
}

/// Draws all corners to the best.
void shrink(const Function& value, std::vector<Corner>& corners) {
    for (std::size_t k = 1; k < corners.size(); ++k) {
        for (std::size_t i = 0; i < corners[k].at.size(); ++i)
            corners[k].at[i] = 0.5 * (corners[k].at[i] + corners[0].at[i]);
        corners[k].value = value(corners[k].at);
    }
}

/// Moves the worst corner.
void advance(const Function& value, std::vector<Corner>& corners) {
    const std::size_t n = corners.size() - 1;
    std::vector<double> middle(n, 0.0);
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i < n; ++i) middle[i] += corners[k].at[i] / static_cast<double>(n);
    Corner& worst = corners[n];
    const Corner mirrored = along(value, middle, worst.at, 1.0);
    if (mirrored.value < corners[0].value) {
        const Corner farther = along(value, middle, worst.at, 2.0);
        worst = farther.value < mirrored.value ? farther : mirrored;
        return;
    }
    if (mirrored.value < corners[n - 1].value) {
        worst = mirrored;
        return;
    }
    const bool outside = mirrored.value < worst.value;
    const Corner nearer = along(value, middle, worst.at, outside ? 0.5 : -0.5);
    if (nearer.value < (outside ? mirrored.value : worst.value))
        worst = nearer;
    else
        shrink(value, corners);
}

}  // namespace

std::vector<double> leastBySimplex(const Function& value, const std::vector<double>& start, double edge) {
    int values = 0;
    const Function counted = [&](const std::vector<double>& at) {
        ++values;
        return value(at);
    };
    std::vector<Corner> corners{{start, counted(start)}};
    for (std::size_t i = 0; i < start.size(); ++i) {
        Corner corner{start, 0.0};
        corner.at[i] += edge;
        corner.value = counted(corner.at);
        corners.push_back(corner);
    }
    while (values < kMostValues) {
        std::stable_sort(corners.begin(), corners.end(),
                         [](const Corner& a, const Corner& b) { return a.value < b.value; });
        if (corners.back().value - corners.front().value <=
            kSpreadEnough * (1.0 + std::abs(corners.front().value)))
            break;
        advance(counted, corners);
    }
    return std::min_element(corners.begin(), corners.end(),
                            [](const Corner& a, const Corner& b) { return a.value < b.value; })
        ->at;
}

}  // namespace muster::statistics
