// From metres on the ground to pixels of the window, and back.
#pragma once

#include <muster/vec2.h>

#include <algorithm>

namespace game {

using muster::Vec2;

/// Shows a rectangle of the ground as large as the window allows; y points up.
class Camera {
public:
    Camera(Vec2 extent, int width, int height)
        : scale_(std::min(width / extent.x, height / extent.y)), centre_{0.5 * width, 0.5 * height} {}

    double scale() const { return scale_; }  ///< Pixels per metre.
    Vec2 toWindow(Vec2 p) const { return {centre_.x + scale_ * p.x, centre_.y - scale_ * p.y}; }
    Vec2 toGround(Vec2 p) const { return {(p.x - centre_.x) / scale_, (centre_.y - p.y) / scale_}; }

private:
    double scale_;
    Vec2 centre_;
};

}  // namespace game
