// Worlds that the tests of places share.
#pragma once

#include "engine/formation/mesh_fixture.h"
#include "engine/formation/places/place_tracker.h"

namespace muster::test {

inline Environment emptyWorld(double half = 16.0) {
    return *Environment::create({.box = {{-half, -half}, {half, half}}});
}

/// The routes of an environment as it is now.
inline RouteGraph& routes(const Environment& environment, double radius = 0.25) {
    static RouteGraph graph;
    graph.update(environment, radius);
    return graph;
}

inline ObstacleDef box(Vec2 min, Vec2 max) {
    return {.polygon = {min, {max.x, min.y}, max, {min.x, max.y}}};
}

inline double closestPair(const PlaceTracker& places) {
    double least = 1e300;
    for (std::size_t i = 0; i < places.positions().size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (places.fit()[i] != 0 && places.fit()[j] != 0)
                least = std::min(least, distance(places.positions()[i], places.positions()[j]));
    return least;
}

}  // namespace muster::test
