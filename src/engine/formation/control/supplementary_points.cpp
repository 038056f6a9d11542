#include "engine/formation/control/control_points.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/polygon.h"
#include "engine/geometry/triangulation.h"

namespace muster {
namespace {

constexpr double kMaxPerLine = 64.0;  // Greatest number of samples between two control points.
constexpr double kMaxInside = 256.0;  // Greatest number of samples inside an area.

// Samples one control.
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

    // Samples the segment between two control points, without its ends.
    void addLine(std::size_t i, std::size_t j) {
        const double parts = std::min(kMaxPerLine,
                                      std::ceil(distance(corner_[i], corner_[j]) / spacing_ - 1e-9));
        for (double k = 1.0; k < parts; k += 1.0) {
            row_.assign(corner_.size(), 0.0);
            row_[i] = 1.0 - k / parts;
            row_[j] = k / parts;
            add(lerp(corner_[i], corner_[j], k / parts));
        }
    }

    void addArea() {
        const Polygon hull = convexHull(corner_);
        if (hull.size() < 3 || isFlat(hull)) {
            addChain();
            return;
        }
        std::vector<std::size_t> index;
        for (const Vec2 c : hull)
            index.push_back(std::find(corner_.begin(), corner_.end(), c) - corner_.begin());
        for (std::size_t k = 0; k < hull.size(); ++k) addLine(index[k], index[(k + 1) % hull.size()]);
        addInside(hull, index);
    }

private:
    // True where the hull is too flat for mean-value coordinates.
    static bool isFlat(const Polygon& hull) {
        const Box box = boundsOf(hull);
        const double size = std::max(box.width(), box.height());
        return signedArea(hull) < 1e-6 * size * size;
    }

    // Control points on one line: a chain of segments from one end to the other.
    void addChain() {
        std::size_t farthest = 0;
        for (std::size_t k = 1; k < corner_.size(); ++k)
            if (distance(corner_[0], corner_[k]) > distance(corner_[0], corner_[farthest])) farthest = k;
        const Vec2 direction = corner_[farthest] - corner_[0];
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t k = 0; k < corner_.size(); ++k) order.emplace_back(dot(corner_[k], direction), k);
        std::sort(order.begin(), order.end());
        for (std::size_t k = 1; k < order.size(); ++k) addLine(order[k - 1].second, order[k].second);
    }

    void addInside(const Polygon& hull, const std::vector<std::size_t>& index) {
        const Box box = boundsOf(hull);
        const double step = std::max(spacing_, std::sqrt(box.width() * box.height() / kMaxInside));
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

    // Adds a point with the weights in row_ where the mesh covers it.
    void add(Vec2 p) {
        const MeshPoint point = locate(rest_.triangles, rest_.vertices, p);
        if (!(distance(point.position(rest_.triangles, rest_.vertices), p) <= tolerance_)) return;
        control_.supplementary.push_back(point);
        control_.weights.insert(control_.weights.end(), row_.begin(), row_.end());
    }

    Control& control_;
    const TriangleMesh& rest_;
    double spacing_;            // Distance between samples [m].
    double tolerance_ = 0.0;    // Distance within which a point counts as covered by the mesh [m].
    std::vector<Vec2> corner_;  // Control points in the rest shape [m].
    std::vector<double> row_;   // Weights of the current sample.
};

}  // namespace

void sampleSupplementary(Control& control, const TriangleMesh& rest, double spacing) {
    Sampler sampler(control, rest, spacing);
    if (control.kind == ControlKind::Line) sampler.addLine(0, 1);
    if (control.kind == ControlKind::Area) sampler.addArea();
}

}  // namespace muster
