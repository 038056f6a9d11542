// Coverage of pixels compared with exactly clipped areas; lines, dashes and scaled rasters.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/maths.h"
#include "base/random.h"
#include "lab/picture/canvas.h"
#include "lab/picture/canvas_pixels.h"

using namespace muster;
using namespace muster::testing;

namespace {

using Loop = std::vector<Vec2>;
using Loops = std::vector<Loop>;

/// Ink of one pixel on a white canvas, 0 to 1.
double inkAt(const std::vector<std::uint8_t>& bytes, const Canvas& canvas, int x, int y) {
    return (255.0 - bytes[(y * canvas.width() + x) * 3]) / 255.0;
}

double inkOf(const Canvas& canvas) {
    double sum = 0.0;
    const auto bytes = canvas.bytes();
    for (std::size_t i = 0; i < bytes.size(); i += 3) sum += (255.0 - bytes[i]) / 255.0;
    return sum;
}

/// The part of a polygon on the side `sign * (coordinate - limit) >= 0` (Sutherland and Hodgman).
Loop cut(const Loop& loop, bool vertical, double limit, double sign) {
    Loop kept;
    const auto side = [&](Vec2 p) { return sign * ((vertical ? p.x : p.y) - limit); };
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
        if (side(a) >= 0) kept.push_back(a);
        if ((side(a) >= 0) != (side(b) >= 0)) kept.push_back(lerp(a, b, side(a) / (side(a) - side(b))));
    }
    return kept;
}

double areaOf(const Loop& loop) {
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) twice += cross(loop[i], loop[(i + 1) % loop.size()]);
    return std::fabs(twice) / 2.0;
}

/// The exact area of a polygon within one pixel.
double areaIn(const Loop& loop, int x, int y) {
    return areaOf(cut(cut(cut(cut(loop, true, x, 1), true, x + 1, -1), false, y, 1), false, y + 1, -1));
}

/// Corners on a circle: a convex polygon of either orientation.
Loop randomConvex(Random& random, Vec2 centre, double radius) {
    std::vector<double> angles(3 + random.below(5));
    for (double& angle : angles) angle = random.uniform(0, 2 * kPi);
    std::sort(angles.begin(), angles.end());
    Loop loop;
    for (const double angle : angles) loop.push_back(centre + Vec2{cosine(angle), sine(angle)} * radius);
    if (random.below(2) == 0) std::reverse(loop.begin(), loop.end());
    return loop;
}

Loop rectangle(double x0, double y0, double x1, double y1) {
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

}  // namespace

TEST_CASE("each pixel has the coverage of the polygon clipped to it") {
    Random random(31);
    for (int i = 0; i < 60; ++i) {
        Canvas canvas(32, 24, kWhite);
        const Loop loop = randomConvex(random, {random.uniform(8, 24), random.uniform(6, 18)},
                                       random.uniform(2, 14));
        canvas.fill(Loops{loop}, kBlack);
        const auto bytes = canvas.bytes();
        double sum = 0.0, exact = 0.0;
        for (int y = 0; y < 24; ++y) {
            for (int x = 0; x < 32; ++x) {
                const double area = areaIn(loop, x, y), ink = inkAt(bytes, canvas, x, y);
                CHECK(std::fabs(ink - area) < 0.11);  // Rows are sampled at five heights.
                if (area == 0.0) CHECK(ink < 0.11);
                if (area > 1.0 - 1e-9) CHECK(ink > 0.995);
                sum += ink;
                exact += area;
            }
        }
        CHECK(std::fabs(sum - exact) < 0.02 * exact + 0.6);
    }
}

TEST_CASE("edges between rows and columns give exact coverage") {
    Canvas canvas(6, 6, kWhite);
    canvas.fill(Loops{rectangle(1.25, 1.0, 3.5, 4.0)}, kBlack);
    const auto bytes = canvas.bytes();
    for (int y = 1; y < 4; ++y) {
        CHECK(inkAt(bytes, canvas, 0, y) == 0.0);
        CHECK(inkAt(bytes, canvas, 1, y) == doctest::Approx(0.75).epsilon(0.005));
        CHECK(inkAt(bytes, canvas, 2, y) == 1.0);
        CHECK(inkAt(bytes, canvas, 3, y) == doctest::Approx(0.5).epsilon(0.005));
        CHECK(inkAt(bytes, canvas, 4, y) == 0.0);
    }
    CHECK(inkAt(bytes, canvas, 2, 0) == 0.0);
    CHECK(inkAt(bytes, canvas, 2, 4) == 0.0);
    canvas.fill(Loops{rectangle(0, 5.4, 6, 6)}, kBlack);  // Three of five rows.
    CHECK(inkAt(canvas.bytes(), canvas, 3, 5) == doctest::Approx(0.6).epsilon(0.005));
}

TEST_CASE(
    "a shape moved by whole pixels gives the same picture moved, and reversing the loop changes "
    "nothing") {
    Random random(32);
    for (int i = 0; i < 20; ++i) {
        Loop loop = randomConvex(random, {10.0625, 9.5}, random.uniform(2, 7));
        Canvas here(40, 40, kWhite), there(40, 40, kWhite), turned(40, 40, kWhite);
        here.fill(Loops{loop}, kBlack);
        Loop back(loop.rbegin(), loop.rend());
        turned.fill(Loops{back}, kBlack);
        CHECK(turned.bytes() == here.bytes());
        for (Vec2& p : loop) p += Vec2{13, 17};
        there.fill(Loops{loop}, kBlack);
        const auto a = here.bytes(), b = there.bytes();
        for (int y = 0; y < 20; ++y) {
            for (int x = 0; x < 20; ++x)
                CHECK(std::fabs(inkAt(a, here, x, y) - inkAt(b, there, x + 13, y + 17)) < 0.01);
        }
    }
}

TEST_CASE("shapes beyond the border are clipped and leave the opposite border uncoloured") {
    Canvas canvas(10, 8, kWhite);
    canvas.fill(Loops{rectangle(7.5, -3, 40, 4)}, kBlack);
    CHECK(inkOf(canvas) == doctest::Approx(2.5 * 4).epsilon(0.01));
    CHECK(inkAt(canvas.bytes(), canvas, 0, 1) == 0.0);
    canvas.fill(Loops{rectangle(-100, -100, 100, 100)}, kBlack);
    CHECK(inkOf(canvas) == doctest::Approx(80.0).epsilon(1e-6));
}

TEST_CASE("colours blend by their opacity, and later fills cover earlier ones") {
    Canvas canvas(4, 4, Colour::of(0x204060));
    const Loops all{rectangle(0, 0, 4, 4)};
    canvas.fill(all, Colour::of(0xFF8000, 0.25));
    auto bytes = canvas.bytes();
    CHECK(int(bytes[0]) == std::lround(0x20 + (0xFF - 0x20) * 0.25));
    CHECK(int(bytes[1]) == std::lround(0x40 + (0x80 - 0x40) * 0.25));
    CHECK(int(bytes[2]) == std::lround(0x60 - 0x60 * 0.25));
    canvas.fill(all, Colour::of(0x000000, 0.5));
    bytes = canvas.bytes();
    CHECK(std::abs(int(bytes[0]) - std::lround((0x20 + (0xFF - 0x20) * 0.25) / 2)) <= 1);
    canvas.fill(all, Colour::of(0xFFFFFF, 0.0));
    CHECK(canvas.bytes() == bytes);
    canvas.fill(all, Colour::of(0xABCDEF));
    CHECK(int(canvas.bytes()[1]) == 0xCD);
}

TEST_CASE("a self-crossing star is filled in its middle") {
    Loop star;
    for (int k = 0; k < 5; ++k) {
        const double angle = 4 * kPi * k / 5;
        star.push_back(Vec2{20, 20} + Vec2{cosine(angle), sine(angle)} * 18.0);
    }
    Canvas canvas(40, 40, kWhite);
    canvas.fill(Loops{star}, Colour::of(0x000000, 0.5));
    // The winding number is two, but the colour is applied once.
    CHECK(inkAt(canvas.bytes(), canvas, 20, 20) == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("a line's area is width times length plus round ends; a closed line has a hole") {
    Random random(33);
    for (int i = 0; i < 20; ++i) {
        const double angle = random.uniform(0, 2 * kPi), width = random.uniform(3, 8),
                     reach = random.uniform(20, 40);
        const Vec2 along = Vec2{cosine(angle), sine(angle)} * (reach / 2);
        Loops loops;
        strokeLoops(Loop{Vec2{50, 50} - along, Vec2{50, 50} + along}, false, width, 0.0, loops);
        Canvas canvas(100, 100, kWhite);
        canvas.fill(loops, kBlack);
        CHECK(inkOf(canvas) == doctest::Approx(reach * width + kPi * width * width / 4).epsilon(0.03));
    }
    Loops ring;
    strokeLoops(rectangle(20, 20, 80, 70), true, 6.0, 0.0, ring);
    for (Loop& loop : ring) {  // Loops of the same orientation unite.
        double twice = 0.0;
        for (std::size_t i = 0; i < loop.size(); ++i) twice += cross(loop[i], loop[(i + 1) % loop.size()]);
        CHECK(twice > 0.0);
    }
    Canvas canvas(100, 100, kWhite);
    canvas.fill(ring, kBlack);
    CHECK(inkOf(canvas) == doctest::Approx(220.0 * 6.0).epsilon(0.02));
    CHECK(inkAt(canvas.bytes(), canvas, 50, 45) == 0.0);
}

TEST_CASE("dashes and gaps have their length, and continue around corners") {
    Loops loops;
    strokeLoops(Loop{{0, 10}, {100, 10}}, false, 2.0, 8.0, loops);
    Canvas canvas(110, 20, kWhite);
    canvas.fill(loops, kBlack);
    const auto bytes = canvas.bytes();
    int runs = 0;
    for (int x = 1; x < 110; ++x)
        runs += inkAt(bytes, canvas, x - 1, 10) < 0.5 && inkAt(bytes, canvas, x, 10) >= 0.5;
    CHECK(runs == 5);  // The first begins at the border; then one each 18 px.
    Loops straight, bent;
    strokeLoops(Loop{{10, 10}, {94, 10}}, false, 2.0, 8.0, straight);
    strokeLoops(Loop{{10, 10}, {31, 10}, {31, 52}, {52, 52}}, false, 2.0, 8.0, bent);
    Canvas a(120, 80, kWhite), b(120, 80, kWhite);
    a.fill(straight, kBlack);
    b.fill(bent, kBlack);
    CHECK(inkOf(b) == doctest::Approx(inkOf(a)).epsilon(0.05));
}

TEST_CASE("lines of no points, one point, a repeated point or no width draw nothing") {
    Loops loops;
    strokeLoops({}, false, 3.0, 0.0, loops);
    strokeLoops(Loop{{5, 5}}, false, 3.0, 0.0, loops);
    strokeLoops(Loop{{5, 5}, {9, 9}}, false, 0.0, 0.0, loops);
    CHECK(loops.empty());
    strokeLoops(Loop{{5, 5}, {5, 5}}, false, 4.0, 0.0, loops);
    strokeLoops(Loop{{5, 5}, {5, 5}}, false, 4.0, 3.0, loops);
    Canvas canvas(10, 10, kWhite);
    canvas.fill(loops, kBlack);
    CHECK(inkOf(canvas) <= kPi * 4.0 * 1.02);  // At most a dot.
}

TEST_CASE("discs have the area of discs, from a pixel to a hundred") {
    for (const double radius : {1.0, 3.0, 10.0, 40.0, 100.0}) {
        const Loop loop = discLoop({3, -4}, radius);
        CHECK(areaOf(loop) == doctest::Approx(kPi * radius * radius).epsilon(0.06));
        for (const Vec2 p : loop) CHECK(distance(p, {3, -4}) == doctest::Approx(radius));
    }
}

TEST_CASE("a raster keeps its samples, interpolates between them and repeats its border") {
    const std::vector<Colour> colours{Colour::of(0x000000), Colour::of(0xC80000), Colour::of(0x0000C8),
                                      Colour::of(0xC8C8C8)};
    CHECK(sampleRaster(2, 2, colours, 1, 0) == colours[1]);
    CHECK(sampleRaster(2, 2, colours, 0, 1) == colours[2]);
    CHECK(sampleRaster(2, 2, colours, 0.5, 0).red == 100);
    CHECK(sampleRaster(2, 2, colours, 0.5, 0.5).green == 50);
    CHECK(sampleRaster(2, 2, colours, -7, -7) == colours[0]);
    CHECK(sampleRaster(2, 2, colours, 99, 99) == colours[3]);
    // A transparent sample does not tint its neighbour.
    const std::vector<Colour> half{Colour::of(0xFF0000), Colour::of(0x00FF00, 0.0)};
    const Colour mixed = sampleRaster(2, 1, half, 0.5, 0);
    CHECK(mixed.red == 255);
    CHECK(mixed.green == 0);
    CHECK(mixed.opacity == doctest::Approx(0.5));
    CHECK(sampleRaster(2, 1, half, 1, 0).opacity == 0.0);
}
