#include "studio/gestures/input_event.h"

#include <cmath>

namespace muster {
namespace {

constexpr double kLeastDepth = 1e-9;  // Points beside or behind the camera have less.

using Matrix = std::array<double, 9>;

double determinant(const Matrix& m) {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
           m[2] * (m[3] * m[7] - m[4] * m[6]);
}

// The inverse but for its factor, which homogeneous coordinates do not need; its sign is that of the inverse.
Matrix inverseOf(const Matrix& m) {
    const double sign = determinant(m) < 0.0 ? -1.0 : 1.0;
    return {sign * (m[4] * m[8] - m[5] * m[7]), sign * (m[2] * m[7] - m[1] * m[8]),
            sign * (m[1] * m[5] - m[2] * m[4]), sign * (m[5] * m[6] - m[3] * m[8]),
            sign * (m[0] * m[8] - m[2] * m[6]), sign * (m[2] * m[3] - m[0] * m[5]),
            sign * (m[3] * m[7] - m[4] * m[6]), sign * (m[1] * m[6] - m[0] * m[7]),
            sign * (m[0] * m[4] - m[1] * m[3])};
}

std::optional<Vec2> project(const Matrix& m, Vec2 p) {
    const double w = m[6] * p.x + m[7] * p.y + m[8];
    if (!(w > kLeastDepth)) return std::nullopt;
    const Vec2 q{(m[0] * p.x + m[1] * p.y + m[2]) / w, (m[3] * p.x + m[4] * p.y + m[5]) / w};
    return std::isfinite(q.x) && std::isfinite(q.y) ? std::optional<Vec2>(q) : std::nullopt;
}

}  // namespace

GroundView GroundView::fromAbove(Vec2 middle, double pixelsPerMetre, double width, double height,
                                 double mmPerPixel) {
    GroundView view;
    view.toScreen = {pixelsPerMetre,
                     0.0,
                     0.5 * width - pixelsPerMetre * middle.x,
                     0.0,
                     -pixelsPerMetre,
                     0.5 * height + pixelsPerMetre * middle.y,
                     0.0,
                     0.0,
                     1.0};
    view.width = width;
    view.height = height;
    view.mmPerPixel = mmPerPixel;
    return view;
}

std::optional<Vec2> GroundView::screenOf(Vec2 ground) const {
    return project(toScreen, ground);
}

std::optional<Vec2> GroundView::groundAt(Vec2 screen) const {
    return project(inverseOf(toScreen), screen);
}

bool GroundView::valid() const {
    for (const double number : toScreen)
        if (!std::isfinite(number)) return false;
    const double d = determinant(toScreen);
    return std::isfinite(d) && d != 0.0 && width > 0.0 && height > 0.0 && mmPerPixel > 0.0 &&
           std::isfinite(width) && std::isfinite(height) && std::isfinite(mmPerPixel);
}

}  // namespace muster
