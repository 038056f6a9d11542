#include "engine/assignment/transport/dynamic/assignment_nodes.h"

#include <doctest.h>

using namespace muster;

TEST_CASE("nodes follow places that close and characters that leave") {
    AssignmentNodes nodes;
    nodes.reset(4, 3);
    CHECK(nodes.count() == 4);
    const std::vector<Vec2> characters(4), places(3);
    std::vector<std::uint8_t> usable{1, 1, 1};
    std::vector<std::uint8_t> present{1, 1, 1, 1};
    std::vector<std::int32_t> changed;
    nodes.assignPlaces(std::vector<std::int32_t>{2, 2, -1, 0});  // Two name one place: the first has it.
    nodes.update({characters, places, usable, present}, changed);
    CHECK(changed == std::vector<std::int32_t>{0, 1, 2});  // They have become places.
    CHECK(nodes.unmatched() == std::vector<std::int32_t>{1, 2});
    CHECK(nodes.freePlaces() == std::vector<std::int32_t>{1});
    nodes.match(2, 1);
    nodes.assignDummyNodes();
    CHECK(nodes.nodeOf(1) == 3);
    CHECK_FALSE(nodes.isMatched(3));
    CHECK(nodes.isMatched(1));

    changed.clear();
    usable[2] = 0;
    present[3] = 0;
    nodes.update({characters, places, usable, present}, changed);
    CHECK(changed == std::vector<std::int32_t>{2, 0});  // One closed, one lost its assignee.
    CHECK(nodes.unmatched() == std::vector<std::int32_t>{0, 1});
    CHECK(nodes.freePlaces() == std::vector<std::int32_t>{0});
    nodes.match(0, 0);
    CHECK(nodes.assignee(2) == -1);
    CHECK(nodes.assignee(0) == 0);
}
