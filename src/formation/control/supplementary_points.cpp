#include "formation/control/supplementary_points.h"

#include <algorithm>
#include <cmath>

#include "geometry/mean_value.h"
#include "geometry/triangulation.h"

namespace muster {
namespace {

constexpr double kMostPerLine = 64.0;  // Samples between two points.
constexpr double kMostInside = 256.0;  // Samples inside an area.

// One control's samples in the making.
class Sampler {
public:
    Sampler(Control& control, const TriangleMesh& rest, double spacing)
        : control_(control), rest_(rest), spacing_(spacing) {
        for (const ControlPoint& point : control.points) corner_.push_back(rest.vertices[point.vertex]);
        const Box box = boundsOf(rest.vertices);
        tolerance_ = 1e-6 * (box.width() + box.height());
        control.supplementary.clear();
        control.weights.clear();
    }

    // Between the points with indices i and j, both left out.
    void line(std::size_t i, std::size_t j) {
        const double parts = std::min(kMostPerLine,
                                      std::ceil(distance(corner_[i], corner_[j]) / spacing_ - 1e-9));
        for (double k = 1.0; k < parts; k += 1.0) {
            row_.assign(corner_.size(), 0.0);
            row_[i] = 1.0 - k / parts;
            row_[j] = k / parts;
            add(lerp(corner_[i], corner_[j], k / parts));
        }
    }

    void area() {
        const Polygon hull = convexHull(corner_);
        if (hull.size() < 3 || thin(hull)) {
            chain();
            return;
        }
        std::vector<std::size_t> index;
        for (const Vec2 c : hull)
            index.push_back(
                static_cast<std::size_t>(std::find(corner_.begin(), corner_.end(), c) - corner_.begin()));
        for (std::size_t k = 0; k < hull.size(); ++k) line(index[k], index[(k + 1) % hull.size()]);
        inside(hull, index);
    }

private:
    // Hulls this flat have no usable inside.
    static bool thin(const Polygon& hull) {
        const Box box = boundsOf(hull);
        const double size = std::max(box.width(), box.height());
        return signedArea(hull) < 1e-6 * size * size;
    }

    // Points on one line: a chain of lines from one end to the other.
    void chain() {
        std::size_t farthest = 0;
        for (std::size_t k = 1; k < corner_.size(); ++k)
            if (distance(corner_[0], corner_[k]) > distance(corner_[0], corner_[farthest])) farthest = k;
        const Vec2 direction = corner_[farthest] - corner_[0];
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t k = 0; k < corner_.size(); ++k) order.emplace_back(dot(corner_[k], direction), k);
        std::sort(order.begin(), order.end());
        for (std::size_t k = 1; k < order.size(); ++k) line(order[k - 1].second, order[k].second);
    }

    void inside(const Polygon& hull, const std::vector<std::size_t>& index) {
        const Box box = boundsOf(hull);
        const double step = std::max(spacing_, std::sqrt(box.width() * box.height() / kMostInside));
        const Vec2 middle = (box.min + box.max) / 2.0;
        const double columns = std::floor(box.width() / 2.0 / step);
        const double rows = std::floor(box.height() / 2.0 / step);
        std::vector<double> share(hull.size());
        for (double y = -rows; y <= rows; y += 1.0) {
            for (double x = -columns; x <= columns; x += 1.0) {
                const Vec2 p = middle + Vec2{x * step, y * step};
                if (!containsPoint(hull, p) || closestOnBoundary(hull, p).distance < 0.3 * step) continue;
                meanValueCoordinates(hull, p, share);
                row_.assign(corner_.size(), 0.0);
                for (std::size_t k = 0; k < hull.size(); ++k) row_[index[k]] = share[k];
                add(p);
            }
        }
    }

    // Takes the point with the weights in row_, where the mesh covers it.
    void add(Vec2 p) {
        const MeshPoint point = locate(rest_.triangles, rest_.vertices, p);
        if (!(distance(point.position(rest_.triangles, rest_.vertices), p) <= tolerance_)) return;
        control_.supplementary.push_back(point);
        control_.weights.insert(control_.weights.end(), row_.begin(), row_.end());
    }

    Control& control_;
    const TriangleMesh& rest_;
    double spacing_;
    double tolerance_ = 0.0;
    std::vector<Vec2> corner_;  // Of the control's points in the rest shape.
    std::vector<double> row_;   // Weights of the sample in hand.
};

}  // namespace

void sampleSupplementary(Control& control, const TriangleMesh& rest, double spacing) {
    Sampler sampler(control, rest, spacing);
    if (control.kind == ControlKind::Line) sampler.line(0, 1);
    if (control.kind == ControlKind::Area) sampler.area();
}

}  // namespace muster
