#include <doctest.h>

#include "engine/ground/environment/environment.h"

using namespace muster;

TEST_CASE("field defaults apply to obstacles that give none, and only to those") {
    EnvironmentDef def{.defaultRange = 1.0};
    Environment environment = Environment::create(def).value();
    ObstacleDef plain{.radius = 1.0};
    ObstacleDef own = plain;
    own.centre = {8, 0};
    own.range = 1.0;
    REQUIRE(environment.addObstacle(plain).ok());
    REQUIRE(environment.addObstacle(own).ok());
    environment.setTime(0.0);
    CHECK(environment.potentialField({0, 2.5}).y == 0.0);
    environment.setFieldDefaults(2.0, 3.0);
    CHECK(environment.potentialField({0, 2.5}).y == doctest::Approx(3.0 * (1.0 - 1.5 / 2.0)));
    CHECK(environment.potentialField({8, 2.5}).y == doctest::Approx(0.0));
    environment.setFieldDefaults(-1.0, 1.0);
    CHECK(environment.def().defaultRange == 2.0);
}
