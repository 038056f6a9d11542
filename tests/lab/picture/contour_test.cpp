// Contour lines compared with fields whose contours are known, and every case of a square.
#include <doctest.h>

#include <cmath>
#include <functional>
#include <map>
#include <vector>

#include "base/maths.h"
#include "base/random.h"
#include "lab/picture/picture.h"

using namespace muster;

namespace {

using Segments = std::vector<std::pair<Vec2, Vec2>>;

std::vector<double> sampled(std::int32_t width, std::int32_t height,
                            const std::function<double(Vec2)>& field) {
    std::vector<double> samples;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) samples.push_back(field({x * 1.0, y * 1.0}));
    }
    return samples;
}

double lengthOf(const Segments& segments) {
    double sum = 0.0;
    for (const auto& [a, b] : segments) sum += distance(a, b);
    return sum;
}

/// The number of segment ends at each point; two squares may give it with different rounding.
std::map<std::pair<double, double>, int> endsOf(const Segments& segments) {
    std::map<std::pair<double, double>, int> ends;
    const auto rounded = [](double value) { return std::round(value * 1e9) / 1e9; };
    for (const auto& [a, b] : segments) {
        ++ends[{rounded(a.x), rounded(a.y)}];
        ++ends[{rounded(b.x), rounded(b.y)}];
    }
    return ends;
}

}  // namespace

TEST_CASE("all sixteen squares: each edge whose ends differ is crossed once, and no other") {
    for (int bits = 0; bits < 16; ++bits) {
        CAPTURE(bits);
        // Corners: lower left, lower right, upper left, upper right; 1 above the level, 0 below.
        const auto high = [&](int corner) { return (bits >> corner & 1) != 0; };
        std::vector<double> samples;
        for (int corner = 0; corner < 4; ++corner) samples.push_back(high(corner) ? 1.0 : 0.0);
        const Segments segments = contourSegments(2, 2, samples, 0.25);
        const auto ends = endsOf(segments);
        const std::pair<int, int> edges[4] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
        std::size_t crossed = 0;
        for (const auto& [a, b] : edges) {
            if (high(a) == high(b)) continue;
            ++crossed;
            const double t = high(a) ? 0.75 : 0.25;  // From `a`, by linear interpolation.
            const Vec2 from{a % 2 * 1.0, a / 2 * 1.0}, to{b % 2 * 1.0, b / 2 * 1.0};
            const Vec2 hit = lerp(from, to, t);
            const auto found = ends.find({hit.x, hit.y});
            REQUIRE(found != ends.end());
            CHECK(found->second == 1);
        }
        CHECK(ends.size() == crossed);
        CHECK(segments.size() == crossed / 2);
    }
}

TEST_CASE("at a saddle the two lines do not cross") {
    for (const auto& samples : {std::vector<double>{1, 0, 0, 1}, std::vector<double>{0, 1, 1, 0}}) {
        const Segments s = contourSegments(2, 2, samples, 0.5);
        REQUIRE(s.size() == 2);
        const auto side = [](Vec2 a, Vec2 b, Vec2 p) { return cross(b - a, p - a); };
        const bool across = side(s[0].first, s[0].second, s[1].first) *
                                    side(s[0].first, s[0].second, s[1].second) <
                                0 &&
                            side(s[1].first, s[1].second, s[0].first) *
                                    side(s[1].first, s[1].second, s[0].second) <
                                0;
        CHECK_FALSE(across);
    }
}

TEST_CASE("circles have the right radius and length and no ends") {
    const Vec2 centre{19.3, 20.7};
    const auto samples = sampled(41, 41, [&](Vec2 p) { return distance(p, centre); });
    for (const double radius : {3.0, 7.5, 15.0}) {
        const Segments segments = contourSegments(41, 41, samples, radius);
        for (const auto& [a, b] : segments) {
            CHECK(std::fabs(distance(a, centre) - radius) < 0.13 / radius);  // Linear between samples.
            CHECK(distance(a, b) <= std::sqrt(2.0) + 1e-12);
        }
        CHECK(lengthOf(segments) == doctest::Approx(2 * kPi * radius).epsilon(0.01));
        for (const auto& [point, count] : endsOf(segments)) CHECK(count == 2);
    }
}

TEST_CASE("planes of any slope are cut along their line, from border to border") {
    Random random(41);
    for (int i = 0; i < 50; ++i) {
        const Vec2 slope{random.uniform(-2, 2), random.uniform(0.1, 2)};
        const Vec2 through{random.uniform(3, 9), random.uniform(3, 9)};
        const auto samples = sampled(13, 13, [&](Vec2 p) { return dot(slope, p); });
        const Segments segments = contourSegments(13, 13, samples, dot(slope, through));
        CHECK_FALSE(segments.empty());
        for (const auto& [a, b] : segments) {
            CHECK(dot(slope, a - through) == doctest::Approx(0.0).epsilon(1e-9));
            CHECK(dot(slope, b - through) == doctest::Approx(0.0).epsilon(1e-9));
        }
        int open = 0;
        for (const auto& [point, count] : endsOf(segments)) {
            const bool rim = point.first == 0 || point.first == 12 || point.second == 0 || point.second == 12;
            if (count == 1) CHECK(rim);
            open += count == 1;
        }
        CHECK(open == 2);
    }
}

TEST_CASE("hyperbolas of a saddle field and waves lie where the formula says") {
    const auto saddle = sampled(31, 31, [](Vec2 p) { return (p.x - 15) * (p.y - 15); });
    const Segments hyperbolas = contourSegments(31, 31, saddle, 20.0);
    CHECK(hyperbolas.size() > 20);
    // On edges of the grid the product is linear, so the crossings are exact.
    for (const auto& [a, b] : hyperbolas) {
        CHECK((a.x - 15) * (a.y - 15) == doctest::Approx(20.0).epsilon(1e-9));
        CHECK((b.x - 15) * (b.y - 15) == doctest::Approx(20.0).epsilon(1e-9));
    }
    const auto wave = sampled(60, 8, [](Vec2 p) { return sine(p.x * 0.2); });
    const Segments zeros = contourSegments(60, 8, wave, 0.0);
    for (const auto& [a, b] : zeros) {
        const double turns = a.x * 0.2 / kPi;
        CHECK(std::fabs(turns - std::round(turns)) < 0.002);
    }
    // The contours are at 5, 10 and 15 pi; none is at the border's 0.
    CHECK(lengthOf(zeros) == doctest::Approx(3 * 7.0).epsilon(0.01));
}

TEST_CASE("random fields: lines are closed except at the border and at gaps, and lie between their samples") {
    Random random(42);
    for (int i = 0; i < 30; ++i) {
        auto samples = sampled(9, 7, [&](Vec2) { return random.uniform(-1, 1); });
        const Segments whole = contourSegments(9, 7, samples, 0.1);
        for (const auto& [point, count] : endsOf(whole)) {
            const bool rim = point.first == 0 || point.first == 8 || point.second == 0 || point.second == 6;
            CHECK(count == (rim ? 1 : 2));
        }
        const auto raised = contourSegments(
            9, 7,
            [&] {
                auto shifted = samples;
                for (double& v : shifted) v += 5.0;
                return shifted;
            }(),
            5.1);
        CHECK(raised.size() == whole.size());
        // A gap removes exactly the lines in the four squares around it.
        samples[9 * 3 + 4] = i % 2 == 0 ? NAN : INFINITY;
        std::size_t kept = 0;
        for (const auto& [a, b] : whole) {
            const Vec2 middle = lerp(a, b, 0.5);
            kept += !(middle.x > 3 && middle.x < 5 && middle.y > 2 && middle.y < 4);
        }
        CHECK(contourSegments(9, 7, samples, 0.1).size() == kept);
    }
}

TEST_CASE("constant fields, rows and single samples have no lines") {
    const std::vector<double> level(20, 3.0);
    CHECK(contourSegments(5, 4, level, 3.0).empty());
    CHECK(contourSegments(5, 4, level, 2.0).empty());
    const std::vector<double> row{0, 1, 2, 3};
    CHECK(contourSegments(4, 1, row, 1.5).empty());
    CHECK(contourSegments(1, 4, row, 1.5).empty());
    CHECK(contourSegments(1, 1, row, 0.0).empty());
}
