// The plan of a march that flows: the order of its rows, its ends, and the coordinates of its places.
#include <algorithm>
#include <cmath>

#include "engine/orders/stream.h"

namespace muster {
namespace {

constexpr double kGolden = 0.61803398874989485;  // The golden ratio, less 1.

constexpr std::size_t kMeasures = 32;    // Number of samples by which the length of a march is measured...
constexpr double kMeasureStep = 1e-3;    // ... and the length of q of each.
constexpr double kFullnessFactor = 2.0;  // Factor by which rows count as fuller, so that they keep apart.
// Distance before and behind a row over which the fullest row counts [spacings].
constexpr double kFullnessReach = 0.25;
constexpr double kHollowShare = 0.95;  // Share of its width below which a row counts as hollow.

}  // namespace

// Brings the rows of the formation into single order: places farther ahead first, places beside each other by
// the golden ratio, so that no squeeze brings two together.
void Stream::orderRows() {
    const std::size_t n = offsets_.size();
    legs_.assign(n, {});
    beside_.resize(n);
    rank_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) beside_[i] = rank_[i] = i;
    std::sort(beside_.begin(), beside_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return offsets_[a].y != offsets_[b].y ? offsets_[a].y < offsets_[b].y : a < b;
    });
    struct Key {
        double row, quarter, turn, file;
    };
    const auto key = [&](std::uint32_t i) {
        const double file = std::floor((offsets_[i].y - low_) / spacing_ + 0.5), x = offsets_[i].x / spacing_;
        return Key{std::floor(x + 0.5), std::floor(4.0 * x + 0.5),
                   file * kGolden - std::floor(file * kGolden), file};
    };
    std::sort(rank_.begin(), rank_.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Key p = key(a), q = key(b);
        if (p.row != q.row) return p.row < q.row;
        if (p.quarter != q.quarter) return p.quarter < q.quarter;
        if (p.turn != q.turn) return p.turn < q.turn;
        return p.file != q.file ? p.file < q.file : a < b;
    });
    for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
        const double row = key(rank_[begin]).row;
        while (end < n && key(rank_[end]).row == row) ++end;
        for (std::size_t k = begin; k < end; ++k) {
            const double share = (static_cast<double>(k - begin) + 0.5) / static_cast<double>(end - begin);
            legs_[rank_[k]].shift = spacing_ * (row + share - 0.5) - offsets_[rank_[k]].x;
        }
    }
}

// Finds how full the rows of the formation are, by depth.
void Stream::fillDepths() {
    double depth = 0.0;
    for (const Vec2 p : offsets_) depth = std::max(depth, p.x);
    depthStep_ = std::max(depth, spacing_) / kDepths;
    Depths count{};
    for (const Vec2 p : offsets_) {
        const auto from = static_cast<std::int32_t>(std::ceil((p.x - 0.5 * spacing_) / depthStep_ + 1e-6));
        const auto to = static_cast<std::int32_t>(std::floor((p.x + 0.5 * spacing_) / depthStep_ - 1e-6));
        for (std::int32_t k = std::max(0, from); k <= std::min(kDepths, to); ++k) count[k] += spacing_;
    }
    const auto near = static_cast<std::int32_t>(kFullnessReach * spacing_ / depthStep_);
    hollow_ = false;
    for (std::int32_t k = 0; k <= kDepths; ++k) {
        double most = spacing_;
        for (std::int32_t j = std::max(0, k - near); j <= std::min(kDepths, k + near); ++j)
            most = std::max(most, count[j]);
        full_[k] = std::min(1.0, kFullnessFactor * most / (high_ - low_ + spacing_));
        hollow_ = hollow_ || full_[k] < kHollowShare;
    }
    hollow_ = hollow_ && stretch_.most() > 1.0;
    // Rows with few places beside each other need less of a turn.
    for (std::size_t i = 0; hollow_ && i < legs_.size(); ++i)
        legs_[i]
            .shift *= full_[static_cast<std::size_t>(std::min(offsets_[i].x / depthStep_, kDepths + 0.0))];
}

void Stream::finish() {
    stretch_.widen(runs_, banks_);
    double shift = 0.0, from = 0.0, to = 0.0;
    for (const Leg& leg : legs_) shift = std::max(shift, std::fabs(leg.shift));
    stretch_.settle(shift);
    const std::size_t n = legs_.size();
    for (std::size_t i = 0; i < n; ++i) {
        Leg& leg = legs_[i];
        leg.fromXi = stretch_.xi(courses_[i].start.s);
        leg.toXi = stretch_.xi(courses_[i].end.s);
        from += leg.fromXi + offsets_[i].x;
        to += leg.toXi + offsets_[i].x;
        most_ = std::max(most_, std::fabs(leg.toXi - leg.fromXi));
    }
    travel_ = (to - from) / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) legs_[i].nominalXi = from / static_cast<double>(n) - offsets_[i].x;
    nominalFront_ = from / static_cast<double>(n);
    // While the formation is made and left the ground is not stretched.
    const double longer = (endS_ - startS_) / std::max(travel_, 1e-9);
    if (fadeStart_ < 1.0) fadeStart_ = std::min(1.0, fadeStart_ * longer);
    if (fadeEnd_ < 1.0) fadeEnd_ = std::min(1.0, fadeEnd_ * longer);
    fillDepths();
    orderRate_ = std::max(1.0, std::fabs(travel_)) / (2.0 * StreamStretch::orderRoom(shift));
    const Depths none{};
    for (std::size_t i = 0; i < n; ++i) {
        legs_[i].missFrom = starts_[i] - raw(i, 0.0, none);
        legs_[i].missTo = ends_[i] - raw(i, 1.0, none);
    }
    spent_ += 8 * static_cast<std::int64_t>(n) + 8 * line_.rows();
    if (!measured_) status_ = StreamStatus::Flowing;
    enter(Stage::Measure);
}

// Takes one sample: the speed of the fastest place, by q, weighted by its ground.
void Stream::measure(StreamGround ground) {
    const double q = (static_cast<double>(next_) + 0.5) / kMeasures;
    at(q, last_);
    at(q + kMeasureStep, moved_);
    speeds_.clear();
    for (std::size_t i = 0; i < last_.size() && ground.uneven(); ++i)
        speeds_.push_back(ground.speed(last_[i]));
    length_ += overshoot(last_, moved_, kMeasureStep * kMeasures, speeds_);
    spent_ += 3 * static_cast<std::int64_t>(moved_.size());
    if (++next_ == kMeasures) status_ = flows_ ? StreamStatus::Flowing : StreamStatus::Straight;
}

}  // namespace muster
