#include "engine/orders/stream_banks.h"

#include <algorithm>
#include <cmath>

namespace muster {

void StreamBanks::start(const StreamRuns& runs, double step, std::int32_t entries) {
    step_ = step;
    loads_.assign(runs.count(), {});
    for (std::int32_t k = 0; k < runs.rows(); ++k)
        for (std::size_t r = 0; r < runs.row(k).size(); ++r)
            loads_[runs.first(k) + r].room = runs.row(k)[r].high - runs.row(k)[r].low;
    bankRise_.assign(runs.rows(), kGentleSlope * step);
    placeRise_.assign(runs.rows(), kSteepSlope * step);
    near_.resize(runs.rows());
    for (auto* list : {&up_, &down_, &least_, &most_}) list->resize(runs.rows());
    left_.resize(entries);
    share_.resize(entries);
}

void StreamBanks::load(const StreamPaths& paths, const StreamCourse& course) {
    std::int32_t k = course.first;
    for (const std::int32_t number : paths.of(course)) {
        const double y = course.nominal(k++ * step_);
        StreamLoad& load = loads_[number];
        const bool used = load.used();
        load.low = used ? std::min(load.low, y) : y;
        load.high = used ? std::max(load.high, y) : y;
    }
}

// Finds the banks of a course: those of its runs, opening and closing at most as steeply as banks may.
void StreamBanks::bound(const StreamRuns& runs, std::span<const std::int32_t> path,
                        const StreamCourse& course) {
    const std::int32_t a = course.first, b = course.last;
    for (std::int32_t k = a; k <= b; ++k) {
        const StreamRun& here = run(runs, path, course, k);
        near_[k] = {{here.low, k}, {here.high, k}};
    }
    const auto follow = [&](std::int32_t k, std::int32_t from, double rise) {
        const Banks& other = near_[from];
        Banks& mine = near_[k];
        if (other.high.value + rise < mine.high.value) mine.high = {other.high.value + rise, other.high.from};
        if (other.low.value - rise > mine.low.value) mine.low = {other.low.value - rise, other.low.from};
    };
    for (std::int32_t k = a + 1; k <= b; ++k) follow(k, k - 1, bankRise_[k - 1]);
    for (std::int32_t k = b; k-- > a;) follow(k, k + 1, bankRise_[k]);
}

void StreamBanks::raise(std::int32_t from, std::int32_t to, double slope) {
    if (from > to) std::swap(from, to);
    for (std::int32_t k = from; k < to; ++k) bankRise_[k] = std::max(bankRise_[k], slope * step_);
}

// Lets a place that stands aside at its start or end be within the banks there.
void StreamBanks::steepen(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course) {
    if (course.rows() == 0) return;
    bound(runs, paths.of(course), course);
    for (const bool back : {true, false}) {
        const std::int32_t k = back ? course.first : course.last;
        const double d = back ? course.a().d : course.b().d;
        const Bank high = near_[k].high, low = near_[k].low;
        if (d > high.value && high.from != k)
            raise(k, high.from, (d - near_[high.from].high.value) / (std::abs(high.from - k) * step_));
        if (d < low.value && low.from != k)
            raise(k, low.from, (near_[low.from].low.value - d) / (std::abs(low.from - k) * step_));
    }
}

void StreamBanks::settle() {
    for (std::size_t k = 0; k < bankRise_.size(); ++k) placeRise_[k] = std::max(placeRise_[k], bankRise_[k]);
}

}  // namespace muster
