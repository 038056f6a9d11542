#include "engine/orders/stream_stretch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muster {
namespace {

constexpr double kSingleOrderStretch = 0.4;  // Stretch from which on rows are in single order.
constexpr double kBins = 4.0;                // Bins of xi per row.
}  // namespace

void StreamStretch::start(const StreamLine& line, double spacing, double closest) {
    step_ = line.step();
    spacing_ = spacing;
    closest_ = closest;
    most_ = 1.0;
    narrow_.assign(line.rows(), 1.0);
}

void StreamStretch::widen(const StreamRuns& runs, const StreamBanks& banks) {
    for (std::int32_t k = 0; std::cmp_less(k, narrow_.size()); ++k) {
        for (std::int32_t r = runs.first(k); r < runs.first(k + 1); ++r) {
            const StreamLoad& load = banks.loads()[r];
            const double now = std::max(0.0, load.left - load.right) + spacing_;
            if (load.used()) narrow_[k] = std::max(narrow_[k], (load.high - load.low + spacing_) / now);
        }
        most_ = std::max(most_, narrow_[k]);
    }
}

void StreamStretch::settle(double shift) {
    const double area = closest_ * closest_ / (spacing_ * spacing_);
    sigma_.resize(narrow_.size());
    for (std::size_t k = 0; k < sigma_.size(); ++k) sigma_[k] = std::max(1.0, narrow_[k] * area);
    xi_.resize(sigma_.size());
    xi_[0] = 0.0;
    for (std::size_t k = 1; k < sigma_.size(); ++k) {
        // On unstretched ground xi is s to the bit.
        const bool open = sigma_[k] == 1.0 && sigma_[k - 1] == 1.0;
        xi_[k] = xi_[k - 1] + (open ? step_ : 0.5 * step_ * (1.0 / sigma_[k - 1] + 1.0 / sigma_[k]));
    }
    index();
    blend(shift);
}

void StreamStretch::index() {
    const auto bins = static_cast<std::size_t>(kBins * static_cast<double>(xi_.size()));
    bin_ = xi_.back() / static_cast<double>(bins);
    rowAt_.resize(bins + 1);
    std::int32_t k = 0;
    for (std::size_t b = 0; b <= bins; ++b) {
        while (k + 2 < static_cast<std::int32_t>(xi_.size()) && xi_[k + 1] <= static_cast<double>(b) * bin_)
            ++k;
        rowAt_[b] = k;
    }
}

// Computes the single order from the stretch: the most within reach, then the mean over it.
void StreamStretch::blend(double shift) {
    const auto n = static_cast<std::int32_t>(xi_.back() / kSample) + 2;
    const auto reach = static_cast<std::int32_t>(orderRoom(shift) / (2.0 * kSample)) + 1;
    single_.assign(n, 0.0);
    wide_.assign(n, 0.0);
    if (most_ <= 1.0) return;
    for (std::size_t k = 0; k < xi_.size(); ++k) {
        double& sample = single_[static_cast<std::size_t>(xi_[k] / kSample)];
        sample = std::max(sample, std::min(1.0, (narrow_[k] - 1.0) / kSingleOrderStretch));
    }
    for (std::int32_t k = 0; k < n; ++k)
        for (std::int32_t j = std::max(0, k - reach); j <= std::min(n - 1, k + reach); ++j)
            wide_[k] = std::max(wide_[k], single_[j]);
    const auto at = [&](std::int32_t k) { return wide_[std::clamp(k, 0, n - 1)]; };
    runningMeans(n, reach, at, [&](std::int32_t k, double mean) { single_[k] = mean < 1e-12 ? 0.0 : mean; });
}

double StreamStretch::xi(double s) const {
    const auto rows = static_cast<std::int32_t>(xi_.size());
    const double x = std::clamp(s / step_, 0.0, rows - 1.0);
    const std::int32_t k = std::min(static_cast<std::int32_t>(x), rows - 2);
    return xi_[k] + (xi_[k + 1] - xi_[k]) * (x - k) + (s - x * step_);
}

double StreamStretch::s(double xi) const {
    if (xi <= 0.0) return xi;
    if (xi >= xi_.back()) return (static_cast<double>(xi_.size()) - 1.0) * step_ + (xi - xi_.back());
    const auto b = static_cast<std::size_t>(xi / bin_);
    std::int32_t k = rowAt_[std::min(b, rowAt_.size() - 1)], end = rowAt_[std::min(b + 1, rowAt_.size() - 1)];
    while (k < end) {
        const std::int32_t middle = (k + end + 1) / 2;
        if (xi_[middle] <= xi) {
            k = middle;
        } else {
            end = middle - 1;
        }
    }
    return (k + (xi - xi_[k]) / (xi_[k + 1] - xi_[k])) * step_;
}

}  // namespace muster
