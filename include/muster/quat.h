// Rotations in space as unit quaternions, in single precision. Only + - * / and sqrt at run time.
#pragma once

#include <cmath>

#include "muster/vec3.h"

namespace muster {

/// A rotation in space: a unit quaternion. q and -q are the same rotation.
struct Quat {
    float x = 0.0f;
    float y = 0.0f;
    float z = 0.0f;
    float w = 1.0f;

    /// Exact comparison of the components: q and -q differ.
    friend bool operator==(const Quat&, const Quat&) = default;
};

/// Composition: rotates by `b` first, then by `a`.
constexpr Quat operator*(Quat a, Quat b) {
    return {a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
            a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z};
}
/// All components negated, which is the same rotation.
constexpr Quat operator-(Quat q) {
    return {-q.x, -q.y, -q.z, -q.w};
}
/// The conjugate, which is the inverse rotation.
constexpr Quat conjugate(Quat q) {
    return {-q.x, -q.y, -q.z, q.w};
}
/// Four-dimensional scalar product: the cosine of half the angle between two rotations, up to sign.
constexpr float dot(Quat a, Quat b) {
    return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
}
/// `q` scaled to unit length; the identity where `q` is zero.
inline Quat normalized(Quat q) {
    const float l2 = dot(q, q);
    if (!(l2 > 1e-20f)) return {};
    const float s = 1.0f / std::sqrt(l2);
    return {q.x * s, q.y * s, q.z * s, q.w * s};
}
/// `v` rotated by `q`.
constexpr Vec3 rotate(Quat q, Vec3 v) {
    const Vec3 u{q.x, q.y, q.z};
    const Vec3 t = 2.0f * cross(u, v);
    return v + q.w * t + cross(u, t);
}
/// Rotation by `angle` [rad] about a unit `axis`, right-handed.
Quat axisAngle(Vec3 axis, double angle);
/// Rotation about the vertical: to the left where `angle` [rad] is positive.
inline Quat yawTurn(double angle) {
    return axisAngle({0.0f, 0.0f, 1.0f}, angle);
}
/// The smallest rotation that takes unit vector `from` to unit vector `to`; by pi about some axis where they
/// are opposite.
inline Quat shortestArc(Vec3 from, Vec3 to) {
    const float d = dot(from, to);
    if (d < -0.999999f) {
        const Vec3 side = std::fabs(from.x) < 0.9f ? Vec3{1.0f, 0.0f, 0.0f} : Vec3{0.0f, 1.0f, 0.0f};
        const Vec3 axis = normalized(cross(from, side));
        return {axis.x, axis.y, axis.z, 0.0f};
    }
    const Vec3 c = cross(from, to);
    return normalized(Quat{c.x, c.y, c.z, 1.0f + d});
}
/// Normalised linear interpolation along the shorter arc; exact at both ends.
inline Quat nlerp(Quat a, Quat b, float t) {
    const float s = 1.0f - t, u = dot(a, b) < 0.0f ? -t : t;
    return normalized(Quat{s * a.x + u * b.x, s * a.y + u * b.y, s * a.z + u * b.z, s * a.w + u * b.w});
}
/// The angle between two rotations [rad], 0 to pi.
double angleBetween(Quat a, Quat b);

/// A rigid transform: rotation about the origin, then translation.
struct Transform {
    Quat rotation;
    Vec3 translation;  ///< Translation [m].

    /// The transformed point.
    constexpr Vec3 apply(Vec3 p) const { return translation + rotate(rotation, p); }
};
/// Composition: applies `b` first, then `a`.
constexpr Transform operator*(const Transform& a, const Transform& b) {
    return {a.rotation * b.rotation, a.apply(b.translation)};
}

}  // namespace muster
