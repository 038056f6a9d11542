// Ways of formations against the geometry of their scenes.
#include "engine/orders/way_search.h"

#include <doctest.h>

#include "base/random.h"
#include "engine/orders/way_searches.h"

using namespace muster;

namespace {

ObstacleDef wall(double x0, double y0, double x1, double y1) {
    return {.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

Environment ground(const std::vector<ObstacleDef>& obstacles, double half = 40.0) {
    Environment environment = Environment::create({.box = {{-half, -half}, {half, half}}}).value();
    for (const ObstacleDef& obstacle : obstacles) REQUIRE(environment.addObstacle(obstacle).ok());
    environment.setTime(0.0);
    return environment;
}

WayNeeds needs(double half, double least = 0.0) {
    return {.half = half, .margin = 1.0, .least = least};
}

double lengthOf(const std::vector<Vec2>& way) {
    double sum = 0.0;
    for (std::size_t k = 1; k < way.size(); ++k) sum += distance(way[k - 1], way[k]);
    return sum;
}

/// The least distance of a way to a set of boxes, by samples.
double leastRoom(const Environment& environment, const std::vector<Vec2>& way) {
    double least = 1e9;
    for (std::size_t k = 1; k < way.size(); ++k)
        for (int s = 0; s <= 100; ++s)
            least = std::min(least,
                             environment.distanceToObstacle(lerp(way[k - 1], way[k], s / 100.0), 50.0));
    return least;
}

std::vector<Vec2> search(const Environment& environment, Vec2 from, Vec2 to, const WayNeeds& n,
                         std::int32_t cells = 1 << 20) {
    WayGround map;
    map.update(environment);
    WaySearch search;
    search.start(map, {from, to, n});
    while (search.advance(map, cells) == WayStatus::Searching) {
    }
    return search.path();
}

}  // namespace

TEST_CASE(
    "clearances are those of the geometry near obstacles, and lower bounds or nearly exact far from them") {
    const Environment environment = ground({wall(-10, -10, 10, 10)});
    WayGround map;
    map.update(environment);
    Random random(5);
    for (int k = 0; k < 400; ++k) {
        const Vec2 p{random.uniform(-39, 39), random.uniform(-39, 39)};
        const double edge = 40.0 - std::max(std::fabs(p.x), std::fabs(p.y));
        const double exact = std::min(edge, environment.distanceToObstacle(p, 100.0));
        CAPTURE(p.x);
        CAPTURE(p.y);
        CHECK(map.clearanceAt(p) <= 1.06 * std::max(exact, 0.0) + 0.4);
        if (exact > 0.0) CHECK(map.clearanceAt(p) >= 0.9 * exact - 0.8);
    }
}

TEST_CASE("the way round a house keeps half a width, and is hardly longer than the shortest such way") {
    const Environment environment = ground({wall(-10, -10, 10, 10)});
    for (const double half : {0.5, 2.0, 5.0}) {
        const auto way = search(environment, {-35, 0}, {35, 0}, needs(half));
        REQUIRE(way.size() >= 3);
        CHECK(way.front() == Vec2{-35, 0});
        CHECK(way.back() == Vec2{35, 0});
        CHECK(leastRoom(environment, way) >= half - 0.5);
        // Tangents to the discs of half a width about the corners, and the arcs of these, from above.
        const double corner = 2.0 * (distance({-35, 0}, {-10, 10 + half}) + 10.0);
        CHECK(lengthOf(way) <= corner + 2.0);
    }
}

TEST_CASE("a formation goes through a gap that is wide enough, and round one where it may not narrow") {
    // A wall with a gap of 4 m in the middle and one of 14 m at its end.
    const Environment environment = ground({wall(-1, -40, 1, -2), wall(-1, 2, 1, 26)});
    const auto crossing = [](const std::vector<Vec2>& way) {
        for (std::size_t k = 1; k < way.size(); ++k)
            if (way[k - 1].x <= 0.0 && way[k].x > 0.0)
                return lerp(way[k - 1], way[k], -way[k - 1].x / (way[k].x - way[k - 1].x)).y;
        return 1e9;
    };
    CHECK(std::fabs(crossing(search(environment, {-20, 0}, {20, 0}, needs(1.0)))) < 1.0);
    CHECK(std::fabs(crossing(search(environment, {-20, 0}, {20, 0}, needs(5.0)))) < 1.0);
    const double stiff = crossing(search(environment, {-20, 0}, {20, 0}, needs(5.0, 1.0)));
    CHECK(stiff > 30.0);
    CHECK(stiff < 36.0);
    // Where there is no other way it goes through all the same.
    const Environment closed = ground({wall(-1, -40, 1, -2), wall(-1, 2, 1, 40)});
    CHECK(std::fabs(crossing(search(closed, {-20, 0}, {20, 0}, needs(5.0, 1.0)))) < 1.0);
}

TEST_CASE("where nothing leads to the goal there is no way") {
    const Environment environment = ground({wall(-1, -40, 1, 40)});
    CHECK(search(environment, {-20, 0}, {20, 0}, needs(1.0)).empty());
}

TEST_CASE("a search in small shares finds the same way, bit for bit") {
    Random random(9);
    for (int scene = 0; scene < 10; ++scene) {
        std::vector<ObstacleDef> walls;
        for (int k = 0; k < 25; ++k) {
            const Vec2 p{random.uniform(-30, 25), random.uniform(-38, 32)};
            walls.push_back(wall(p.x, p.y, p.x + random.uniform(1, 8), p.y + random.uniform(1, 8)));
        }
        const Environment environment = ground(walls);
        const WayNeeds n = needs(random.uniform(0.3, 4.0));
        const auto whole = search(environment, {-38, -38}, {38, 38}, n);
        CHECK(search(environment, {-38, -38}, {38, 38}, n, 7) == whole);
        if (!whole.empty()) CHECK(leastRoom(environment, whole) >= n.radius - 1e-3);
        for (const Vec2 p : whole) CHECK(isFinite(p));
    }
}

TEST_CASE("a search that is asked for again counts as it did, whatever is known of it") {
    const Environment environment = ground({wall(-10, -10, 10, 10), wall(-20, 5, -15, 30)});
    WayGround map;
    map.update(environment);
    const WayQuery query{{-35, 0}, {35, 0}, needs(2.0)}, other{{-35, 30}, {35, -30}, needs(1.0)};
    // Plays a search in shares of so many cells from where `searched` of them are done.
    const auto play = [&](WaySearches& searches, const WayQuery& asked, std::int32_t searched,
                          std::int32_t cells) {
        std::vector<std::int32_t> done;
        while (searches.advance(map, asked, searched, cells) == WayStatus::Searching)
            done.push_back(searched = searches.searched());
        done.push_back(searches.searched());
        return done;
    };
    WaySearches first, again;
    const auto whole = play(first, query, 0, 50);
    const std::vector<Vec2> path = first.path();
    CHECK(path == search(environment, query.from, query.to, query.needs));
    REQUIRE(whole.size() > 4);
    play(first, other, 0, 77);
    CHECK(play(first, query, 0, 50) == whole);
    CHECK(first.path() == path);
    // Of one that is under way, too, and of one that nobody knows.
    for (std::int32_t k = 0; k < 3; ++k) again.advance(map, query, 50 * k, 50);
    CHECK(play(again, query, 50, 50) == std::vector<std::int32_t>(whole.begin() + 1, whole.end()));
    CHECK(again.path() == path);
    WaySearches unknown;
    CHECK(play(unknown, query, 150, 50) == std::vector<std::int32_t>(whole.begin() + 3, whole.end()));
}
