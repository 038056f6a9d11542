// Measures gaps of moving obstacles to characters, and the distance at which a mesh gives way to them.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/world.h"

namespace muster {

/// Measures all moving obstacles of a world of one group. The number of characters and the mesh must not
/// change.
class CarWatch {
public:
    /// Call before the first step.
    explicit CarWatch(const World& world);
    /// Call after every step. Each car is measured twice: at its position when contacts were resolved, and at
    /// that of the end of the step.
    void observe(const World& world);

    /// Smallest gap between anybody's disc and a car's surface [m], at most kFar; 0 and less for contacts.
    double smallest() const;
    /// Mean over the characters of their smallest gaps [m].
    double meanSmallest() const;
    /// Number of characters that a car came nearer to than `gap` [m] <= kFar.
    std::int32_t nearer(double gap) const;
    /// Mean distance between a car and a vertex of the user mesh at the moment when the final mesh begins to
    /// differ there by 0.1 m [m]; NaN where it never did.
    double givesWayFrom() const;

    static constexpr double kFar = 3.0;  ///< Greatest gap that is measured [m].

private:
    void watchMesh(const World& world);

    std::vector<double> smallest_;         // By character.
    std::vector<std::uint8_t> displaced_;  // By vertex.
    double sum_ = 0.0;
    std::int64_t count_ = 0;
};

}  // namespace muster
