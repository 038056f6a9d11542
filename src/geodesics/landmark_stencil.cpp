#include "geodesics/landmark_stencil.h"

#include <algorithm>

namespace muster {
namespace {

// Keeps weights small where landmarks lie almost in a line, as a share of their spread.
constexpr double kRidge = 0.02;

}  // namespace

LandmarkStencil weighLandmarks(std::span<const Landmark> landmarks, bool square, Vec2 place, float unit) {
    LandmarkStencil stencil;
    stencil.count = static_cast<std::int32_t>(landmarks.size());
    if (landmarks.empty()) return stencil;
    const double share = 1.0 / static_cast<double>(landmarks.size());
    double weight[4] = {share, share, share, share};
    if (square && landmarks.size() == 4) {
        const Vec2 edge = landmarks[3].at - landmarks[0].at;
        const double fx = std::clamp((place.x - landmarks[0].at.x) / edge.x, 0.0, 1.0);
        const double fy = std::clamp((place.y - landmarks[0].at.y) / edge.y, 0.0, 1.0);
        const double bilinear[4] = {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy};
        std::copy(bilinear, bilinear + 4, weight);
    } else if (landmarks.size() > 1) {
        Vec2 mean;
        for (const Landmark& l : landmarks) mean += l.at * share;
        double xx = 0.0, xy = 0.0, yy = 0.0;
        for (const Landmark& l : landmarks) {
            const Vec2 d = l.at - mean;
            xx += d.x * d.x;
            xy += d.x * d.y;
            yy += d.y * d.y;
        }
        const double ridge = kRidge * (xx + yy) + 1e-9;
        xx += ridge;
        yy += ridge;
        const double determinant = xx * yy - xy * xy;
        const Vec2 off = place - mean;
        const Vec2 g{(yy * off.x - xy * off.y) / determinant, (xx * off.y - xy * off.x) / determinant};
        for (std::size_t k = 0; k < landmarks.size(); ++k) weight[k] += dot(landmarks[k].at - mean, g);
    }
    Vec2 centre;
    for (std::size_t k = 0; k < landmarks.size(); ++k) centre += landmarks[k].at * weight[k];
    double spread = 0.0;
    std::size_t most = 0;
    for (std::size_t k = 0; k < landmarks.size(); ++k) {
        spread += weight[k] * lengthSquared(landmarks[k].at - centre);
        if (weight[k] > weight[most]) most = k;
        stencil.slot[k] = landmarks[k].slot;
        stencil.weight[k] = static_cast<float>(weight[k]);
        stencil.own[k] = static_cast<float>(landmarks[k].cost);
    }
    stencil.nearest = landmarks[most].slot;
    stencil.shift = static_cast<float>(-spread * static_cast<double>(unit) * static_cast<double>(unit));
    return stencil;
}

}  // namespace muster
