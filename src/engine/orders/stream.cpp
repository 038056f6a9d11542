// Positions of the places of a planned march, and their progress.
#include "engine/orders/stream.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr std::int32_t kMostTries = 12;     // Greatest number of tries in a step; one is the rule.
constexpr double kLeastSpeedShare = 0.95;   // Share of the top speed that a step must reach,
constexpr double kAimedSpeedShare = 0.997;  // and share at which it aims.

double faded(double q, double share) {
    return std::max(0.0, 1.0 - q / share);
}

}  // namespace

// Writes how far ahead of the whole formation its depths are: rows that are less full than wide are stretched
// less.
void Stream::closeUp(double q, Depths& ahead) const {
    double xi = nominalFront_ + q * travel_;
    const double ordered = std::min(1.0, std::min(q, 1.0 - q) * orderRate_);
    for (std::int32_t k = 0; k <= kDepths; ++k) {
        ahead[k] = ordered * (xi - nominalFront_ - q * travel_ + k * depthStep_);
        xi -= depthStep_ * std::min(1.0, std::max(full_[k], 1.0 / stretch_.sigmaAt(xi)));
    }
}

Vec2 Stream::raw(std::size_t i, double q, const Depths& ahead) const {
    const Leg& leg = legs_[i];
    const StreamCourse& course = courses_[i];
    if (course.rows() == 0) return lerp(starts_[i], ends_[i], q);
    double off = 1.0 - q, on = q, xi = leg.fromXi + (leg.toXi - leg.fromXi) * q;
    if (fadeStart_ < 1.0 || fadeEnd_ < 1.0) {
        off = faded(q, fadeStart_);
        on = faded(1.0 - q, fadeEnd_);
        const double lead = leg.nominalXi + q * travel_;
        xi = lead + (leg.fromXi - leg.nominalXi) * off + (leg.toXi - leg.nominalXi - travel_) * on;
    }
    // Single order comes and goes over some metres, since starts and ends are not in it.
    const double ordered = std::min(1.0, std::min(q, 1.0 - q) * orderRate_);
    const double turn = stretch_.single(xi) * ordered * leg.shift;
    xi -= turn;
    if (hollow_) {
        const double x = std::clamp((offsets_[i].x + turn) / depthStep_, 0.0, kDepths - 1e-9);
        const auto k = static_cast<std::size_t>(x);
        xi += ahead[k] + (ahead[k + 1] - ahead[k]) * (x - static_cast<double>(k));
    }
    const double s = stretch_.s(xi);
    return line_.point({s, banks_.left(course, s)});
}

// The position of a place that does not flow, in one piece with the others at a pose.
Vec2 Stream::straight(std::size_t i, double q, const Pose& pose) const {
    return piece_.empty() ? lerp(starts_[i], ends_[i], q) : pose.apply(offsets_[i]) + miss(i, q);
}

// The difference between starts or ends and the points of their coordinates.
Vec2 Stream::miss(std::size_t i, double q) const {
    return legs_[i].missFrom * faded(q, kFade) + legs_[i].missTo * faded(1.0 - q, kFade);
}

void Stream::at(double q, std::span<Vec2> places) const {
    Depths ahead;
    if (flows_ && hollow_) closeUp(q, ahead);
    const Pose pose = pieceAt(q);
    for (std::size_t i = 0; i < starts_.size(); ++i) {
        if (q <= 0.0) {
            places[i] = starts_[i];
        } else if (q >= 1.0) {
            places[i] = ends_[i];
        } else {
            places[i] = flows_ ? raw(i, q, ahead) + miss(i, q) : straight(i, q, pose);
        }
    }
}

// The largest move of a place as a share of what it may move, except for the tenth that moves most: where a
// few have to go far aside, the others need not wait for them.
double Stream::overshoot(std::span<const Vec2> from, std::span<const Vec2> to, double reach,
                         std::span<const double> speeds) {
    moves_.resize(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
        const double may = speeds.empty() ? reach : reach * speeds[i];
        moves_[i] = lengthSquared(to[i] - from[i]) / (may * may);
    }
    const auto at = moves_.end() - 1 - static_cast<std::ptrdiff_t>(moves_.size() / kStragglers);
    std::nth_element(moves_.begin(), at, moves_.end());
    return std::sqrt(*at);
}

double Stream::next(double q, double dt, std::span<const double> speeds, std::span<Vec2> places,
                    double& rate) {
    if (places.empty()) return q;
    const double way = dt * *std::max_element(speeds.begin(), speeds.end());
    double step = way * (rate > 0.0 ? rate : 1.0 / std::max(most_, 1e-9));
    double next = q, share = 1.0;
    bool grown = false;
    for (std::int32_t k = 0; k < kMostTries; ++k) {
        next = std::min(1.0, q + step);
        at(next, moved_);
        share = overshoot(places, moved_, dt, speeds);
        if (share > 1.0) {
            const double less = (1.0 - 1e-3 * (k + 1)) / share;
            step = (next - q) * (k < kMostTries / 2 ? less : std::min(0.5, less));
            grown = true;
        } else if (share > kLeastSpeedShare || grown || next == 1.0) {
            break;
        } else {
            step *= std::min(4.0, 0.999 / std::max(share, 0.01));
            grown = true;
        }
    }
    rate = (next - q) / way * std::clamp(kAimedSpeedShare / std::max(share, 1e-9), 0.5, 2.0);
    std::copy(moved_.begin(), moved_.end(), places.begin());
    return next;
}

}  // namespace muster
