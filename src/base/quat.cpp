#include "muster/quat.h"

#include "base/maths.h"

namespace muster {

Quat axisAngle(Vec3 axis, double angle) {
    const float s = static_cast<float>(sine(0.5 * angle));
    return {axis.x * s, axis.y * s, axis.z * s, static_cast<float>(cosine(0.5 * angle))};
}

double angleBetween(Quat a, Quat b) {
    const Quat d = normalized(conjugate(a) * b);
    const double sine2 = std::sqrt(static_cast<double>(d.x) * d.x + static_cast<double>(d.y) * d.y +
                                   static_cast<double>(d.z) * d.z);
    return 2.0 * arcTangent2(sine2, std::fabs(static_cast<double>(d.w)));
}

}  // namespace muster
