#include "engine/geometry/polygon.h"

#include <doctest.h>

#include <cmath>

#include "base/random.h"

using namespace muster;

namespace {

using Whole = __int128;

struct Point {
    std::int64_t x, y;
    /// Multiplied by a power of two, so nothing is rounded.
    Vec2 scaled(int exponent) const {
        return {std::ldexp(static_cast<double>(x), exponent), std::ldexp(static_cast<double>(y), exponent)};
    }
};

int sign(Whole value) {
    return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

int wholeOrientation(Point a, Point b, Point c) {
    return sign(static_cast<Whole>(a.x - c.x) * (b.y - c.y) - static_cast<Whole>(a.y - c.y) * (b.x - c.x));
}

/// The determinant by its rows (squared length, x, y), expanded along the first column.
int wholeInCircle(Point a, Point b, Point c, Point d) {
    const auto square = [&](Point p) {
        return static_cast<Whole>(p.x - d.x) * (p.x - d.x) + static_cast<Whole>(p.y - d.y) * (p.y - d.y);
    };
    const auto minor = [&](Point p, Point q) {
        return static_cast<Whole>(p.x - d.x) * (q.y - d.y) - static_cast<Whole>(p.y - d.y) * (q.x - d.x);
    };
    return sign(square(a) * minor(b, c) - square(b) * minor(a, c) + square(c) * minor(a, b));
}

Point randomPoint(Random& random, std::int64_t reach) {
    const auto one = [&] {
        const auto bits = static_cast<std::uint64_t>(random.next()) << 32 | random.next();
        return static_cast<std::int64_t>(bits % static_cast<std::uint64_t>(2 * reach + 1)) - reach;
    };
    const std::int64_t x = one();
    return {x, one()};
}

}  // namespace

TEST_CASE("orientation has the sign of whole-number arithmetic, near a line and on it") {
    Random random(71);
    int flat = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::int64_t reach = i % 2 == 0 ? 5 : std::int64_t{1} << 50;
        const Point a = randomPoint(random, reach);
        const Point step = randomPoint(random, reach / 4 + 1);
        const Point b{a.x + step.x, a.y + step.y};
        const auto times = static_cast<std::int64_t>(random.below(3)) + 1;
        // On the line through a and b, or one unit off it.
        const Point c{b.x + times * step.x / 2, b.y + times * step.y / 2 + random.below(2)};
        const int expected = wholeOrientation(a, b, c);
        flat += expected == 0 ? 1 : 0;
        for (const int exponent : {0, -30, 20}) {
            const Vec2 p = a.scaled(exponent), q = b.scaled(exponent), r = c.scaled(exponent);
            REQUIRE(orientation(p, q, r) == expected);
            REQUIRE(orientation(q, r, p) == expected);
            REQUIRE(orientation(q, p, r) == -expected);
        }
    }
    CHECK(flat > 500);
}

TEST_CASE("inCircle has the sign of whole-number arithmetic, near a circle and on it") {
    Random random(72);
    // Whole points of the circle x^2 + y^2 = 5525, which has many, turned and mirrored.
    const std::array<Point, 6> onCircle{{{74, 7}, {73, 14}, {71, 22}, {70, 25}, {62, 41}, {55, 50}}};
    for (const Point p : onCircle) REQUIRE(p.x * p.x + p.y * p.y == 5525);
    const auto pick = [&] {
        Point p = onCircle[random.below(6)];
        for (std::uint32_t turns = random.below(4); turns > 0; --turns) p = {-p.y, p.x};
        return p;
    };
    int on = 0, compared = 0;
    for (int i = 0; i < 20000; ++i) {
        const std::int64_t factor = std::int64_t{1} << random.below(17);
        Point p[4] = {pick(), pick(), pick(), pick()};
        const Point shift = randomPoint(random, 1 << 20);
        for (Point& q : p) q = {q.x * factor + shift.x, q.y * factor + shift.y};
        if (random.below(2) == 0) p[3].x += static_cast<std::int64_t>(random.below(3)) - 1;
        if (wholeOrientation(p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
        if (wholeOrientation(p[0], p[1], p[2]) == 0) continue;
        const int expected = wholeInCircle(p[0], p[1], p[2], p[3]);
        ++compared;
        on += expected == 0 ? 1 : 0;
        for (const int exponent : {0, -20}) {
            const Vec2 a = p[0].scaled(exponent), b = p[1].scaled(exponent), c = p[2].scaled(exponent),
                       d = p[3].scaled(exponent);
            REQUIRE(inCircle(a, b, c, d) == expected);
            REQUIRE(inCircle(b, c, a, d) == expected);
        }
    }
    CHECK(on > 2000);
    CHECK(compared - on > 2000);
}
