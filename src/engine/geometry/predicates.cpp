#include "engine/geometry/polygon.h"

#include <array>
#include <cstddef>

namespace muster {
namespace {

// A number as a sum of at most `most` doubles that do not overlap, smallest first (Dekker 1971, Shewchuk
// 1997).
template <std::size_t most>
class Expansion {
public:
    static constexpr std::size_t kMost = most;

    std::size_t size() const { return size_; }
    double operator[](std::size_t k) const { return part_[k]; }
    void push(double value) {
        if (value != 0.0) part_[size_++] = value;
    }
    // Adds one number, dropping parts that vanish. There must be room for one more.
    void grow(double value);
    int sign() const {
        if (size_ == 0) return 0;
        return part_[size_ - 1] > 0.0 ? 1 : -1;
    }

private:
    std::size_t size_ = 0;
    std::array<double, most> part_;  // Parts, of which only the first `size_` have values.
};

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

template <std::size_t most>
void Expansion<most>::grow(double value) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < size_; ++i) {
        const Pair p = twoSum(value, part_[i]);
        if (p.low != 0.0) part_[count++] = p.low;
        value = p.high;
    }
    size_ = count;
    push(value);
}

// The difference of two doubles, and sums of two products of such.
using Difference = Expansion<2>;
using Products = Expansion<16>;

Difference difference(double a, double b) {
    const Pair p = twoSum(a, -b);
    Difference result;
    result.push(p.low);
    result.push(p.high);
    return result;
}

template <class Sum, class Factor>
void addProduct(Sum& sum, const Factor& a, const Factor& b, double sign) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Pair p = twoProduct(a[i], sign * b[j]);
            if (p.low != 0.0) sum.grow(p.low);
            sum.grow(p.high);
        }
    }
}

Products crossOf(const Difference& ax, const Difference& ay, const Difference& bx, const Difference& by) {
    Products result;
    addProduct(result, ax, by, 1.0);
    addProduct(result, ay, bx, -1.0);
    return result;
}

Products squareOf(const Difference& x, const Difference& y) {
    Products result;
    addProduct(result, x, x, 1.0);
    addProduct(result, y, y, 1.0);
    return result;
}

int exactOrientation(Vec2 a, Vec2 b, Vec2 c) {
    return crossOf(difference(a.x, c.x), difference(a.y, c.y), difference(b.x, c.x), difference(b.y, c.y))
        .sign();
}

int exactInCircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Difference ax = difference(a.x, d.x), ay = difference(a.y, d.y);
    const Difference bx = difference(b.x, d.x), by = difference(b.y, d.y);
    const Difference cx = difference(c.x, d.x), cy = difference(c.y, d.y);
    // Three products of two numbers of 16 parts, each of two doubles.
    Expansion<3 * Products::kMost * Products::kMost * 2> sum;
    addProduct(sum, squareOf(ax, ay), crossOf(bx, by, cx, cy), 1.0);
    addProduct(sum, squareOf(bx, by), crossOf(cx, cy, ax, ay), 1.0);
    addProduct(sum, squareOf(cx, cy), crossOf(ax, ay, bx, by), 1.0);
    return sum.sign();
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
