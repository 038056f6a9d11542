#include "character/generator/course.h"

namespace muster::generator {

Vec3 toGround(const Place& place, Vec3 p) {
    const double c = cosine(place.yaw), s = sine(place.yaw);
    return {static_cast<float>(place.x + c * p.x - s * p.y), static_cast<float>(place.y + s * p.x + c * p.y),
            p.z};
}

Vec3 fromGround(const Place& place, Vec3 p) {
    const double c = cosine(place.yaw), s = sine(place.yaw), x = p.x - place.x, y = p.y - place.y;
    return {static_cast<float>(c * x + s * y), static_cast<float>(c * y - s * x), p.z};
}

std::function<Place(double)> straight(std::function<double(double)> x) {
    return [x = std::move(x)](double time) { return Place{x(time), 0.0, 0.0}; };
}

}  // namespace muster::generator
