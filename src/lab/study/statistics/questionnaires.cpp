#include "lab/study/statistics/describe.h"

#include <cstddef>
#include <limits>

namespace muster::statistics {
namespace {

constexpr double kNoScore = std::numeric_limits<double>::quiet_NaN();

bool fits(std::span<const double> answers, std::size_t count, double low, double high) {
    if (answers.size() != count) return false;
    for (const double answer : answers)
        if (!(answer >= low && answer <= high)) return false;
    return true;
}

}  // namespace

double susScore(std::span<const double> answers) {
    if (!fits(answers, 10, 1.0, 5.0)) return kNoScore;
    double sum = 0.0;
    for (std::size_t i = 0; i < 10; ++i) sum += i % 2 == 0 ? answers[i] - 1.0 : 5.0 - answers[i];
    return 2.5 * sum;
}

double rawTlx(std::span<const double> answers) {
    if (!fits(answers, 6, 0.0, 100.0)) return kNoScore;
    double sum = 0.0;
    for (const double answer : answers) sum += answer;
    return sum / 6.0;
}

UeqShort ueqShort(std::span<const double> answers) {
    if (!fits(answers, 8, 1.0, 7.0)) return {kNoScore, kNoScore};
    UeqShort score;
    for (std::size_t i = 0; i < 8; ++i)
        (i < 4 ? score.pragmatic : score.hedonic) += 0.25 * (answers[i] - 4.0);
    return score;
}

}  // namespace muster::statistics
