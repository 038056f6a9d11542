#include "engine/orders/stream_banks.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kBankSlope = 0.35;  // Of banks, where there is room for it.
constexpr double
    kSteepBank = 0.7;  // Up to that they are steeper where they would leave less room than there is.
constexpr double kSteepPlace = 1.0;  // ... and so steeply where runs want it; more only where they must.
constexpr double kHair = 1e-6;       // Nobody sees less [m].

}  // namespace

void StreamBanks::start(const StreamRuns& runs, double step, std::int32_t entries) {
    step_ = step;
    loads_.assign(runs.count(), {});
    for (std::int32_t k = 0; k < runs.rows(); ++k)
        for (std::size_t r = 0; r < runs.row(k).size(); ++r)
            loads_[runs.first(k) + r].room = runs.row(k)[r].high - runs.row(k)[r].low;
    bankRise_.assign(runs.rows(), kBankSlope * step);
    placeRise_.assign(runs.rows(), kSteepPlace * step);
    near_.resize(runs.rows());
    felt_.resize(runs.rows());
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

// From row to row, forwards and backwards, banks open and close no faster than they may.
void StreamBanks::limitSlopes(std::vector<Banks>& banks, std::int32_t first, std::int32_t last) const {
    const auto follow = [&](std::int32_t k, std::int32_t from, double rise) {
        const Banks& other = banks[from];
        Banks& mine = banks[k];
        if (other.high.value + rise < mine.high.value) mine.high = {other.high.value + rise, other.high.from};
        if (other.low.value - rise > mine.low.value) mine.low = {other.low.value - rise, other.low.from};
    };
    for (std::int32_t k = first + 1; k <= last; ++k) follow(k, k - 1, bankRise_[k - 1]);
    for (std::int32_t k = last; k-- > first;) follow(k, k + 1, bankRise_[k]);
}

// The banks of a course: those of its runs, which open and close at most as steeply as banks may.
void StreamBanks::bound(const StreamRuns& runs, std::span<const std::int32_t> path,
                        const StreamCourse& course) {
    const std::int32_t a = course.first, b = course.last;
    for (std::int32_t k = a; k <= b; ++k) {
        const StreamRun& here = run(runs, path, course, k);
        near_[k] = {{here.low, k}, {here.high, k}};
    }
    limitSlopes(near_, a, b);
}

// The same, less what stands between the course and the bank: that moves it most.
void StreamBanks::feel(const StreamRuns& runs, std::span<const std::int32_t> path,
                       const StreamCourse& course) {
    const std::int32_t a = course.first, b = course.last;
    for (std::int32_t k = a; k <= b; ++k) {
        const StreamRun& here = run(runs, path, course, k);
        const StreamLoad& load = loads_[path[k - a]];
        felt_[k] = {{here.low - load.low, k}, {here.high - load.high, k}};
    }
    limitSlopes(felt_, a, b);
    for (std::int32_t k = a; k <= b; ++k) {
        felt_[k].low.value += loads_[path[felt_[k].low.from - a]].low;
        felt_[k].high.value += loads_[path[felt_[k].high.from - a]].high;
    }
}

void StreamBanks::raise(std::vector<double>& rise, std::int32_t from, std::int32_t to, double slope) {
    if (from > to) std::swap(from, to);
    for (std::int32_t k = from; k < to; ++k) rise[k] = std::max(rise[k], slope * step_);
}

// Who stands aside at its start or end is within the banks there.
void StreamBanks::steepenEnds(const StreamCourse& course) {
    for (const bool back : {true, false}) {
        const std::int32_t k = back ? course.first : course.last;
        const double d = back ? course.a().d : course.b().d;
        const Bank high = near_[k].high, low = near_[k].low;
        if (d > high.value + kHair && high.from != k)
            raise(bankRise_, k, high.from,
                  (d - near_[high.from].high.value) / (std::abs(high.from - k) * step_));
        if (d < low.value - kHair && low.from != k)
            raise(bankRise_, k, low.from, (near_[low.from].low.value - d) / (std::abs(low.from - k) * step_));
    }
}

// Banks that come from both sides leave as much room between them as the runs have that they come from.
void StreamBanks::steepenWidths(std::span<const std::int32_t> path, const StreamCourse& course) {
    for (std::int32_t k = course.first; k <= course.last; ++k) {
        const Bank low = near_[k].low, high = near_[k].high;
        if (low.from == high.from) continue;
        const StreamLoad& load = loads_[path[k - course.first]];
        const double wanted = std::min({loads_[path[low.from - course.first]].room,
                                        loads_[path[high.from - course.first]].room, load.high - load.low});
        const double missing = wanted - (high.value - low.value);
        if (missing <= kHair) continue;
        const double span = (std::abs(low.from - k) + std::abs(high.from - k)) * step_;
        const double now = wanted - missing - (near_[high.from].high.value - near_[low.from].low.value);
        const double slope = std::max(std::min(kSteepBank, (now + missing) / span),
                                      (now + missing - wanted) / span);
        raise(bankRise_, k, low.from, slope);
        raise(bankRise_, k, high.from, slope);
    }
}

// A place reaches every run of its path from every other.
void StreamBanks::steepenPlaces(const StreamRuns& runs, std::span<const std::int32_t> path,
                                const StreamCourse& course) {
    double most = course.a().d, least = course.a().d;
    std::int32_t mostFrom = course.first, leastFrom = course.first;
    for (std::int32_t k = course.first; k <= course.last; ++k) {
        const double rise = k == course.first ? 0.5 * step_ * kSteepPlace : placeRise_[k - 1];
        const StreamRun& here = run(runs, path, course, k);
        most += rise;
        least -= rise;
        if (here.low > most && k > course.first) {
            raise(placeRise_, mostFrom, k, kSteepPlace + (here.low - most) / ((k - mostFrom) * step_));
            most = here.low;
        }
        if (here.high < least && k > course.first) {
            raise(placeRise_, leastFrom, k, kSteepPlace + (least - here.high) / ((k - leastFrom) * step_));
            least = here.high;
        }
        if (here.high <= most) {
            most = here.high;
            mostFrom = k;
        }
        if (here.low >= least) {
            least = here.low;
            leastFrom = k;
        }
        most = std::max(most, least);
    }
}

void StreamBanks::steepen(const StreamRuns& runs, const StreamPaths& paths, const StreamCourse& course) {
    if (course.rows() == 0) return;
    const std::span<const std::int32_t> path = paths.of(course);
    bound(runs, path, course);
    steepenEnds(course);
    steepenWidths(path, course);
    steepenPlaces(runs, path, course);
}

void StreamBanks::settle() {
    for (std::size_t k = 0; k < bankRise_.size(); ++k) placeRise_[k] = std::max(placeRise_[k], bankRise_[k]);
}

}  // namespace muster
