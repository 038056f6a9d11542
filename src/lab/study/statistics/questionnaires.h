// Scores of published questionnaires.
#pragma once

#include <span>

namespace muster::statistics {

/// System Usability Scale (Brooke 1996): ten answers from 1 to 5, in its order; 0 to 100. NaN for others.
double susScore(std::span<const double> answers);
/// Raw NASA-TLX (Hart 2006): mean of six scales from 0 to 100. NaN for others.
double rawTlx(std::span<const double> answers);

/// Short User Experience Questionnaire (Schrepp, Hinderks & Thomaschewski 2017), from -3 to 3.
struct UeqShort {
    double pragmatic = 0.0;  ///< Mean of items 1 to 4.
    double hedonic = 0.0;    ///< Mean of items 5 to 8.
};
/// Eight answers from 1 to 7, in its order, coded as -3 to 3. NaN for others.
UeqShort ueqShort(std::span<const double> answers);

}  // namespace muster::statistics
