// On which side of each island every place of a stream passes: one run in every row that it comes through.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/stream_flow.h"

namespace muster {

/// What one place of a stream does along its way. `a` is where it is farther back on the line, `b` farther
/// ahead.
struct StreamCourse {
    StreamPoint start;       ///< Where it stands.
    StreamPoint end;         ///< Where it goes.
    double ordinate = 0.0;   ///< To the left in the formation [m].
    double perStart = 1.0;   ///< One over the share of its way after which it is in the formation...
    double perEnd = 1.0;     ///< ... and over that before its end in which it leaves it. 1: none is made.
    std::int32_t first = 0;  ///< The first row that it comes through...
    std::int32_t last = -1;  ///< ... and the last; before it where there is none.
    std::int32_t entry = 0;  ///< Of tables over all courses: where its rows begin.

    std::int32_t rows() const { return last - first + 1; }            ///< 0 or more.
    StreamPoint a() const { return start.s <= end.s ? start : end; }  ///< Farther back.
    StreamPoint b() const { return start.s <= end.s ? end : start; }  ///< Farther ahead.
    /// Its ordinate at `s` [m], where the ground is open: from its start to that of the formation to its end.
    double nominal(double s) const;
};

/// Chooses the runs. What lies beyond start and end of a place does not count for it. Owns its memory.
class StreamPaths {
public:
    /// Begins.
    void start(const StreamRuns& runs, double step);
    /// Sets the rows of a course and chooses its runs; returns the operations. `shares` is by run.
    std::int32_t choose(const StreamRuns& runs, std::span<const StreamShare> shares, StreamCourse& course);
    /// False where some place has no way.
    bool all() const { return all_; }
    /// The runs of a course, from its first row on: their numbers.
    std::span<const std::int32_t> of(const StreamCourse& course) const {
        return {path_.data() + course.entry, static_cast<std::size_t>(course.rows())};
    }
    std::int32_t entries() const { return static_cast<std::int32_t>(path_.size()); }  ///< Of all courses.

private:
    bool follow(const StreamRuns& runs, std::span<const StreamShare> shares, const StreamCourse& course,
                std::int32_t from, std::int32_t to);
    std::int32_t search(const StreamRuns& runs, std::span<const StreamShare> shares,
                        const StreamCourse& course, std::int32_t from, std::int32_t to);

    bool all_ = true;
    double step_ = 0.5;
    std::vector<std::int32_t> path_;
    std::vector<double> cost_;          // By run, of a search.
    std::vector<std::int32_t> before_;  // The same: the run in the row before.
};

}  // namespace muster
