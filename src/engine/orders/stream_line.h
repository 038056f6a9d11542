// The middle line of a stream: rows across a route at even distances, and coordinates along and across it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// Least share of the distance between rows on the inside of a bend.
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

/// A row across the route.
struct StreamRow {
    Vec2 centre;        ///< Point on the middle line [m].
    Vec2 along;         ///< Unit vector along the route.
    Vec2 across;        ///< Unit vector to the left.
    double bend = 0.0;  ///< Curvature, positive to the left [1/m].
};

/// Coordinates along and across the line.
struct StreamPoint {
    double s = 0.0;  ///< Distance along the middle line, from its first row on [m].
    double d = 0.0;  ///< Distance to the left of the line [m].
};

/// A route as a line of rows. Owns its memory and reuses it.
class StreamLine {
public:
    /// Takes a polyline of two points or more, lengthened by `back` and `fore` [m] at its ends. Corners are
    /// rounded over `round` [m] of the line.
    void make(std::span<const Vec2> way, double back, double fore, double round);

    /// Moves each row to the left by `left` [m], evened over `round` [m], and takes even distances again.
    void shift(std::vector<double>& left, double round);

    /// Number of rows, at least 2.
    std::int32_t rows() const { return static_cast<std::int32_t>(rows_.size()); }
    const StreamRow& row(std::int32_t k) const { return rows_[k]; }  ///< The row k.
    double step() const { return step_; }                            ///< Distance between rows [m].
    /// The geometry at `s` [m]; between rows both ends of a row are interpolated.
    StreamRow at(double s) const;
    /// The point of the ground at coordinates. Beyond its ends the line goes straight on.
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
