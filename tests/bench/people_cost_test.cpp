// The bench of the law of people: both laws walk, and people slow down where they are many.
#include "scale/people.h"

#include <doctest.h>

using namespace muster::scale;

TEST_CASE("the bench of people measures both laws on the same ring") {
    const auto rows = measurePeople({{200}, {0.5, 4.0}, 1});
    REQUIRE(rows.ok());
    REQUIRE(rows->size() == 2);
    for (const PeopleRow& row : *rows) {
        CHECK(row.ratio() > 0.0);
        CHECK(row.unitsSpeed > 0.8);
    }
    CHECK((*rows)[0].peopleSpeed > 0.9);
    CHECK((*rows)[1].peopleSpeed < 0.4);
    CHECK(peopleText(*rows).find("ratio") != std::string::npos);
}
