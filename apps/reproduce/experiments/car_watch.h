// How near moving obstacles come to characters, and from how far a mesh gives way to them.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/world.h"

namespace muster {

/// Watches everything that moves in a world of one group. The number of characters and the mesh must not
/// change.
class CarWatch {
public:
    /// Call before the first step.
    explicit CarWatch(const World& world);
    /// Call after every step. Cars are looked at where they stood when contacts were resolved, and where they
    /// stand once the step is over.
    void observe(const World& world);

    /// Smallest gap between anybody's disc and a car's surface [m], at most kFar; 0 and less for contacts.
    double smallest() const;
    /// Mean over all of each one's smallest gap [m].
    double meanSmallest() const;
    /// Characters that a car came nearer to than `gap` [m] <= kFar.
    std::int32_t nearer(double gap) const;
    /// Mean distance between a car and where the user wants a vertex, at the moments when one that stood in
    /// its place begins to give way (0.1 m) [m]; NaN where none did.
    double givesWayFrom() const;

    static constexpr double kFar = 3.0;  ///< Gaps are known up to this [m].

private:
    void watchMesh(const World& world);

    std::vector<double> smallest_;         // By character.
    std::vector<std::uint8_t> displaced_;  // By vertex.
    double sum_ = 0.0;
    std::int64_t count_ = 0;
};

}  // namespace muster
