// Units and people: what single characters are, and how the persons of a group differ from each other (SPEC
// B2, B10, B13, B15). The numbers of each are drawn by the world's seed.
#pragma once

#include "muster/generated/people_definitions.h"

namespace muster {

/// Adults: their free speed has the mean 1.34 m/s and the deviation 0.26 m/s (Weidmann 1993), cut off at 0.5
/// and 2.2 m/s.
PeopleDef adults();
/// The mean free speed of persons by age [m/s]: the figure of the RiMEA guideline (test 7), after Weidmann
/// 1993, linear between knots. 20 to 70 years: the middle of the ranges that JuPedSim's test of RiMEA 4.1.1
/// allows, 1.62, 1.54, 1.48, 1.41, 1.27 and 1.07 for 20, 30, 40, 50, 60 and 70 years. Children (0.75, 1.20
/// and 1.47 for 5, 10 and 15 years) and 80 years (0.70): as others have read them off the figure, where
/// readings differ by up to 0.09 at 5 years and 0.01 at 80. The figure ends there; at 90 years it is the
/// least speed of persons of reduced mobility by RiMEA's table 2, 0.46. Younger and older persons have the
/// speeds at the ends.
double walkingSpeedAtAge(double years);

}  // namespace muster
