#include "lab/reproduce/experiments/samples.h"

#include <algorithm>
#include <cmath>

namespace muster {
void Samples::add(const std::string& arm, const std::string& preset, RunSample sample) {
    runs_[{arm, preset}].push_back(std::move(sample));
}

const std::vector<RunSample>& Samples::runs(const std::string& arm, const std::string& preset) const {
    static const std::vector<RunSample> kNone;
    const auto found = runs_.find({arm, preset});
    return found == runs_.end() ? kNone : found->second;
}

std::vector<double> Samples::values(const std::string& arm, const std::string& preset,
                                    const std::string& figure) const {
    std::vector<double> values;
    for (const RunSample& run : runs(arm, preset)) {
        const auto found = run.figures.find(figure);
        if (found != run.figures.end() && !std::isnan(found->second)) values.push_back(found->second);
    }
    return values;
}

std::size_t Samples::seeds() const {
    std::size_t most = 0;
    for (const auto& [arm, runs] : runs_) most = std::max(most, runs.size());
    return most;
}

double median(std::vector<double> values) {
    if (values.empty()) return kNothing;
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

std::vector<double> ratios(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> result;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        result.push_back(b[i] != 0.0 ? a[i] / b[i] : kNothing);
    return result;
}

}  // namespace muster
