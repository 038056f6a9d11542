// Elementary functions that give the same bits on every machine (libm's do not), and the bits of numbers.
#pragma once

#include <cstring>
#include <type_traits>

namespace muster {

inline constexpr double kPi = 3.14159265358979323846;  ///< Half a turn [rad].

/// Sine of `angle` [rad]; absolute error under 1e-15 for |angle| < 1e6.
double sine(double angle);
/// Cosine of `angle` [rad]; absolute error under 1e-15 for |angle| < 1e6.
double cosine(double angle);
/// Angle [rad] of the vector (x, y) in (-pi, pi]; 0 for the null vector. Error under 1e-15.
double arcTangent2(double y, double x);
/// e to the power `x`, relative error under 1e-14; 0 below -745, infinity above 709.7.
double exponential(double x);
/// Natural logarithm of `x` > 0, relative error under 1e-14; minus infinity for 0.
double logarithm(double x);
/// `base` >= 0 to the power `exponent`; exact products for exponents 1, 2, 3 and 4.
double power(double base, double exponent);

/// std::bit_cast, which the standard library of Emscripten does not have yet.
template <class To, class From>
To bitCast(const From& from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> &&
                  std::is_trivially_copyable_v<From>);
    To to;
    std::memcpy(&to, &from, sizeof(To));
    return to;
}

}  // namespace muster
