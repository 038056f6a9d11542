// The free ground in the rows of a stream: runs with exact ends, and which of them are joined.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "base/function_ref.h"
#include "engine/orders/stream_line.h"

namespace muster {

/// The ground of a march by functions of a point, which must outlive it.
class StreamGround {
public:
    /// A ground of uniform speed. `room` is the distance to the nearest static obstacle or the edge of the
    /// world [m], negative inside. It may be too short, never too long, and changes by at most a metre per
    /// metre.
    template <class Room>
    requires(!std::is_same_v<std::remove_cvref_t<Room>, StreamGround>) StreamGround(Room&& room)
        : room_(room) {}  // NOLINT: implicit, so that lambdas can be passed.
    /// A ground whose travel speed is `speed`, above 0 and 1 on good ground.
    template <class Room, class Speed>
    StreamGround(Room&& room, Speed&& speed) : room_(room), speed_(speed) {}

    double operator()(Vec2 p) const { return room_(p); }  ///< The room at a point [m].
    bool uneven() const { return speed_.has_value(); }    ///< True where the speed of the ground differs.
    double speed(Vec2 p) const { return speed_ ? (*speed_)(p) : 1.0; }  ///< The travel speed at a point.

private:
    FunctionRef<double(Vec2)> room_;
    std::optional<FunctionRef<double(Vec2)>> speed_;
};

/// A stretch of a row where the middle of a body may be.
struct StreamRun {
    double low = 0.0;   ///< Right end [m].
    double high = 0.0;  ///< Left end [m].
    /// Parts of the ground a row behind, half a row behind, here, half a row ahead and a row ahead that hold
    /// the run; -1 where no part a row behind or ahead does.
    std::array<std::int32_t, 5> part{};
    /// The distance of `d` outside the run [m], 0 inside.
    double outside(double d) const { return d < low ? low - d : (d > high ? d - high : 0.0); }
};

/// The free runs of all rows. A run is free in the rows behind and ahead as well, and half-way to them, so
/// that straight stretches from row to row cut no corner; where no such run is left, only half-way. Owns its
/// memory and reuses it.
class StreamRuns {
public:
    /// Begins without rows. `half` is the reach of rows to both sides, per row [m].
    void start(const StreamLine& line, std::span<const double> half, double radius);
    /// Looks at the next row. Returns how often it read the ground.
    std::int32_t probe(const StreamLine& line, StreamGround ground);
    /// True once all rows are known.
    bool done() const { return static_cast<std::int32_t>(first_.size()) > rowCount_; }

    std::int32_t rows() const { return rowCount_; }  ///< Number of rows.
    /// Number of rows known so far.
    std::int32_t known() const { return static_cast<std::int32_t>(first_.size()) - 1; }
    /// The runs of a row from right to left.
    std::span<const StreamRun> row(std::int32_t k) const {
        return {runs_.data() + first_[k], static_cast<std::size_t>(first_[k + 1] - first_[k])};
    }
    std::int32_t first(std::int32_t k) const { return first_[k]; }  ///< Number of the first run of a row.
    /// Number of runs of all rows.
    std::int32_t count() const { return static_cast<std::int32_t>(runs_.size()); }
    /// True where run `a` of a row leads to run `b` of the next.
    static bool join(const StreamRun& a, const StreamRun& b) {
        return a.part[3] == b.part[1] && (a.part[4] < 0 || a.part[4] == b.part[2]) &&
               (b.part[0] < 0 || b.part[0] == a.part[2]);
    }

private:
    struct Part {
        double low, high;
    };

    std::int32_t trace(const StreamRow& row, double half, StreamGround ground);
    double edge(const StreamRow& row, double free, double blocked, StreamGround ground,
                std::int32_t& asked) const;
    void keep(double low, double high, bool wallLow, bool wallHigh);
    void joinRow(std::int32_t k);
    bool joinFar(const StreamRun& run, std::int32_t side, std::int32_t half);

    std::int32_t rowCount_ = 0, next_ = 0;  // Number of rows; the next half row.
    double radius_ = 0.25;
    std::vector<double> half_;
    std::vector<Part> parts_;           // Parts of half rows.
    std::vector<std::int32_t> partOf_;  // First part of each half row.
    std::vector<StreamRun> runs_, found_, split_;
    std::vector<std::int32_t> first_;
};

}  // namespace muster
