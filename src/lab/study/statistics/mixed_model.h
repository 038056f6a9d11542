// The main analysis of people's times: a linear mixed model.
#pragma once

#include <cstdint>
#include <vector>

#include "lab/study/statistics/describe.h"
#include "muster/status.h"

namespace muster::statistics {

/// One trial.
struct MixedRow {
    double logTime = 0.0;          ///< Logarithm of its time; finite.
    std::int32_t environment = 0;  ///< Number of its environment, from 0.
    bool touch = false;            ///< True for touch, false for mouse.
    double period = 0.0;           ///< Block of its control, 1 or 2.
    double order = 0.0;            ///< 1 for persons that began with touch, else 0.
    std::int32_t person = 0;       ///< Number of the person, from 0.
    std::int32_t layout = 0;       ///< Number of the layout of items, from 0.
};

/// The effect of touch in one environment.
struct MixedEffect {
    std::int32_t environment = 0;  ///< Number of the environment.
    double estimate = 0.0;         ///< Difference of log times, touch less mouse.
    double error = 0.0;            ///< Standard error of the estimate.
    double df = 0.0;               ///< Degrees of freedom after Satterthwaite.
    double p = 1.0;                ///< Two-sided p, not adjusted.
    double holm = 1.0;             ///< The p adjusted over the environments by Holm.
    Estimate ratio;  ///< Ratio of the geometric means, touch over mouse, with the 95 % interval.
};

/// A fitted model.
struct MixedModel {
    /// Effects by environment; environments without both controls are left out.
    std::vector<MixedEffect> effects;
    double criterion = 0.0;    ///< REML criterion, -2 log likelihood.
    double residual = 0.0;     ///< Standard deviation of the residuals.
    double person = 0.0;       ///< Standard deviation of persons.
    double slope = 0.0;        ///< Standard deviation of persons' own effects of the control.
    double correlation = 0.0;  ///< Correlation of these two; 0 where one of them is 0.
    double layout = 0.0;       ///< Standard deviation of layouts.
    std::int32_t people = 0;   ///< Number of persons.
    std::int32_t trials = 0;   ///< Number of trials.
};

/// Fits log time ~ environment + control : environment + period + order + (1 + control | person) + (1 |
/// layout) by restricted maximum likelihood, as Bates et al. (2015, Journal of Statistical Software 67(1))
/// profile it; the optimiser is Nelder & Mead's simplex (1965). Period and order are left out where they say
/// nothing of their own. Degrees of freedom as Kuznetsova et al. (2017, ibid. 82(13)). Fails with
/// InvalidArgument where there are fewer than two people, too few trials, or no environment with both
/// controls.
Result<MixedModel> fitMixedModel(const std::vector<MixedRow>& rows);

}  // namespace muster::statistics
