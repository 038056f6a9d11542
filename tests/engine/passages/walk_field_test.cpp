// Walks to passages, against lengths that are known.
#include <doctest.h>

#include <span>
#include <type_traits>

#include "engine/passages/passage_scene.h"
#include "engine/passages/walk_field.h"

using namespace muster;
using namespace muster::testing;

namespace {

WalkEdges edgesOf(const StaticGround& ground, std::span<const Passage> closed) {
    WalkEdges edges;
    edges.open(ground.coarse());
    for (const Passage& passage : closed) edges.close(passage);
    return edges;
}

/// From a passage, which is closed too, or a point.
template <class Source>
void solve(const StaticGround& ground, const Source& source, std::span<const Passage> closed,
           WalkField& field) {
    WalkEdges edges = edgesOf(ground, closed);
    if constexpr (std::is_same_v<Source, Passage>) edges.close(source);
    WalkSolver solver;
    solver.begin(ground.coarse(), edges, source, field);
    std::int64_t cells = ground.coarse().grid.count();
    solver.advance(ground.coarse(), field, cells);
}

}  // namespace

TEST_CASE("walks to a door are as long as straight lines, and tell the side") {
    const Environment environment = walledFloor({{-1, 1}});
    const StaticGround ground = groundOf(environment);
    const Passage door{{0, -1}, {0, 1}, 1.0};
    WalkField field;
    solve(ground, door, {}, field);
    for (const Vec2 p : {Vec2{-10, 0}, Vec2{-6, 8}, Vec2{-15, -12}, Vec2{9, 3}, Vec2{4, -14}}) {
        const double beside = std::max(0.0, std::abs(p.y) - 1.0);
        const double straight = std::sqrt(p.x * p.x + beside * beside);
        CHECK(field.at(p).cost == doctest::Approx(straight).epsilon(0.09));
        CHECK(field.at(p).side == (p.x < 0 ? 1 : -1));  // Up from a to b, the left is at negative x.
    }
    // Near the line the side is exact, however wide the cells are.
    CHECK(field.at({-0.01, 0.3}).side == 1);
    CHECK(field.at({0.01, 0.3}).side == -1);
}

TEST_CASE(
    "closed passages part rooms: no walk leads round, also where their line runs through cell centres") {
    const Environment environment = walledFloor({{-10, -8}, {-1, 1}});
    const StaticGround ground = groundOf(environment);
    const double centre = ground.coarse().grid.centre(ground.coarse().grid.cellOf({0.1, 0.0})).x;
    for (const double x : {-0.5, -0.25, 0.0, 0.25, centre, 0.5}) {
        const Passage door{{x, -1}, {x, 1}, 1.0};
        const Passage other{{x, -8}, {x, -10}, 1.0};
        WalkField field;
        solve(ground, door, std::span(&other, 1), field);
        for (const double y : {-15.0, -9.0, 0.0, 12.0}) {
            CHECK(field.at({-8, y}).side == 1);
            CHECK(field.at({8, y}).side == -1);
        }
        // From a point, the other room is out of reach.
        const Passage both[] = {door, other};
        solve(ground, Vec2{-10, 0}, both, field);
        CHECK(field.at({-5, 5}).cost < 12.0);
        CHECK_FALSE(field.at({5, 5}).cost < 1e6);
        std::vector<Vec2> path;
        field.trace({5, 5}, 1000, path);
        CHECK(path.empty());
    }
}

TEST_CASE("the traced way leads to the source without crossing a wall") {
    const Environment environment = walledFloor({{5, 7}});
    const StaticGround ground = groundOf(environment);
    WalkField field;
    solve(ground, Vec2{10, -5}, {}, field);
    std::vector<Vec2> path;
    field.trace({-10, -5}, 1000, path);
    REQUIRE(path.size() > 2);
    CHECK(distance(path.back(), {10, -5}) < 1.0);
    for (std::size_t k = 1; k < path.size(); ++k) CHECK(ground.collisionFree(path[k - 1], path[k]));
}

TEST_CASE("a march in pieces gives the same bits as one at once") {
    const Environment environment = walledFloor({{-10, -8}, {-1, 1}});
    const StaticGround ground = groundOf(environment);
    const WalkEdges edges = edgesOf(ground, {});
    WalkField whole, pieces;
    solve(ground, Vec2{10, -5}, {}, whole);
    WalkSolver solver;
    solver.begin(ground.coarse(), edges, Vec2{10, -5}, pieces);
    std::int64_t solved = 0;
    for (bool ended = false; !ended;) {
        std::int64_t cells = 137;
        ended = solver.advance(ground.coarse(), pieces, cells);
        solved += 137 - cells;
        CHECK(cells >= 0);
    }
    CHECK(solved <= ground.coarse().grid.count());
    for (double x = -19.7; x < 20.0; x += 0.61)
        for (double y = -19.3; y < 20.0; y += 0.67) {
            CHECK(whole.at({x, y}).cost == pieces.at({x, y}).cost);
            CHECK(whole.at({x, y}).side == pieces.at({x, y}).side);
        }
}

TEST_CASE("a march that may stop at some points holds there, and solves less") {
    const Environment environment = walledFloor({{5, 7}});
    const StaticGround ground = groundOf(environment);
    const WalkEdges edges = edgesOf(ground, {});
    WalkField whole, part;
    solve(ground, Vec2{10, -5}, {}, whole);
    WalkSolver solver;
    const auto march = [&](auto limit) {
        solver.begin(ground.coarse(), edges, Vec2{10, -5}, part);
        limit();
        std::int64_t cells = ground.coarse().grid.count();
        CHECK(solver.advance(ground.coarse(), part, cells));
        return ground.coarse().grid.count() - cells;
    };
    const std::int64_t all = march([] {});
    const Vec2 points[] = {{6, -9}, {3, 2}, {0.1, 6.0}};
    const std::int64_t some = march([&] {
        for (const Vec2 p : points) solver.stopAt(p, part);
    });
    CHECK(some < all / 2);
    for (const Vec2 p : points) CHECK(part.at(p).cost == whole.at(p).cost);
    // Beyond a cost nothing is cheaper than that.
    CHECK(march([&] { solver.stopBeyond(9.0); }) < all / 3);
    CHECK(part.at({6, -9}).cost == whole.at({6, -9}).cost);
    CHECK_FALSE(part.at({-10, 0}).cost < 9.0);
    // A point in the wall takes what is near by.
    march([&] { solver.stopAt({0, -5}, part); });
    CHECK(part.at({0, -5}).cost == whole.at({0, -5}).cost);
}
