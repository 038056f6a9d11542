// How many people a metre of a passage lets through, by the law of headway that they walk by.
#pragma once

#include "muster/parameters.h"

namespace muster {

/// Characters that pass in a second, per metre of clear width, at full travel speed [1/(s m)]: files stand
/// one and a half bodies apart, and in a file each keeps its headway, out of step, at top speed. For
/// units 4.5, for people 1.3, where doors of 0.8 to 3 m were measured at 1.5: docs/people.md.
inline double specificFlow(const Parameters::Character& usual) {
    constexpr double kFiles = 1.5;          // Distance between files, in bodies.
    constexpr double kMargin = 5.0 / 54.0;  // Kept between bodies that stand [m]; so units have 4.5.
    const double body = 2.0 * usual.radius, v = usual.maxSpeed;
    const double file = body + kMargin + (1.0 - usual.inStep) * usual.headway * v;
    return v / (kFiles * body * file);
}

}  // namespace muster
