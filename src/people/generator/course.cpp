#include "people/generator/course.h"

#include "base/maths.h"

namespace muster::generator {

Vec3 toGround(const Placement& place, Vec3 p) {
    const double c = cosine(place.yaw), s = sine(place.yaw);
    return {static_cast<float>(place.x + c * p.x - s * p.y), static_cast<float>(place.y + s * p.x + c * p.y),
            p.z};
}

Vec3 fromGround(const Placement& place, Vec3 p) {
    const double c = cosine(place.yaw), s = sine(place.yaw), x = p.x - place.x, y = p.y - place.y;
    return {static_cast<float>(c * x + s * y), static_cast<float>(c * y - s * x), p.z};
}

std::function<Placement(double)> straight(std::function<double(double)> x) {
    return [x = std::move(x)](double time) { return Placement{x(time), 0.0, 0.0}; };
}

}  // namespace muster::generator
