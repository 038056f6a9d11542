#include "engine/fields/geodesics/interpolation_stencil.h"

#include <algorithm>

#include "base/bilinear.h"

namespace muster {
namespace {

// Regularisation of the weights, as a share of the landmarks' spread.
constexpr double kRidge = 0.02;

void bilinearWeights(std::span<const Landmark> corners, Vec2 place, double (&weight)[4]) {
    const Vec2 low = corners[0].position;
    const Vec2 edge = corners[3].position - low;
    const double fx = std::clamp((place.x - low.x) / edge.x, 0.0, 1.0);
    const double fy = std::clamp((place.y - low.y) / edge.y, 0.0, 1.0);
    weight[0] = (1 - fx) * (1 - fy);
    weight[1] = fx * (1 - fy);
    weight[2] = (1 - fx) * fy;
    weight[3] = fx * fy;
}

// Changes equal weights so that their mean lies at the place: the ridge regression of the offset on the
// landmarks.
void ridgeWeights(std::span<const Landmark> landmarks, double share, Vec2 place, double (&weight)[4]) {
    Vec2 mean;
    for (const Landmark& l : landmarks) mean += l.position * share;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const Landmark& l : landmarks) {
        const Vec2 d = l.position - mean;
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
    for (std::size_t k = 0; k < landmarks.size(); ++k) weight[k] += dot(landmarks[k].position - mean, g);
}

}  // namespace

InterpolationStencil makeStencil(std::span<const Landmark> landmarks, bool completeSquare, Vec2 place,
                                 float unitCost) {
    InterpolationStencil stencil;
    stencil.count = static_cast<std::int32_t>(landmarks.size());
    if (landmarks.empty()) return stencil;
    const double share = 1.0 / static_cast<double>(landmarks.size());
    double weight[4] = {share, share, share, share};
    if (completeSquare && landmarks.size() == 4)
        bilinearWeights(landmarks, place, weight);
    else if (landmarks.size() > 1)
        ridgeWeights(landmarks, share, place, weight);
    Vec2 centre;
    for (std::size_t k = 0; k < landmarks.size(); ++k) centre += landmarks[k].position * weight[k];
    double spread = 0.0;
    std::size_t heaviest = 0;
    for (std::size_t k = 0; k < landmarks.size(); ++k) {
        spread += weight[k] * lengthSquared(landmarks[k].position - centre);
        if (weight[k] > weight[heaviest]) heaviest = k;
        stencil.slot[k] = landmarks[k].slot;
        stencil.weight[k] = static_cast<float>(weight[k]);
        stencil.toPlace[k] = static_cast<float>(landmarks[k].cost);
    }
    stencil.nearest = landmarks[heaviest].slot;
    stencil.offset = static_cast<float>(-spread * static_cast<double>(unitCost) *
                                        static_cast<double>(unitCost));
    return stencil;
}

double interpolationBias(const Grid& grid, Vec2 p, double unitCost) {
    const BilinearPoint at = bilinearPoint(grid, p);
    const double edge = unitCost * grid.cell;
    return edge * edge * (at.fx * (1.0 - at.fx) + at.fy * (1.0 - at.fy));
}

}  // namespace muster
