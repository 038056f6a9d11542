// Which of several places a character walks to.
#include "engine/assignment/planning/main_places.h"

#include <doctest.h>

using namespace muster;

namespace {

std::vector<std::int32_t> mainPlaces(const std::vector<Flow>& flows,
                                     const std::vector<std::int32_t>& incumbent) {
    std::vector<std::int32_t> place;
    findMainPlaces(flows, incumbent, place);
    return place;
}

}  // namespace

TEST_CASE("a character walks to the place of its largest flow, of equal ones to the first") {
    const std::vector<Flow> flows{{0, 2, 0.5}, {0, 4, 1.5}, {2, 1, 1.0}, {2, 3, 1.0}};
    CHECK(mainPlaces(flows, {-1, -1, -1}) == std::vector<std::int32_t>{4, -1, 1});
    CHECK(mainPlaces({}, {3, 1}) == std::vector<std::int32_t>{-1, -1});
}

TEST_CASE("it keeps its place while that gets nearly as much") {
    const std::vector<std::int32_t> third{3}, first{1};
    CHECK(mainPlaces({{0, 1, 1.0}, {0, 3, 1.0}}, third) == third);
    CHECK(mainPlaces({{0, 1, 1.1}, {0, 3, 1.0}}, third) == third);
    CHECK(mainPlaces({{0, 1, 1.0}, {0, 3, 1.1}}, first) == first);
    CHECK(mainPlaces({{0, 1, 2.0}, {0, 3, 1.0}}, third) == first);
    CHECK(mainPlaces({{0, 1, 2.0}}, third) == first);
}
