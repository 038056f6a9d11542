// The middle line of a stream: rows across a way at even distances, and coordinates along and across it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// On the inside of a bend rows are never nearer to each other than by that share.
inline constexpr double kLeastBend = 0.45;

/// Calls `set(k, mean)` for all k in [0, n) with the mean of at(k - half) to at(k + half).
template <class At, class Set>
void runningMeans(std::int32_t n, std::int32_t half, const At& at, const Set& set) {
    decltype(at(0)) sum{};
    for (std::int32_t k = -half; k <= half; ++k) sum += at(k);
    for (std::int32_t k = 0; k < n; ++k) {
        set(k, sum / (2.0 * half + 1.0));
        sum += at(k + half + 1) - at(k - half);
    }
}

/// A row across the way.
struct StreamRow {
    Vec2 centre;        ///< On the middle line [m].
    Vec2 along;         ///< Unit vector along the way.
    Vec2 across;        ///< Unit vector to the left.
    double bend = 0.0;  ///< Curvature, positive to the left [1/m].
};

/// Along and across.
struct StreamPoint {
    double s = 0.0;  ///< Along the middle line, from its first row on [m].
    double d = 0.0;  ///< To the left of it [m].
};

/// A way as a line of rows. Owns its memory and uses it again.
class StreamLine {
public:
    /// Takes a polyline of two points or more, longer by `back` and `fore` [m] at its ends. Corners are
    /// rounded over `round` [m] of the way.
    void make(std::span<const Vec2> way, double back, double fore, double round);

    /// Moves each row to the left by `left` [m], evened over `round` [m], and takes even distances again.
    void shift(std::vector<double>& left, double round);

    std::int32_t rows() const { return static_cast<std::int32_t>(rows_.size()); }  ///< At least 2.
    const StreamRow& row(std::int32_t k) const { return rows_[k]; }                ///< The k-th.
    double step() const { return step_; }                                          ///< Between rows [m].
    /// The geometry at `s` [m]: between rows both ends of a row are interpolated.
    StreamRow at(double s) const;
    /// The point of the ground. Beyond the line it goes straight on.
    Vec2 point(StreamPoint p) const;
    /// Coordinates of a point of the ground, by the nearest of the rows from `first` to `last` [m].
    StreamPoint locate(Vec2 p, double first, double last) const;

private:
    void resample(const std::vector<Vec2>& from, double step, std::vector<Vec2>& to) const;
    void round(double width);
    void takeRows(double whole);

    std::vector<StreamRow> rows_;
    std::vector<Vec2> fine_, scratch_;
    std::vector<double> means_;
    double step_ = 0.5;
};

}  // namespace muster
