// The side of each island on which every place of a stream passes: one run in every row that it crosses.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/stream_flow.h"

namespace muster {

/// The course of one place of a stream. `a` is its end farther back on the line, `b` the one farther ahead.
struct StreamCourse {
    StreamPoint start;      ///< Start of the place.
    StreamPoint end;        ///< End of the place.
    double ordinate = 0.0;  ///< Offset to the left in the formation [m].
    double perStart = 1.0;  ///< Inverse share of its course after which it is in the formation...
    /// ... and inverse share before its end from which it leaves it. 1: no formation is made.
    double perEnd = 1.0;
    std::int32_t first = 0;  ///< The first row that it crosses...
    std::int32_t last = -1;  ///< ... and the last; less than the first where there is none.
    std::int32_t entry = 0;  ///< Index of its first row in tables over all courses.

    std::int32_t rows() const { return last - first + 1; }            ///< Number of rows, 0 or more.
    StreamPoint a() const { return start.s <= end.s ? start : end; }  ///< The end farther back.
    StreamPoint b() const { return start.s <= end.s ? end : start; }  ///< The end farther ahead.
    /// Its ordinate at `s` [m] on open ground: from its start to that of the formation to its end.
    double nominal(double s) const;
};

/// Chooses the runs of courses. Ground beyond start and end of a place does not count for it. Owns its
/// memory.
class StreamPaths {
public:
    /// Begins without courses.
    void start(const StreamRuns& runs, double step);
    /// Sets the rows of a course and chooses its runs; returns the operations. `shares` are by run.
    std::int32_t choose(const StreamRuns& runs, std::span<const StreamShare> shares, StreamCourse& course);
    /// False where a place has no path.
    bool all() const { return all_; }
    /// The runs of a course, by number, from its first row on.
    std::span<const std::int32_t> of(const StreamCourse& course) const {
        return {path_.data() + course.entry, static_cast<std::size_t>(course.rows())};
    }
    /// Number of entries of all courses.
    std::int32_t entries() const { return static_cast<std::int32_t>(path_.size()); }

private:
    bool follow(const StreamRuns& runs, std::span<const StreamShare> shares, const StreamCourse& course,
                std::int32_t from, std::int32_t to);
    std::int32_t search(const StreamRuns& runs, std::span<const StreamShare> shares,
                        const StreamCourse& course, std::int32_t from, std::int32_t to);

    bool all_ = true;
    double step_ = 0.5;
    std::vector<std::int32_t> path_;
    std::vector<double> cost_;          // Costs of a search, by run.
    std::vector<std::int32_t> before_;  // By run: the run in the row before.
};

}  // namespace muster
