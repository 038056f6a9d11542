#include "lab/reproduce/experiments/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/reproduce/experiments/samples.h"

namespace muster {

void Judge::require(const std::string& criterion, const std::string& preset,
                    const std::vector<double>& values, Aggregate aggregate, Comparison comparison,
                    double threshold, const std::string& unit) {
    Verdict verdict;
    verdict.criterion = criterion;
    verdict.preset = preset;
    verdict.unit = unit;
    verdict.comparison = comparison;
    verdict.aggregate = aggregate;
    verdict.threshold = threshold;
    verdict.binding = preset == "muster";
    std::vector<double> known;
    for (const double value : values)
        if (!std::isnan(value)) known.push_back(value);
    verdict.seeds = static_cast<std::int32_t>(known.size());
    verdict.value = verdict.low = verdict.high = std::numeric_limits<double>::quiet_NaN();
    if (!known.empty()) {
        verdict.low = *std::min_element(known.begin(), known.end());
        verdict.high = *std::max_element(known.begin(), known.end());
        verdict.value = aggregate == Aggregate::Median   ? median(known)
                        : aggregate == Aggregate::Lowest ? verdict.low
                                                         : verdict.high;
    }
    const bool holds = comparison == Comparison::AtLeast ? verdict.value >= threshold
                                                         : verdict.value <= threshold;
    verdict.pass = holds && known.size() >= expected_ && !known.empty();
    verdicts_.push_back(std::move(verdict));
}

}  // namespace muster
