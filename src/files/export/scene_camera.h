// A camera that sees all positions of a crowd, like the studio's.
#pragma once

#include <limits>

#include "muster/vec3.h"

namespace muster {

/// The direction of the studio's view as it opens.
inline constexpr double kViewTurn = 0.33;                                    ///< From +y to the left [rad].
inline constexpr double kViewPitch = 46.0 / 180.0 * 3.14159265358979323846;  ///< Looking down [rad].
inline constexpr double kViewAngle = 24.0 / 180.0 *
                                     3.14159265358979323846;  ///< Vertical angle of view [rad].

inline constexpr double kSeenHeight = 1.8;  ///< Height of a character that the camera keeps in view [m].

/// A fixed camera; it looks along `forward`.
struct SceneCamera {
    Vec3 eye;    ///< [m]
    Vec3 right;  ///< Unit vectors, orthogonal to each other.
    Vec3 up;
    Vec3 forward;
    double fieldOfView = 0;  ///< Vertical angle of view [rad].
    double aspect = 0;       ///< Width divided by height.
    double farthest = 0;     ///< Distance of the far plane [m].
};

/// Finds the camera that sees all given points, with 24 degrees of view and looking 46 degrees down.
class CameraFit {
public:
    CameraFit();
    /// Adds a point [m].
    void add(Vec3 point);
    /// The nearest camera that sees all points with a margin. Needs at least one point.
    SceneCamera camera() const;

private:
    /// Bounds of the view in one direction: all points lie between them.
    struct Reach {
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();
    };
    SceneCamera view_;
    double across_ = 0.0, along_ = 0.0;  ///< Slopes of the view's sides, less the margin.
    Reach sideways_, upright_;
    double nearest_ = std::numeric_limits<double>::infinity();
};

}  // namespace muster
