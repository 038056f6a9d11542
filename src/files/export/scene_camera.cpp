#include "files/export/scene_camera.h"

#include <algorithm>

#include "base/maths.h"

namespace muster {
namespace {

constexpr double kAspect = 16.0 / 9.0;
constexpr double kFilled = 0.92;   // Share of the picture that the points fill.
constexpr double kNearest = 8.0;   // Least distance from the eye to a point [m].
constexpr double kBeyond = 500.0;  // Visible distance behind the farthest point [m].

Vec3 unit(double x, double y, double z) {
    return normalized(Vec3{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
}

}  // namespace

CameraFit::CameraFit() {
    const double st = sine(kViewTurn), ct = cosine(kViewTurn), sp = sine(kViewPitch), cp = cosine(kViewPitch);
    view_.right = unit(ct, st, 0.0);
    view_.up = unit(-st * sp, ct * sp, cp);
    view_.forward = unit(-st * cp, ct * cp, -sp);
    view_.fieldOfView = kViewAngle;
    view_.aspect = kAspect;
    along_ = kFilled * sine(0.5 * kViewAngle) / cosine(0.5 * kViewAngle);
    across_ = kAspect * along_;
}

void CameraFit::add(Vec3 point) {
    const double f = dot(point, view_.forward), r = dot(point, view_.right), u = dot(point, view_.up);
    // The eye e sees the point where |r - e.r| <= across (f - e.f). Both sides bound e.r against e.f.
    sideways_.low = std::min(sideways_.low, r + across_ * f);
    sideways_.high = std::max(sideways_.high, r - across_ * f);
    upright_.low = std::min(upright_.low, u + along_ * f);
    upright_.high = std::max(upright_.high, u - along_ * f);
    nearest_ = std::min(nearest_, f);
}

SceneCamera CameraFit::camera() const {
    const double f = std::min({(sideways_.low - sideways_.high) / (2.0 * across_),
                               (upright_.low - upright_.high) / (2.0 * along_), nearest_ - kNearest});
    const double r = 0.5 * (sideways_.low + sideways_.high), u = 0.5 * (upright_.low + upright_.high);
    SceneCamera camera = view_;
    camera.eye = view_.forward * static_cast<float>(f) + view_.right * static_cast<float>(r) +
                 view_.up * static_cast<float>(u);
    camera.farthest = 4.0 * (nearest_ - f) + kBeyond;
    return camera;
}

}  // namespace muster
