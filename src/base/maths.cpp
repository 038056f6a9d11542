#include "base/maths.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace muster {
namespace {

// pi/2 in three parts for Cody-Waite reduction: the first two have trailing zero bits, so that
// multiples of them by a small whole number are exact.
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiMiddle = 6.07710050630396597660e-11;
constexpr double kHalfPiLow = 2.02226624879595063154e-21;

// Taylor series of sine and cosine on [-pi/4, pi/4]; the first term left out is below 1e-17.
double sineKernel(double x) {
    const double z = x * x;
    double sum = -1.0 / 1307674368000.0;
    sum = 1.0 / 6227020800.0 + z * sum;
    sum = -1.0 / 39916800.0 + z * sum;
    sum = 1.0 / 362880.0 + z * sum;
    sum = -1.0 / 5040.0 + z * sum;
    sum = 1.0 / 120.0 + z * sum;
    sum = -1.0 / 6.0 + z * sum;
    return x + x * z * sum;
}

double cosineKernel(double x) {
    const double z = x * x;
    double sum = 1.0 / 20922789888000.0;
    sum = -1.0 / 87178291200.0 + z * sum;
    sum = 1.0 / 479001600.0 + z * sum;
    sum = -1.0 / 3628800.0 + z * sum;
    sum = 1.0 / 40320.0 + z * sum;
    sum = -1.0 / 720.0 + z * sum;
    sum = 1.0 / 24.0 + z * sum;
    sum = -0.5 + z * sum;
    return 1.0 + z * sum;
}

// Reduces to [-pi/4, pi/4]; returns the quadrant 0 to 3.
int reduce(double angle, double& rest) {
    if (!(std::fabs(angle) < 1e9)) {
        rest = 0.0;
        return 0;
    }
    const double turns = std::floor(angle * (2.0 / kPi) + 0.5);
    rest = ((angle - turns * kHalfPiHigh) - turns * kHalfPiMiddle) - turns * kHalfPiLow;
    return static_cast<int>(static_cast<std::int64_t>(turns) & 3);
}

// Arc tangent on [0, tan(pi/16)] by its series.
double arcTangentSeries(double x) {
    const double z = x * x;
    double sum = 0.0;
    for (int k = 25; k >= 1; k -= 2) sum = (((k / 2) % 2 == 0) ? 1.0 : -1.0) / k + z * sum;
    return x * sum;
}

// Arc tangent on [0, 1]: shifted by the nearest of 0, pi/8 and pi/4.
double arcTangentUnit(double x) {
    constexpr double kTanPi16 = 0.19891236737965800691;
    constexpr double kTanPi8 = 0.41421356237309504880;
    constexpr double kTan3Pi16 = 0.66817863791929891999;
    if (x <= kTanPi16) return arcTangentSeries(x);
    if (x <= kTan3Pi16) {
        const double shifted = (x - kTanPi8) / (1.0 + x * kTanPi8);
        return kPi / 8.0 + arcTangentSeries(shifted);
    }
    return kPi / 4.0 + arcTangentSeries((x - 1.0) / (1.0 + x));
}

}  // namespace

double sine(double angle) {
    double rest = 0.0;
    switch (reduce(angle, rest)) {
        case 0:
            return sineKernel(rest);
        case 1:
            return cosineKernel(rest);
        case 2:
            return -sineKernel(rest);
        default:
            return -cosineKernel(rest);
    }
}

double cosine(double angle) {
    double rest = 0.0;
    switch (reduce(angle, rest)) {
        case 0:
            return cosineKernel(rest);
        case 1:
            return -sineKernel(rest);
        case 2:
            return -cosineKernel(rest);
        default:
            return sineKernel(rest);
    }
}

double arcTangent2(double y, double x) {
    const double ax = std::fabs(x);
    const double ay = std::fabs(y);
    if (ax == 0.0 && ay == 0.0) return 0.0;
    double angle = ay <= ax ? arcTangentUnit(ay / ax) : kPi / 2.0 - arcTangentUnit(ax / ay);
    if (x < 0.0) angle = kPi - angle;
    return y < 0.0 ? -angle : angle;
}

double exponential(double x) {
    if (x != x) return x;
    if (x > 709.7) return std::numeric_limits<double>::infinity();
    if (x < -745.0) return 0.0;
    constexpr double kLn2High = 6.93147180369123816490e-01;
    constexpr double kLn2Low = 1.90821492927058770002e-10;
    const double n = std::floor(x / 0.69314718055994530942 + 0.5);
    const double rest = (x - n * kLn2High) - n * kLn2Low;
    double sum = 1.0;
    for (int k = 14; k >= 1; --k) sum = 1.0 + rest * sum / k;
    // Two factors, so that neither leaves the range of normal numbers.
    const auto whole = static_cast<std::int64_t>(n);
    const std::int64_t half = whole / 2;
    const auto scale = [](std::int64_t e) {
        return bitCast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
    };
    return sum * scale(half) * scale(whole - half);
}

double logarithm(double x) {
    if (x != x || x < 0.0) return std::numeric_limits<double>::quiet_NaN();
    if (x == 0.0) return -std::numeric_limits<double>::infinity();
    if (x == std::numeric_limits<double>::infinity()) return x;
    std::int64_t exponent = 0;
    if (x < 2.2250738585072014e-308) {
        x *= 18014398509481984.0;  // 2^54
        exponent -= 54;
    }
    const auto bits = bitCast<std::uint64_t>(x);
    exponent += static_cast<std::int64_t>((bits >> 52) & 0x7ff) - 1023;
    double mantissa = bitCast<double>((bits & 0x000fffffffffffffull) | 0x3ff0000000000000ull);
    if (mantissa > 1.41421356237309504880) {
        mantissa *= 0.5;
        exponent += 1;
    }
    // ln m = 2 artanh(s), s = (m - 1) / (m + 1), |s| < 0.172.
    const double s = (mantissa - 1.0) / (mantissa + 1.0);
    const double z = s * s;
    double sum = 0.0;
    for (int k = 23; k >= 1; k -= 2) sum = 1.0 / k + z * sum;
    return static_cast<double>(exponent) * 0.69314718055994530942 + 2.0 * s * sum;
}

double power(double base, double exponent) {
    if (exponent == 1.0) return base;
    if (exponent == 2.0) return base * base;
    if (exponent == 3.0) return base * base * base;
    if (exponent == 4.0) return (base * base) * (base * base);
    if (exponent == 0.0) return 1.0;
    if (base == 0.0) return exponent > 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
    return exponential(exponent * logarithm(base));
}

}  // namespace muster
