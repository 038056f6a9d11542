// Stretch of a stream that narrows: the coordinate along it in which a march is a translation.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/stream_banks.h"

namespace muster {

/// Per row its narrowness, own width over the width that is left, 1 or more; the stretch sigma, which is less
/// by as much as places may come nearer to each other, but 1 or more; and xi, the integral of ds / sigma.
class StreamStretch {
public:
    /// Begins with unstretched rows. Places that are `spacing` apart in the formation may come as near to
    /// each other as `closest`, which is no more [m].
    void start(const StreamLine& line, double spacing, double closest);
    /// Stretches rows whose runs are too narrow.
    void widen(const StreamRuns& runs, const StreamBanks& banks);
    /// Sums up. `shift` is the greatest length by which the single order moves a place [m].
    void settle(double shift);

    double xi(double s) const;  ///< Xi at `s` [m]; goes on beyond the line.
    double s(double xi) const;  ///< The coordinate s at `xi`.
    /// The stretch at `xi`, between rows linear.
    double sigmaAt(double xi) const {
        const auto last = static_cast<std::int32_t>(sigma_.size()) - 1;
        const double x = s(xi) / step_;
        if (x <= 0.0) return sigma_.front();
        if (x >= last) return sigma_.back();
        const auto k = static_cast<std::int32_t>(x);
        return sigma_[k] + (sigma_[k + 1] - sigma_[k]) * (x - k);
    }
    /// The length over which single order that moves places by `shift` [m] comes, and goes [m].
    static double orderRoom(double shift) { return 1.5 * std::max(1.0, shift); }
    double most() const { return most_; }  ///< Narrowness of the narrowest row.
    /// Degree of single order, [0, 1]: 1 where rows are narrow. Changes slowly along xi.
    double single(double xi) const {
        if (most_ <= 1.0) return 0.0;
        const double x = (xi < 0.0 ? 0.0 : xi) / kSample;
        const auto k = static_cast<std::size_t>(x);
        if (k + 1 >= single_.size()) return single_.back();
        return single_[k] + (single_[k + 1] - single_[k]) * (x - static_cast<double>(k));
    }

private:
    static constexpr double kSample = 0.25;  // Distance between samples of the single order [m].

    void index();
    void blend(double shift);

    double step_ = 0.5, spacing_ = 1.0, closest_ = 1.0, most_ = 1.0, bin_ = 1.0;
    std::vector<double> narrow_, sigma_, xi_;  // By row.
    std::vector<std::int32_t> rowAt_;          // By bins of xi: the last row that begins before it.
    std::vector<double> single_, wide_;        // By samples of xi.
};

}  // namespace muster
