// Measures the opening of Pacman's mouth by his mesh.
#pragma once

#include <cstdint>
#include <span>

#include "engine/geometry/triangulation.h"

namespace muster {

/// Vertices of a Pacman mesh that faces +x at rest, its mouth being symmetric about the x axis.
struct Mouth {
    std::int32_t hinge = 0;  ///< Vertex at which the lips meet: the foremost one on the axis.
    std::int32_t upper = 0;  ///< Tip of the upper lip: the foremost vertex above the axis.
    std::int32_t lower = 0;  ///< Tip of the lower lip: the foremost vertex below the axis.

    /// Finds the three vertices.
    explicit Mouth(const TriangleMesh& rest);
    /// Angle at the hinge from the lower lip to the upper, through the mouth [rad], 0 to 2 pi, of the
    /// vertices as they are now.
    double angle(std::span<const Vec2> vertices) const;
};

/// Counts openings with hysteresis: each must be preceded by a closing.
class OpeningCounter {
public:
    /// The mouth is shut below `shut` and open above `open` > shut [rad].
    OpeningCounter(double shut, double open) : shut_(shut), open_(open) {}
    /// Takes the angle of the next step [rad].
    void observe(double angle);
    std::int32_t openings() const { return openings_; }  ///< Number of openings so far.

private:
    double shut_, open_;
    bool wasShut_ = false;
    std::int32_t openings_ = 0;
};

}  // namespace muster
