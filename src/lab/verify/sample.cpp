#include "lab/verify/sample.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muster {

void VerifySamples::add(const std::string& variant, VerifySample sample) {
    runs_[variant].push_back(std::move(sample));
}

const std::vector<VerifySample>& VerifySamples::runs(const std::string& variant) const {
    static const std::vector<VerifySample> none;
    const auto at = runs_.find(variant);
    return at == runs_.end() ? none : at->second;
}

std::vector<double> VerifySamples::values(const std::string& variant, const std::string& figure) const {
    std::vector<double> values;
    for (const VerifySample& run : runs(variant)) {
        const auto at = run.figures.find(figure);
        values.push_back(at == run.figures.end() ? kUnmeasured : at->second);
    }
    return values;
}

double VerifySamples::mean(const std::string& variant, const std::string& figure) const {
    const auto all = values(variant, figure);
    double sum = all.empty() ? kUnmeasured : 0.0;
    for (const double value : all) sum += value;
    return sum / static_cast<double>(std::max<std::size_t>(all.size(), 1));
}

double VerifySamples::least(const std::string& variant, const std::string& figure) const {
    const auto all = values(variant, figure);
    if (!std::isfinite(mean(variant, figure))) return kUnmeasured;
    return *std::min_element(all.begin(), all.end());
}

double VerifySamples::most(const std::string& variant, const std::string& figure) const {
    const auto all = values(variant, figure);
    if (!std::isfinite(mean(variant, figure))) return kUnmeasured;
    return *std::max_element(all.begin(), all.end());
}

std::vector<Vec2> VerifySamples::points(const std::string& variant, const std::string& curve) const {
    std::vector<Vec2> all;
    for (const VerifySample& run : runs(variant)) {
        const auto at = run.curves.find(curve);
        if (at != run.curves.end()) all.insert(all.end(), at->second.begin(), at->second.end());
    }
    return all;
}

}  // namespace muster
