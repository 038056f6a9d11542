// Points and directions in space, in single precision: poses, meshes, export.
#pragma once

#include <cmath>

namespace muster {

/// A point or vector in space [m]. In the world x right, y forward, z up; in body axes x forward,
/// y left, z up.
struct Vec3 {
    float x = 0.0f;
    float y = 0.0f;
    float z = 0.0f;

    /// Exact comparison, bit for bit apart from the sign of zero.
    friend bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec3 operator-(Vec3 a, Vec3 b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec3 operator-(Vec3 a) {
    return {-a.x, -a.y, -a.z};
}
constexpr Vec3 operator*(Vec3 a, float s) {
    return {a.x * s, a.y * s, a.z * s};
}
constexpr Vec3 operator*(float s, Vec3 a) {
    return a * s;
}
constexpr Vec3& operator+=(Vec3& a, Vec3 b) {
    return a = a + b;
}
constexpr Vec3& operator-=(Vec3& a, Vec3 b) {
    return a = a - b;
}
constexpr Vec3& operator*=(Vec3& a, float s) {
    return a = a * s;
}

/// Scalar product.
constexpr float dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Vector product: at right angles to both, right-handed.
constexpr Vec3 cross(Vec3 a, Vec3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Squared length [m^2].
constexpr float lengthSquared(Vec3 a) {
    return dot(a, a);
}
/// Length [m].
inline float length(Vec3 a) {
    return std::sqrt(dot(a, a));
}
/// Distance between two points [m].
inline float distance(Vec3 a, Vec3 b) {
    return length(b - a);
}
/// The unit vector along `a`, or `fallback` where `a` is shorter than 1e-9 m.
inline Vec3 normalized(Vec3 a, Vec3 fallback = {}) {
    const float l = length(a);
    return l > 1e-9f ? a * (1.0f / l) : fallback;
}
/// The point at share `t` of the distance from `a` to `b`.
constexpr Vec3 lerp(Vec3 a, Vec3 b, float t) {
    return a + (b - a) * t;
}
/// True where all coordinates are finite numbers.
inline bool isFinite(Vec3 a) {
    return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace muster
