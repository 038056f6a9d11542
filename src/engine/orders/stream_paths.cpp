#include "engine/orders/stream_paths.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"

namespace muster {
namespace {

/// Number of the run of a row that is nearest to `d`; -1 where there is none.
std::int32_t nearestRun(const StreamRuns& runs, std::int32_t k, double d) {
    const std::span<const StreamRun> row = runs.row(k);
    std::int32_t best = -1;
    for (std::size_t r = 0; r < row.size(); ++r)
        if (best < 0 || row[r].outside(d) < row[best].outside(d)) best = static_cast<std::int32_t>(r);
    return best < 0 ? -1 : runs.first(k) + best;
}

}  // namespace

double StreamCourse::nominal(double s) const {
    const double whole = end.s - start.s;
    const double f = std::fabs(whole) > 1e-9 ? std::clamp((s - start.s) / whole, 0.0, 1.0) : 0.0;
    if (perStart <= 1.0 && perEnd <= 1.0) return start.d + (end.d - start.d) * f;
    const double off = std::max(0.0, 1.0 - f * perStart), on = std::max(0.0, 1.0 - (1.0 - f) * perEnd);
    return ordinate + (start.d - ordinate) * off + (end.d - ordinate) * on;
}

void StreamPaths::start(const StreamRuns& runs, double step) {
    all_ = true;
    step_ = step;
    path_.clear();
    cost_.resize(runs.count());
    before_.resize(runs.count());
}

std::int32_t StreamPaths::choose(const StreamRuns& runs, std::span<const StreamShare> shares,
                                 StreamCourse& course) {
    // The rows that lie half a step within its ends, where the ground is known a quarter of a metre farther.
    course.first = std::max(0, static_cast<std::int32_t>(std::ceil(course.a().s / step_ + 0.5)));
    course.last = std::min(runs.rows() - 1,
                           static_cast<std::int32_t>(std::floor(course.b().s / step_ - 0.5)));
    course.last = std::max(course.last, course.first - 1);
    course.entry = entries();
    if (course.rows() == 0) return 1;
    path_.resize(path_.size() + course.rows());
    const std::int32_t from = nearestRun(runs, course.first, course.a().d);
    const std::int32_t to = nearestRun(runs, course.last, course.b().d);
    std::int32_t work = course.rows() / 4 + 1;
    if (from < 0 || to < 0) {
        all_ = false;
    } else if (!follow(runs, shares, course, from, to)) {
        work += search(runs, shares, course, from, to);
    }
    return work;
}

// Follows the runs that hold the ordinate of a course; false where one does not lead to the next.
bool StreamPaths::follow(const StreamRuns& runs, std::span<const StreamShare> shares,
                         const StreamCourse& course, std::int32_t from, std::int32_t to) {
    std::int32_t at = from;
    for (std::int32_t k = course.first;; ++k) {
        path_[course.entry + k - course.first] = at;
        if (k == course.last) return at == to;
        const StreamRun& here = runs.row(k)[at - runs.first(k)];
        const std::span<const StreamRun> row = runs.row(k + 1);
        const double y = row.size() > 1 ? course.nominal((k + 1) * step_) : 0.0;
        std::int32_t next = -1;
        for (std::size_t r = 0; r < row.size() && next < 0; ++r) {
            const std::int32_t number = runs.first(k + 1) + static_cast<std::int32_t>(r);
            if (StreamRuns::join(here, row[r]) &&
                (row.size() == 1 ||
                 shares[number].outside(shares[number].flows ? course.ordinate : y) == 0.0))
                next = number;
        }
        if (next < 0) return false;
        at = next;
    }
}

// Searches the runs that are least far from the ordinate of a course, row by row. Returns the operations.
std::int32_t StreamPaths::search(const StreamRuns& runs, std::span<const StreamShare> shares,
                                 const StreamCourse& course, std::int32_t from, std::int32_t to) {
    std::int32_t work = 0;
    for (std::int32_t r = runs.first(course.first); r < runs.first(course.first + 1); ++r)
        cost_[r] = r == from ? 0.0 : kInfiniteCost;
    for (std::int32_t k = course.first; k < course.last; ++k) {
        const std::span<const StreamRun> here = runs.row(k), there = runs.row(k + 1);
        const double y = course.nominal((k + 1) * step_);
        for (std::size_t b = 0; b < there.size(); ++b) {
            const std::int32_t number = runs.first(k + 1) + static_cast<std::int32_t>(b);
            double least = kInfiniteCost;
            for (std::size_t a = 0; a < here.size(); ++a)
                if (StreamRuns::join(here[a], there[b]) && cost_[runs.first(k) + a] < least) {
                    least = cost_[runs.first(k) + a];
                    before_[number] = runs.first(k) + static_cast<std::int32_t>(a);
                }
            cost_[number] = least + shares[number].outside(shares[number].flows ? course.ordinate : y);
        }
        work += 1 + static_cast<std::int32_t>(here.size() * there.size()) / 2;
    }
    if (cost_[to] == kInfiniteCost) {
        all_ = false;
        return work;
    }
    for (std::int32_t k = course.last, at = to; k >= course.first; --k) {
        path_[course.entry + k - course.first] = at;
        if (k > course.first) at = before_[at];
    }
    return work;
}

}  // namespace muster
