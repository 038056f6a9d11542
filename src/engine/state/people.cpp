#include "muster/people.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/maths.h"

namespace muster {
namespace {

// The standard normal distribution: Abramowitz and Stegun 26.2.23 as the first guess, then Newton's method on
// the error function by its continued fraction and its series.
double normalShareBelow(double x) {
    const double y = std::fabs(x);
    const double density = exponential(-0.5 * y * y) / std::sqrt(2.0 * kPi);
    double tail = 0.0;
    if (y < 3.0) {
        double term = y, sum = y;
        for (int k = 1; k < 60; ++k) sum += term *= y * y / (2 * k + 1);
        tail = 0.5 - density * sum;
    } else {
        double fraction = y;
        for (int k = 40; k > 0; --k) fraction = y + k / fraction;
        tail = density / fraction;
    }
    return x > 0.0 ? 1.0 - tail : tail;
}

double normalQuantile(double p) {
    const double q = std::min(p, 1.0 - p);
    const double t = std::sqrt(-2.0 * logarithm(q));
    double x = t - (2.515517 + t * (0.802853 + t * 0.010328)) /
                       (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    for (int k = 0; k < 4; ++k)
        x += (normalShareBelow(-x) - q) * std::sqrt(2.0 * kPi) * exponential(0.5 * x * x);
    return p < 0.5 ? -x : x;
}

// The logarithm of the gamma function (Lanczos, g = 7, 9 terms), x > 0.
double logGamma(double x) {
    constexpr double kTerms[] = {676.5203681218851,     -1259.1392167224028,  771.32342877765313,
                                 -176.61502916214059,   12.507343278686905,   -0.13857109526572012,
                                 9.9843695780195716e-6, 1.5056327351493116e-7};
    if (x < 0.5) return logarithm(kPi / sine(kPi * x)) - logGamma(1.0 - x);
    double sum = 0.99999999999980993;
    for (std::size_t k = 0; k < std::size(kTerms); ++k) sum += kTerms[k] / (x + static_cast<double>(k));
    const double t = x + 6.5;
    return 0.5 * logarithm(2.0 * kPi) + (x - 0.5) * logarithm(t) - t + logarithm(sum);
}

// The regularised lower incomplete gamma function: by its series, or its continued fraction (Lentz).
double gammaShareBelow(double shape, double x) {
    constexpr int kMostTerms = 2000;  // About seven times the root of the shape are needed.
    if (x <= 0.0) return 0.0;
    const double front = exponential(shape * logarithm(x) - x - logGamma(shape));
    if (x < shape + 1.0) {
        double term = 1.0 / shape, sum = term;
        for (int k = 1; k < kMostTerms && term > 1e-16 * sum; ++k) sum += term *= x / (shape + k);
        return front * sum;
    }
    double b = x + 1.0 - shape, c = 1e300, d = 1.0 / b, h = d;
    for (int k = 1; k < kMostTerms; ++k) {
        const double a = -k * (k - shape);
        b += 2.0;
        d = 1.0 / (a * d + b);
        c = b + a / c;
        const double change = d * c;
        h *= change;
        if (std::fabs(change - 1.0) < 1e-15) break;
    }
    return 1.0 - front * h;
}

// Newton's method on the logarithm of x, which it knows to lie between two bounds, from the first guess of
// Wilson and Hilferty (1931); for small shapes, where that has none, from the first term of the series.
double gammaQuantile(double shape, double p) {
    const double cube = 1.0 - 1.0 / (9.0 * shape) + normalQuantile(p) / (3.0 * std::sqrt(shape));
    double at = cube > 0.2 ? logarithm(shape) + 3.0 * logarithm(cube)
                           : (logarithm(p * shape) + logGamma(shape)) / shape;
    double low = -700.0, high = logarithm(shape + 1.0) + 50.0;
    at = std::clamp(at, low, high);
    for (int k = 0; k < 200 && high - low > 1e-15 * std::fabs(at); ++k) {
        const double x = exponential(at), error = gammaShareBelow(shape, x) - p;
        (error < 0.0 ? low : high) = at;
        const double slope = exponential(shape * at - x - logGamma(shape));
        double next = slope > 0.0 ? at - error / slope : low;
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        const double change = std::fabs(next - at);
        at = next;
        if (change < 1e-15) break;
    }
    return exponential(at);
}

double freeQuantile(const Distribution& drawn, double p) {
    switch (drawn.spread) {
        case Spread::Constant:
            return drawn.a;
        case Spread::Uniform:
            return drawn.a + (drawn.b - drawn.a) * p;
        case Spread::Normal:
            return drawn.a + drawn.b * normalQuantile(p);
        case Spread::LogNormal:
            return exponential(drawn.a + drawn.b * normalQuantile(p));
        case Spread::Gamma:
            return drawn.b * gammaQuantile(drawn.a, p);
        case Spread::Weibull:
            return drawn.a * power(-logarithm(1.0 - p), 1.0 / drawn.b);
    }
    return drawn.a;
}

double shareBelow(const Distribution& drawn, double x) {
    switch (drawn.spread) {
        case Spread::Constant:
            return x < drawn.a ? 0.0 : 1.0;
        case Spread::Uniform:
            return drawn.b > drawn.a ? std::clamp((x - drawn.a) / (drawn.b - drawn.a), 0.0, 1.0)
                                     : (x < drawn.a ? 0.0 : 1.0);
        case Spread::Normal:
            return drawn.b > 0.0 ? normalShareBelow((x - drawn.a) / drawn.b) : (x < drawn.a ? 0.0 : 1.0);
        case Spread::LogNormal:
            if (x <= 0.0) return 0.0;
            return drawn.b > 0.0 ? normalShareBelow((logarithm(x) - drawn.a) / drawn.b)
                                 : (logarithm(x) < drawn.a ? 0.0 : 1.0);
        case Spread::Gamma:
            return gammaShareBelow(drawn.a, x / drawn.b);
        case Spread::Weibull:
            return x <= 0.0 ? 0.0 : 1.0 - exponential(-power(x / drawn.a, drawn.b));
    }
    return 0.0;
}

}  // namespace

Distribution Distribution::normal(double mean, double deviation, double least, double most) {
    return {Spread::Normal, mean, deviation, least, most};
}

double Distribution::quantile(double p) const {
    constexpr double kEnd = 1e-12;
    if (spread == Spread::Constant) return a;
    const double low = shareBelow(*this, least), high = shareBelow(*this, most);
    const double inside = std::clamp(low + (high - low) * p, kEnd, 1.0 - kEnd);
    return std::clamp(freeQuantile(*this, inside), least, most);
}

PeopleDef adults() {
    PeopleDef people;
    people.name = "Adults";
    people.speed = Distribution::normal(1.34, 0.26, 0.5, 2.2);
    return people;
}

double walkingSpeedAtAge(double years) {
    struct Knot {
        double age, speed;
    };
    constexpr Knot kKnots[] = {{5, 0.75},  {10, 1.20}, {15, 1.47}, {20, 1.62}, {30, 1.54}, {40, 1.48},
                               {50, 1.41}, {60, 1.27}, {70, 1.07}, {80, 0.70}, {90, 0.46}};
    if (years <= kKnots[0].age) return kKnots[0].speed;
    for (std::size_t k = 1; k < std::size(kKnots); ++k) {
        const Knot &a = kKnots[k - 1], &b = kKnots[k];
        if (years <= b.age) return a.speed + (b.speed - a.speed) * (years - a.age) / (b.age - a.age);
    }
    return std::end(kKnots)[-1].speed;
}

}  // namespace muster
