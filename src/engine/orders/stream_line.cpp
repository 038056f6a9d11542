#include "engine/orders/stream_line.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kRowStep = 0.5;          // Distance between rows [m].
constexpr std::int32_t kMostRows = 2000;  // Greatest number of rows; longer routes have rows farther apart.
constexpr double kFineStep = 0.25;        // Step of the line while its corners are rounded [m].
constexpr double kLeastFold = 0.2;        // Share of its length that a line keeps on the inside of a bend.

}  // namespace

void StreamLine::resample(const std::vector<Vec2>& from, double step, std::vector<Vec2>& to) const {
    double whole = 0.0;
    for (std::size_t k = 1; k < from.size(); ++k) whole += distance(from[k - 1], from[k]);
    const auto n = std::max(2, static_cast<std::int32_t>(std::ceil(whole / step - 1e-9)) + 1);
    to.clear();
    to.push_back(from.front());
    std::size_t next = 1;
    double before = 0.0;
    for (std::int32_t k = 1; k + 1 < n; ++k) {
        const double s = whole * k / (n - 1);
        double part = distance(from[next - 1], from[next]);
        while (next + 1 < from.size() && before + part < s) {
            before += part;
            ++next;
            part = distance(from[next - 1], from[next]);
        }
        to.push_back(lerp(from[next - 1], from[next], part > 0.0 ? std::min(1.0, (s - before) / part) : 0.0));
    }
    to.push_back(from.back());
}

// Takes the mean over `width`: a corner becomes a bend of that length. Beyond its ends the line goes straight
// on.
void StreamLine::round(double width) {
    const auto n = static_cast<std::int32_t>(fine_.size());
    const double step = distance(fine_[0], fine_[1]);
    const auto half = static_cast<std::int32_t>(0.5 * width / std::max(step, 1e-6));
    const auto at = [&](std::int32_t k) {
        if (k < 0) return fine_[0] + (fine_[0] - fine_[1]) * static_cast<double>(-k);
        if (k >= n) return fine_[n - 1] + (fine_[n - 1] - fine_[n - 2]) * static_cast<double>(k - n + 1);
        return fine_[k];
    };
    scratch_.resize(n);
    runningMeans(n, half, at, [&](std::int32_t k, Vec2 mean) { scratch_[k] = mean; });
    fine_.swap(scratch_);
}

void StreamLine::make(std::span<const Vec2> way, double back, double fore, double round) {
    const std::size_t n = way.size();
    const Vec2 first = normalized(way[1] - way[0], {1, 0}),
               last = normalized(way[n - 1] - way[n - 2], {1, 0});
    scratch_.clear();
    scratch_.push_back(way[0] - first * back);
    if (n > 2) scratch_.insert(scratch_.end(), way.begin(), way.end());
    scratch_.push_back(way[n - 1] + last * fore);
    double whole = 0.0;
    for (std::size_t k = 1; k < scratch_.size(); ++k) whole += distance(scratch_[k - 1], scratch_[k]);
    if (n > 2) {
        resample(scratch_, std::max(kFineStep, whole / (2.0 * kMostRows)), fine_);
        this->round(round);
        fine_.swap(scratch_);
    }
    takeRows(whole);
}

// Makes rows at even distances along the line in `scratch_`.
void StreamLine::takeRows(double whole) {
    resample(scratch_, std::max(kRowStep, whole / kMostRows), fine_);
    const auto count = static_cast<std::int32_t>(fine_.size());
    step_ = 0.0;
    for (std::int32_t k = 1; k < count; ++k) step_ += distance(fine_[k - 1], fine_[k]);
    step_ /= count - 1;
    rows_.resize(count);
    for (std::int32_t k = 0; k < count; ++k) {
        const Vec2 t = fine_[std::min(k + 1, count - 1)] - fine_[std::max(k - 1, 0)];
        rows_[k].centre = fine_[k];
        rows_[k].along = normalized(t, {1, 0});
        rows_[k].across = perpendicular(rows_[k].along);
    }
    for (std::int32_t k = 0; k < count; ++k) {
        const std::int32_t a = std::max(k - 1, 0), b = std::min(k + 1, count - 1);
        const double turn = cross(rows_[a].along, rows_[b].along);
        rows_[k].bend = std::fabs(turn) < 1e-9 ? 0.0 : turn / ((b - a) * step_);
    }
}

void StreamLine::shift(std::vector<double>& left, double round) {
    const auto half = static_cast<std::int32_t>(0.5 * round / step_);
    // The mean is taken twice, which leaves no kinks.
    for (std::int32_t turn = 0; turn < 2; ++turn) {
        const auto at = [&](std::int32_t k) { return left[std::clamp(k, 0, rows() - 1)]; };
        means_.resize(rows());
        runningMeans(rows(), half, at, [&](std::int32_t k, double mean) { means_[k] = mean; });
        left.swap(means_);
    }
    double whole = 0.0;
    scratch_.clear();
    for (std::int32_t k = 0; k < rows(); ++k) {
        scratch_.push_back(rows_[k].centre + rows_[k].across * left[k]);
        if (k > 0) whole += distance(scratch_[k - 1], scratch_[k]);
    }
    takeRows(whole);
}

StreamRow StreamLine::at(double s) const {
    const double x = std::clamp(s / step_, 0.0, rows() - 1.0);
    const std::int32_t k = std::min(static_cast<std::int32_t>(x), rows() - 2);
    const double f = x - k;
    const StreamRow &a = rows_[k], &b = rows_[k + 1];
    return {lerp(a.centre, b.centre, f), lerp(a.along, b.along, f), lerp(a.across, b.across, f),
            a.bend + (b.bend - a.bend) * f};
}

Vec2 StreamLine::point(StreamPoint p) const {
    const double x = std::clamp(p.s / step_, 0.0, rows() - 1.0);
    const std::int32_t k = std::min(static_cast<std::int32_t>(x), rows() - 2);
    const double f = x - k;
    const StreamRow &a = rows_[k], &b = rows_[k + 1];
    Vec2 out = lerp(a.centre, b.centre, f) + lerp(a.across, b.across, f) * p.d;
    if (p.s < 0.0) out += a.along * p.s;
    if (x >= rows() - 1.0) out += b.along * (p.s - x * step_);
    return out;
}

StreamPoint StreamLine::locate(Vec2 p, double first, double last) const {
    const auto a = std::clamp(static_cast<std::int32_t>(first / step_), 0, rows() - 1);
    const auto b = std::clamp(static_cast<std::int32_t>(last / step_), a, rows() - 1);
    std::int32_t best = a;
    for (std::int32_t k = a; k <= b; ++k)
        if (lengthSquared(p - rows_[k].centre) < lengthSquared(p - rows_[best].centre)) best = k;
    StreamPoint out{best * step_, dot(p - rows_[best].centre, rows_[best].across)};
    for (std::int32_t turn = 0; turn < 4; ++turn) {
        const StreamRow row = at(out.s);
        const double beyond = out.s - std::clamp(out.s, 0.0, (rows() - 1) * step_);
        const Vec2 away = p - row.centre - row.along * beyond;
        const double ahead = dot(away, row.along) / std::max(kLeastFold, 1.0 - row.bend * out.d);
        out.s = std::clamp(out.s + ahead, first, last);
        out.d = dot(p - at(out.s).centre, at(out.s).across) / lengthSquared(at(out.s).across);
    }
    return out;
}

}  // namespace muster
