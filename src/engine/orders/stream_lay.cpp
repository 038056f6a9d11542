// Lays courses between the banks of a stream, and keeps them apart.
#include "engine/orders/stream_banks.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kNoBank = 1e9;  // An offset beyond all banks [m].

/// The offset to the left at `s` [m] of the straight line between two points.
double between(StreamPoint p, StreamPoint q, double s) {
    const double whole = q.s - p.s;
    return p.d + (q.d - p.d) * (std::fabs(whole) > 1e-9 ? std::clamp((s - p.s) / whole, 0.0, 1.0) : 1.0);
}

}  // namespace

// Finds the offsets of a course by its banks alone: between banks neighbouring courses keep their distances,
// or are squeezed evenly.
void StreamBanks::aim(std::span<const std::int32_t> path, const StreamCourse& course) {
    for (std::int32_t k = course.first; k <= course.last; ++k) {
        const Banks& banks = near_[k];
        const double y = course.nominal(k * step_);
        const double right = std::min(y, loads_[path[banks.low.from - course.first]].low);
        const double left = std::max(y, loads_[path[banks.high.from - course.first]].high);
        const double width = std::max(0.0, banks.high.value - banks.low.value);
        const double share = left - right > width ? width / (left - right) : 1.0;
        double least = banks.low.value + (y - right) * share;
        double most = banks.high.value - (left - y) * share;
        share_[course.entry + k - course.first] = static_cast<float>(share);
        if (least > most) least = most = 0.5 * (least + most);
        least_[k] = least;
        most_[k] = most;
        up_[k] = down_[k] = std::clamp(y, least, most);
    }
}

// Evens a course: no steeper than places may turn aside, within its runs, and exactly from its start to its
// end.
void StreamBanks::even(const StreamRuns& runs, std::span<const std::int32_t> path, const StreamCourse& course,
                       double slope) {
    const std::int32_t a = course.first, b = course.last;
    const double gentle = slope * step_;
    for (std::int32_t k = a; k <= b; ++k) {
        const StreamRun& here = run(runs, path, course, k);
        least_[k] = std::clamp(least_[k], here.low, here.high);
        most_[k] = std::clamp(most_[k], here.low, here.high);
    }
    const auto follow = [&](std::int32_t k, std::int32_t from, double rise) {
        up_[k] = std::max(up_[k], up_[from] - gentle);
        down_[k] = std::min(down_[k], down_[from] + gentle);
        least_[k] = std::max(least_[k], least_[from] - rise);
        most_[k] = std::min(most_[k], most_[from] + rise);
    };
    const auto hold = [&](std::int32_t k, StreamPoint p) {
        const double rise = std::fabs(k * step_ - p.s) / step_ * placeRise_[k];
        least_[k] = std::max(least_[k], p.d - rise);
        most_[k] = std::min(most_[k], p.d + rise);
    };
    hold(a, course.a());
    hold(b, course.b());
    for (std::int32_t k = a + 1; k <= b; ++k) follow(k, k - 1, placeRise_[k - 1]);
    for (std::int32_t k = b; k-- > a;) follow(k, k + 1, placeRise_[k]);
    for (std::int32_t k = a; k <= b; ++k) {
        const double middle = up_[k] == down_[k] ? up_[k] : 0.5 * (up_[k] + down_[k]);
        const StreamRun& here = run(runs, path, course, k);
        const double least = std::min(least_[k], most_[k]), most = std::max(least_[k], most_[k]);
        left_[course.entry + k - a] = std::clamp(std::clamp(middle, least, most), here.low, here.high);
    }
}

void StreamBanks::lay(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course) {
    if (course.rows() == 0) return;
    const std::span<const std::int32_t> path = paths.of(course);
    bound(runs, path, course);
    aim(path, course);
    even(runs, path, course, kGentleSlope);
}

void StreamBanks::smooth(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course) {
    if (course.rows() == 0) return;
    const std::span<const std::int32_t> path = paths.of(course);
    for (std::int32_t k = course.first; k <= course.last; ++k) {
        up_[k] = down_[k] = left_[course.entry + k - course.first];
        least_[k] = -kNoBank;
        most_[k] = kNoBank;
    }
    even(runs, path, course, kSteepSlope);
    for (std::int32_t k = course.first; k <= course.last; ++k) {
        StreamLoad& load = loads_[path[k - course.first]];
        load.right = std::min(load.right, left_[course.entry + k - course.first]);
        load.left = std::max(load.left, left_[course.entry + k - course.first]);
    }
}

std::int32_t StreamBanks::part(const StreamRuns& runs, const StreamPaths& paths,
                               std::span<const StreamCourse> courses, std::span<std::uint32_t> order,
                               std::int32_t k) {
    const auto n = static_cast<std::int32_t>(courses.size());
    ordinate_.resize(n);
    for (std::int32_t i = 0; i < n; ++i) ordinate_[i] = courses[i].nominal(k * step_);
    const auto before = [&](std::uint32_t a, std::uint32_t b) {
        return ordinate_[a] != ordinate_[b] ? ordinate_[a] < ordinate_[b] : a < b;
    };
    std::int32_t work = n / 8 + 1;
    for (std::int32_t i = 1; i < n; ++i) {
        const std::uint32_t moved = order[i];
        std::int32_t j = i;
        for (; j > 0 && before(moved, order[j - 1]); --j, ++work) order[j] = order[j - 1];
        order[j] = moved;
    }
    const std::span<const StreamRun> row = runs.row(k);
    for (std::size_t r = 0; r < row.size(); ++r) {
        const std::int32_t number = runs.first(k) + static_cast<std::int32_t>(r);
        if (!loads_[number].used()) continue;
        inRun_.clear();
        for (const std::uint32_t i : order) {
            const StreamCourse& course = courses[i];
            if (k >= course.first && k <= course.last && paths.of(course)[k - course.first] == number)
                inRun_.push_back(i);
        }
        partRun(courses, k, row[r]);
        work += static_cast<std::int32_t>(inRun_.size()) / 4 + n / 16;
    }
    return work;
}

// Finds the nearest offsets, by least squares, that keep the distances: pool adjacent violators.
void StreamBanks::partRun(std::span<const StreamCourse> courses, std::int32_t k, const StreamRun& run) {
    const std::size_t n = inRun_.size();
    const auto entry = [&](std::size_t j) { return courses[inRun_[j]].entry + k - courses[inRun_[j]].first; };
    gap_.assign(1, 0.0);
    for (std::size_t j = 1; j < n; ++j) {
        const double share = std::min(share_[entry(j)], share_[entry(j - 1)]);
        gap_.push_back(gap_.back() + share * (ordinate_[inRun_[j]] - ordinate_[inRun_[j - 1]]));
    }
    const double room = run.high - run.low, scale = gap_.back() > room ? room / gap_.back() : 1.0;
    value_.clear();
    weight_.clear();
    for (std::size_t j = 0; j < n; ++j) {
        value_.push_back(left_[entry(j)] - scale * gap_[j]);
        weight_.push_back(1.0);
        while (value_.size() > 1 && value_[value_.size() - 2] > value_.back()) {
            const std::size_t last = value_.size() - 1;
            const double weight = weight_[last - 1] + weight_[last];
            value_[last - 1] = (value_[last - 1] * weight_[last - 1] + value_[last] * weight_[last]) / weight;
            weight_[last - 1] = weight;
            value_.pop_back();
            weight_.pop_back();
        }
    }
    const double most = std::max(run.low, run.high - scale * gap_.back());
    for (std::size_t j = 0, b = 0, left = 0; j < n; ++j) {
        if (left == 0) left = static_cast<std::size_t>(std::floor(weight_[b++] + 0.5));
        --left;
        double& d = left_[entry(j)];
        if (weight_[b - 1] > 1.5 || d < run.low + scale * gap_[j] || d > most + scale * gap_[j])
            d = std::clamp(std::clamp(value_[b - 1], run.low, most) + scale * gap_[j], run.low, run.high);
    }
}

double StreamBanks::left(const StreamCourse& course, double s) const {
    const StreamPoint a = course.a(), b = course.b();
    if (course.rows() == 0) return between(a, b, s);
    const double x = s / step_;
    const double* left = left_.data() + course.entry;
    if (x >= course.first && x < course.last) {
        const auto k = static_cast<std::int32_t>(x);
        const double d = left[k - course.first], next = left[k - course.first + 1];
        return d + (next - d) * (x - k);
    }
    const bool back = x < course.first;
    const std::int32_t k = back ? course.first : course.last;
    return between(back ? a : b, {k * step_, left[k - course.first]}, s);
}

}  // namespace muster
