#include "lab/study/statistics/numerics.h"

#include <cmath>
#include <initializer_list>

namespace muster::statistics {
namespace {

constexpr int kTerms = 10000;
constexpr double kTiny = 1e-300, kEnough = 1e-16;

/// The continued fraction of the incomplete beta function, by Lentz's method.
double betaFraction(double a, double b, double x) {
    double c = 1.0;
    double d = 1.0 - (a + b) * x / (a + 1.0);
    d = 1.0 / (std::abs(d) < kTiny ? kTiny : d);
    double sum = d;
    for (int m = 1; m < kTerms; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        double change = 1.0;
        for (const double term : {even, odd}) {
            d = 1.0 + term * d;
            d = 1.0 / (std::abs(d) < kTiny ? kTiny : d);
            c = 1.0 + term / c;
            if (std::abs(c) < kTiny) c = kTiny;
            change = c * d;
            sum *= change;
        }
        if (std::abs(change - 1.0) < kEnough) break;
    }
    return sum;
}

/// The argument at which a rising function reaches p.
template <class Below>
double crossing(Below below, double p) {
    double low = -1.0, high = 1.0;
    while (below(low) > p && low > -1e12) low *= 2.0;
    while (below(high) < p && high < 1e12) high *= 2.0;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (below(middle) < p ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

}  // namespace

double normalBelow(double z) {
    return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

double normalQuantile(double p) {
    return crossing(normalBelow, p);
}

double incompleteBeta(double a, double b, double x) {
    if (x <= 0.0) return 0.0;
    if (x >= 1.0) return 1.0;
    const double front = std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) +
                                  b * std::log1p(-x));
    return x < (a + 1.0) / (a + b + 2.0) ? front * betaFraction(a, b, x) / a
                                         : 1.0 - front * betaFraction(b, a, 1.0 - x) / b;
}

double studentBelow(double t, double df) {
    if (!std::isfinite(df) || df > 1e7) return normalBelow(t);
    const double tail = 0.5 * incompleteBeta(0.5 * df, 0.5, df / (df + t * t));
    return t > 0.0 ? 1.0 - tail : tail;
}

double studentQuantile(double p, double df) {
    return crossing([df](double t) { return studentBelow(t, df); }, p);
}

}  // namespace muster::statistics
