// Points and directions in the ground plane.
#pragma once

#include <cmath>

namespace muster {

/// A point or vector in the ground plane: x right, y forward [m].
struct Vec2 {
    double x = 0.0;
    double y = 0.0;

    /// Exact comparison, bit for bit apart from the sign of zero.
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) {
    return {a.x + b.x, a.y + b.y};
}
constexpr Vec2 operator-(Vec2 a, Vec2 b) {
    return {a.x - b.x, a.y - b.y};
}
constexpr Vec2 operator-(Vec2 a) {
    return {-a.x, -a.y};
}
constexpr Vec2 operator*(Vec2 a, double s) {
    return {a.x * s, a.y * s};
}
constexpr Vec2 operator*(double s, Vec2 a) {
    return {a.x * s, a.y * s};
}
constexpr Vec2 operator/(Vec2 a, double s) {
    return {a.x / s, a.y / s};
}
constexpr Vec2& operator+=(Vec2& a, Vec2 b) {
    return a = a + b;
}
constexpr Vec2& operator-=(Vec2& a, Vec2 b) {
    return a = a - b;
}
constexpr Vec2& operator*=(Vec2& a, double s) {
    return a = a * s;
}

/// Scalar product.
constexpr double dot(Vec2 a, Vec2 b) {
    return a.x * b.x + a.y * b.y;
}
/// The z component of the cross product: positive where `b` lies to the left of `a`.
constexpr double cross(Vec2 a, Vec2 b) {
    return a.x * b.y - a.y * b.x;
}
/// `a` rotated left by 90 degrees.
constexpr Vec2 perpendicular(Vec2 a) {
    return {-a.y, a.x};
}
/// Squared length [m^2].
constexpr double lengthSquared(Vec2 a) {
    return dot(a, a);
}
/// Length [m].
inline double length(Vec2 a) {
    return std::sqrt(dot(a, a));
}
/// Distance between two points [m].
inline double distance(Vec2 a, Vec2 b) {
    return length(b - a);
}
/// The unit vector along `a`, or `fallback` where `a` is shorter than 1e-12 m.
inline Vec2 normalized(Vec2 a, Vec2 fallback = {0.0, 0.0}) {
    const double l = length(a);
    return l > 1e-12 ? a / l : fallback;
}
/// The point at share `t` of the distance from `a` to `b`.
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) {
    return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}
/// `a` shortened to `limit` [m] where it is longer.
inline Vec2 clampLength(Vec2 a, double limit) {
    const double l2 = dot(a, a);
    return l2 > limit * limit ? a * (limit / std::sqrt(l2)) : a;
}
/// True where both coordinates are finite numbers.
inline bool isFinite(Vec2 a) {
    return std::isfinite(a.x) && std::isfinite(a.y);
}

/// A rotation in the plane, stored as cosine and sine of its angle.
struct Rotation {
    double c = 1.0;  ///< Cosine.
    double s = 0.0;  ///< Sine.

    /// `a` rotated.
    constexpr Vec2 apply(Vec2 a) const { return {c * a.x - s * a.y, s * a.x + c * a.y}; }
    /// `a` rotated by the inverse.
    constexpr Vec2 applyInverse(Vec2 a) const { return {c * a.x + s * a.y, -s * a.x + c * a.y}; }

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(c, s);
    }
    friend bool operator==(const Rotation&, const Rotation&) = default;
};

/// A rigid transform: rotation about the origin, then translation.
struct Pose {
    Vec2 position;      ///< Translation [m].
    Rotation rotation;  ///< Unit rotation.

    /// From local to world coordinates.
    constexpr Vec2 apply(Vec2 local) const { return rotation.apply(local) + position; }
    /// From world to local coordinates.
    constexpr Vec2 applyInverse(Vec2 world) const { return rotation.applyInverse(world - position); }

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, rotation);
    }
    friend bool operator==(const Pose&, const Pose&) = default;
};

/// An axis-aligned box.
struct Box {
    Vec2 min;  ///< Lower left corner [m].
    Vec2 max;  ///< Upper right corner [m].

    constexpr double width() const { return max.x - min.x; }   ///< [m]
    constexpr double height() const { return max.y - min.y; }  ///< [m]
    /// True where `p` lies inside or on the edge.
    constexpr bool contains(Vec2 p) const {
        return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y;
    }
    /// The point of the box nearest to `p`.
    constexpr Vec2 clamp(Vec2 p) const {
        return {p.x < min.x ? min.x : (p.x > max.x ? max.x : p.x),
                p.y < min.y ? min.y : (p.y > max.y ? max.y : p.y)};
    }
    /// This box grown by `margin` [m] on every side.
    constexpr Box grown(double margin) const {
        return {{min.x - margin, min.y - margin}, {max.x + margin, max.y + margin}};
    }
};

}  // namespace muster
