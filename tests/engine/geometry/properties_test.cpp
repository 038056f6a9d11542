// Properties over random polygons (rapidcheck).
#include <doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "base/maths.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/triangulation.h"

using namespace muster;

namespace {

// Any corners on a coarse lattice: repeats, straight runs and crossings are common.
Polygon latticePolygon() {
    Polygon polygon;
    for (const auto& [x, y] : *rc::gen::container<std::vector<std::pair<int, int>>>(
             rc::gen::pair(rc::gen::inRange(-6, 7), rc::gen::inRange(-6, 7)))) {
        polygon.push_back({0.5 * x, 0.5 * y});
    }
    return polygon;
}

// A simple polygon round the origin.
Polygon starPolygon() {
    const auto radii = *rc::gen::container<std::vector<int>>(*rc::gen::inRange<std::size_t>(3, 16),
                                                             rc::gen::inRange(1, 50));
    Polygon polygon;
    for (std::size_t i = 0; i < radii.size(); ++i) {
        const double angle = 2.0 * kPi * static_cast<double>(i) / static_cast<double>(radii.size());
        polygon.push_back(Vec2{cosine(angle), sine(angle)} * (0.1 * radii[i]));
    }
    return polygon;
}

}  // namespace

TEST_CASE("property: whatever cleanPolygon accepts is decomposed and meshed exactly") {
    CHECK(rc::check([] {
        const auto clean = cleanPolygon(latticePolygon());
        if (!clean.ok()) {
            RC_ASSERT(!clean.status().message().empty());
            return;
        }
        const double area = signedArea(*clean);
        RC_ASSERT(area > 0.0);
        const auto parts = decomposeConvex(*clean);
        RC_ASSERT(parts.ok());
        double sum = 0.0;
        for (const Polygon& part : *parts) {
            RC_ASSERT(isConvex(part));
            sum += signedArea(part);
        }
        RC_ASSERT(std::fabs(sum - area) < 1e-9);
        const auto mesh = triangulate({*clean, {}}, 0.7);
        RC_ASSERT(mesh.ok());
        sum = 0.0;
        for (const Triangle& t : mesh->triangles)
            sum += 0.5 * cross(mesh->vertices[t[1]] - mesh->vertices[t[0]],
                               mesh->vertices[t[2]] - mesh->vertices[t[0]]);
        RC_ASSERT(std::fabs(sum - area) < 1e-9);
    }));
}

TEST_CASE("property: star polygons are decomposed, meshed and weighed") {
    CHECK(rc::check([] {
        const Polygon star = starPolygon();
        const auto clean = cleanPolygon(star);
        RC_ASSERT(clean.ok());
        const auto parts = decomposeConvex(star);
        RC_ASSERT(parts.ok());
        double sum = 0.0;
        for (const Polygon& part : *parts) sum += signedArea(part);
        RC_ASSERT(std::fabs(sum - signedArea(star)) < 1e-9);
        RC_ASSERT(triangulate({star, {}}, 0.9).ok());
        const Vec2 p{*rc::gen::inRange(-500, 500) * 0.01, *rc::gen::inRange(-500, 500) * 0.01};
        std::vector<double> weights(star.size());
        meanValueCoordinates(star, p, weights);
        Vec2 where;
        double total = 0.0;
        for (std::size_t i = 0; i < star.size(); ++i) {
            where += star[i] * weights[i];
            total += weights[i];
        }
        // Outside the weights may grow as their sum passes near zero, and rounding with them.
        const double tolerance = containsPoint(star, p) ? 1e-9 : 1e-5;
        RC_ASSERT(std::fabs(total - 1.0) < tolerance);
        RC_ASSERT(distance(where, p) < tolerance);
    }));
}
