// The flow of people through a metre of a passage, by the law of headway that they walk by.
#pragma once

#include "muster/generated/parameters.h"

namespace muster {

/// Flow of characters per metre of clear width, at full travel speed [1/(s m)]: files stand one and a half
/// bodies apart, and in a file each character keeps its headway, out of step, at top speed. For units 4.5,
/// for people 1.3, where doors of 0.8 to 3 m were measured at 1.5: docs/people.md.
inline double specificFlow(const Parameters::Character& usual) {
    constexpr double kFiles = 1.5;          // Distance between files [bodies].
    constexpr double kMargin = 5.0 / 54.0;  // Distance between standing bodies [m]; with it units have 4.5.
    const double body = 2.0 * usual.radius, v = usual.maxSpeed;
    const double file = body + kMargin + (1.0 - usual.inStep) * usual.headway * v;
    return v / (kFiles * body * file);
}

}  // namespace muster
