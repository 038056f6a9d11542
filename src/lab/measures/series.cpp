#include "lab/measures/series.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

/// Number of values to leave out at the beginning, at most a half.
std::size_t leftOut(std::span<const double> values) {
    const std::size_t count = values.size();
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity(), sum = 0.0, squares = 0.0;
    // Values are taken from the back, about their last one, so that no digits are lost.
    const double about = values[count - 1];
    for (std::size_t k = count; k-- > 0;) {
        const double v = values[k] - about;
        sum += v;
        squares += v * v;
        const double n = static_cast<double>(count - k);
        if (k > count / 2) continue;
        const double error = std::max(0.0, squares - sum * sum / n) / (n * n);
        if (error <= least) {
            least = error;
            best = k;
        }
    }
    return best;
}

}  // namespace

MeanAndDeviation meanOf(std::span<const double> values) {
    if (values.empty()) return {kUnmeasured, kUnmeasured};
    double sum = 0.0, squares = 0.0;
    for (const double v : values) sum += v;
    const double mean = sum / static_cast<double>(values.size());
    for (const double v : values) squares += (v - mean) * (v - mean);
    return {mean, std::sqrt(squares / static_cast<double>(values.size()))};
}

SteadyState steadyState(std::span<const double> values) {
    if (values.size() < 2) return {0, values.size(), meanOf(values).mean};
    std::size_t begin = 0, end = values.size(), before = 0;
    // A cut at one side changes the best cut at the other side.
    do {
        before = end - begin;
        begin += leftOut(values.subspan(begin, end - begin));
        const std::vector<double> back(values.rbegin() + static_cast<std::ptrdiff_t>(values.size() - end),
                                       values.rend() - static_cast<std::ptrdiff_t>(begin));
        end -= leftOut(back);
    } while (end - begin < before);
    return {begin, end, meanOf(values.subspan(begin, end - begin)).mean};
}

std::size_t firstReaching(std::span<const double> values, double value) {
    return std::find_if(values.begin(), values.end(), [value](double v) { return v >= value; }) -
           values.begin();
}

std::vector<double> smoothed(std::span<const double> values, std::size_t width) {
    std::vector<double> means;
    const std::size_t half = width / 2;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::size_t reach = std::min({half, i, values.size() - 1 - i});
        means.push_back(meanOf(values.subspan(i - reach, 2 * reach + 1)).mean);
    }
    return means;
}

std::vector<FileHeadway> headways(const Trajectories& trajectories, double period, bool backwards) {
    std::vector<FileHeadway> found;
    const Sighting* first = trajectories.all().data();
    std::vector<const Sighting*> file;
    for (std::int32_t f = 0; f < trajectories.frameCount(); ++f) {
        file.clear();
        for (const Sighting& s : trajectories.frame(f)) file.push_back(&s);
        std::sort(file.begin(), file.end(), [&](const Sighting* a, const Sighting* b) {
            return backwards ? a->position.x > b->position.x : a->position.x < b->position.x;
        });
        for (std::size_t k = 0; k < file.size(); ++k) {
            const bool last = k + 1 == file.size();
            if (last && (period <= 0.0 || file.size() < 2)) continue;
            const Sighting& ahead = *file[last ? 0 : k + 1];
            const double apart = std::abs(ahead.position.x - file[k]->position.x);
            found.push_back(
                {static_cast<std::size_t>(file[k] - first), ahead.id, last ? period - apart : apart});
        }
    }
    return found;
}

}  // namespace muster
