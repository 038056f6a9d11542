#include "geometry/predicates.h"

#include <vector>

namespace muster {
namespace {

// A number as a sum of doubles that do not overlap, smallest first (Dekker 1971, Shewchuk 1997).
// Only the rare undecided determinants get here, so memory from the heap is good enough.
using Expansion = std::vector<double>;

struct Pair {
    double high;
    double low;
};

Pair twoSum(double a, double b) {
    const double sum = a + b;
    const double bPart = sum - a;
    const double aPart = sum - bPart;
    return {sum, (a - aPart) + (b - bPart)};
}

Pair split(double a) {
    const double c = 134217729.0 * a;  // 2^27 + 1
    const double high = c - (c - a);
    return {high, a - high};
}

Pair twoProduct(double a, double b) {
    const double product = a * b;
    const Pair x = split(a);
    const Pair y = split(b);
    const double error = ((x.high * y.high - product) + x.high * y.low + x.low * y.high) + x.low * y.low;
    return {product, error};
}

// Adds one number, dropping components that vanish.
void grow(Expansion& sum, double value) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        const Pair p = twoSum(value, sum[i]);
        if (p.low != 0.0) sum[count++] = p.low;
        value = p.high;
    }
    sum.resize(count);
    if (value != 0.0) sum.push_back(value);
}

Expansion difference(double a, double b) {
    const Pair p = twoSum(a, -b);
    Expansion result;
    if (p.low != 0.0) result.push_back(p.low);
    if (p.high != 0.0) result.push_back(p.high);
    return result;
}

void addProduct(Expansion& sum, const Expansion& a, const Expansion& b, double sign) {
    for (double x : a) {
        for (double y : b) {
            const Pair p = twoProduct(x, sign * y);
            grow(sum, p.low);
            grow(sum, p.high);
        }
    }
}

int signOf(const Expansion& value) {
    if (value.empty()) return 0;
    return value.back() > 0.0 ? 1 : -1;
}

Expansion crossOf(const Expansion& ax, const Expansion& ay, const Expansion& bx, const Expansion& by) {
    Expansion result;
    addProduct(result, ax, by, 1.0);
    addProduct(result, ay, bx, -1.0);
    return result;
}

Expansion squareOf(const Expansion& x, const Expansion& y) {
    Expansion result;
    addProduct(result, x, x, 1.0);
    addProduct(result, y, y, 1.0);
    return result;
}

int exactOrientation(Vec2 a, Vec2 b, Vec2 c) {
    return signOf(
        crossOf(difference(a.x, c.x), difference(a.y, c.y), difference(b.x, c.x), difference(b.y, c.y)));
}

int exactInCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Expansion ax = difference(a.x, d.x), ay = difference(a.y, d.y);
    const Expansion bx = difference(b.x, d.x), by = difference(b.y, d.y);
    const Expansion cx = difference(c.x, d.x), cy = difference(c.y, d.y);
    Expansion sum;
    addProduct(sum, squareOf(ax, ay), crossOf(bx, by, cx, cy), 1.0);
    addProduct(sum, squareOf(bx, by), crossOf(cx, cy, ax, ay), 1.0);
    addProduct(sum, squareOf(cx, cy), crossOf(ax, ay, bx, by), 1.0);
    return signOf(sum);
}

}  // namespace

int orientation(Vec2 a, Vec2 b, Vec2 c) {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    // Shewchuk's first bound, (3 + 16 e) e, rounded up.
    const double bound = 3.3306690738754716e-16 * (std::fabs(left) + std::fabs(right));
    if (determinant > bound) return 1;
    if (determinant < -bound) return -1;
    return exactOrientation(a, b, c);
}

int inCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Vec2 p = a - d, q = b - d, r = c - d;
    const double determinant = lengthSquared(p) * cross(q, r) + lengthSquared(q) * cross(r, p) +
                               lengthSquared(r) * cross(p, q);
    const double size = lengthSquared(p) * (std::fabs(q.x * r.y) + std::fabs(q.y * r.x)) +
                        lengthSquared(q) * (std::fabs(r.x * p.y) + std::fabs(r.y * p.x)) +
                        lengthSquared(r) * (std::fabs(p.x * q.y) + std::fabs(p.y * q.x));
    // Shewchuk's first bound, (10 + 96 e) e, rounded up.
    const double bound = 1.1102230246251577e-15 * size;
    if (determinant > bound) return 1;
    if (determinant < -bound) return -1;
    return exactInCircle(a, b, c, d);
}

}  // namespace muster
