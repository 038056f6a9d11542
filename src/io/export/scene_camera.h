// A camera that sees a crowd and all its way, as the studio's does.
#pragma once

#include <limits>

#include "muster/vec3.h"

namespace muster {

inline constexpr double kSeenHeight = 1.8;  ///< Height of a character that the camera has in view [m].

/// A camera that stands still; it looks along `forward`.
struct SceneCamera {
    Vec3 eye;    ///< [m]
    Vec3 right;  ///< Unit, as are up and forward; at right angles.
    Vec3 up;
    Vec3 forward;
    double fieldOfView = 0;  ///< Vertical [rad].
    double aspect = 0;       ///< Width over height.
    double farthest = 0;     ///< Nothing beyond is seen [m].
};

/// Finds the place from which all points given are seen: 24 degrees of view, looking 46 degrees down.
class CameraFit {
public:
    CameraFit();
    /// One more point to be seen [m].
    void add(Vec3 point);
    /// The nearest camera that sees all points, with some room round them. At least one point.
    SceneCamera camera() const;

private:
    /// Edges of the view in one direction: all points lie between these.
    struct Reach {
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();
    };
    SceneCamera view_;
    double across_ = 0.0, along_ = 0.0;  ///< Slopes of the view's sides, less the room.
    Reach sideways_, upright_;
    double nearest_ = std::numeric_limits<double>::infinity();
};

}  // namespace muster
