#include "engine/formation/places/target_shift.h"

#include <doctest.h>

using namespace muster;

namespace {

std::vector<Vec2> square(Vec2 centre, int side) {
    std::vector<Vec2> points;
    for (int k = 0; k < side * side; ++k)
        points.push_back(centre + Vec2{k % side - 0.5 * (side - 1), k / side - 0.5 * (side - 1)});
    return points;
}

bool anywhere(Vec2) {
    return true;
}

}  // namespace

TEST_CASE("of two squares on one spot one settles just beside the other") {
    const auto points = square({0, 0}, 8), others = square({0.1, 0}, 8);
    TargetShift beside;
    beside.begin(points);
    beside.add(others);
    REQUIRE(beside.clashes({}, 0.5));
    const Vec2 shift = beside.find(0.5, 1.0, anywhere);
    CHECK_FALSE(beside.clashes(shift, 0.999));
    CHECK(length(shift) == doctest::Approx(7.9));  // To the left, where less is needed.
    CHECK(shift.x < 0.0);
}

TEST_CASE(
    "a group inside a ring of another does not clash; among several it passes all that are in the way") {
    std::vector<Vec2> ring;
    for (int k = 0; k < 40; ++k) ring.push_back(Vec2{8.0 * ((k / 10) % 2 == 0 ? 1 : -1), k % 10 - 4.5});
    const auto inside = square({0, 0}, 4);
    TargetShift free;
    free.begin(inside);
    free.add(ring);
    CHECK_FALSE(free.clashes({}, 0.5));
    const auto middle = square({0, 0}, 4), left = square({-5, 0}, 4), right = square({5, 0}, 4),
               points = square({0.2, 0.1}, 4);
    TargetShift beside;
    beside.begin(points);
    for (const auto* others : {&middle, &left, &right}) beside.add(*others);
    const Vec2 shift = beside.find(0.5, 1.0, anywhere);
    CHECK_FALSE(beside.clashes(shift, 0.5));
    CHECK(length(shift) < 4.5);  // Between the rows above and below, not past left or right.
    const Vec2 blocked = beside.find(0.5, 1.0, [](Vec2 p) { return p.x > 6.0; });
    CHECK_FALSE(beside.clashes(blocked, 0.5));
    CHECK(blocked.x > 6.0);
}
