#include "lab/measures/voronoi.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/maths.h"
#include "engine/geometry/polygon.h"

namespace muster {
namespace {

/// The largest polygon that a cell may fill: the circle of the cut-off, or a box that holds the ground.
Polygon frameOf(Vec2 centre, const Box& ground, const CutOff& cutOff) {
    if (cutOff.radius <= 0.0) {
        const Box box = ground.grown(1.0);
        return {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    }
    const std::int32_t corners = 4 * cutOff.quadSegments;
    Polygon circle;
    for (std::int32_t i = 0; i < corners; ++i) {
        const double angle = 2.0 * kPi * i / corners;
        circle.push_back(centre + Vec2{cosine(angle), sine(angle)} * cutOff.radius);
    }
    return circle;
}

double farthest(const Polygon& cell, Vec2 from) {
    double most = 0.0;
    for (const Vec2 p : cell) most = std::max(most, lengthSquared(p - from));
    return std::sqrt(most);
}

/// Cuts cells by the lines half way to other persons, which are looked at in the order of x, both ways from
/// the person of the cell.
class CellCutter {
public:
    explicit CellCutter(std::span<const Sighting> persons) : persons_(persons), order_(persons.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        std::stable_sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) {
            return persons_[a].position.x < persons_[b].position.x;
        });
        rank_.resize(order_.size());
        for (std::size_t k = 0; k < order_.size(); ++k) rank_[order_[k]] = static_cast<std::ptrdiff_t>(k);
    }

    void cut(Polygon& cell, std::size_t person) const {
        const Vec2 own = persons_[person].position;
        double reach = 2.0 * farthest(cell, own);
        std::ptrdiff_t left = rank_[person] - 1, right = rank_[person] + 1;
        const auto away = [&](std::ptrdiff_t k) {
            return k < 0 || k >= std::ssize(order_) ? reach + 1.0
                                                    : std::abs(persons_[order_[k]].position.x - own.x);
        };
        while (!cell.empty()) {
            const bool goLeft = away(left) < away(right);
            const std::ptrdiff_t k = goLeft ? left-- : right++;
            if (away(k) > reach) return;
            const Vec2 other = persons_[order_[k]].position, apart = other - own;
            const double square = lengthSquared(apart);
            if (square > reach * reach || square == 0.0) continue;
            const Vec2 middle = 0.5 * (own + other);
            clipLeftOf(cell, middle, middle + perpendicular(apart));
            reach = 2.0 * farthest(cell, own);
        }
    }

private:
    std::span<const Sighting> persons_;
    std::vector<std::int32_t> order_;
    std::vector<std::ptrdiff_t> rank_;
};

double areaOf(const std::vector<Polygon>& pieces) {
    double sum = 0.0;
    for (const Polygon& piece : pieces) sum += signedArea(piece);
    return sum;
}

/// True where a cell cannot meet the area: its cut-off does not reach there.
bool isFar(Vec2 person, const Region& area, const CutOff& cutOff) {
    return cutOff.radius > 0.0 && !area.box().grown(cutOff.radius).contains(person);
}

VoronoiCell cellOf(const CellCutter& cutter, const Sighting& person, std::size_t index,
                   const Region& walkable, const CutOff& cutOff) {
    Polygon cell = frameOf(person.position, walkable.box(), cutOff);
    cutter.cut(cell, index);
    VoronoiCell made{person.id, walkable.partAround(cell, person.position), 0.0};
    made.area = areaOf(made.pieces);
    return made;
}

}  // namespace

std::vector<VoronoiCell> voronoiCells(std::span<const Sighting> persons, const Region& walkable,
                                      const CutOff& cutOff) {
    const CellCutter cutter(persons);
    std::vector<VoronoiCell> cells;
    for (std::size_t i = 0; i < persons.size(); ++i)
        cells.push_back(cellOf(cutter, persons[i], i, walkable, cutOff));
    return cells;
}

double areaWithin(const VoronoiCell& cell, const Region& area) {
    double sum = 0.0;
    for (const Polygon& piece : cell.pieces) sum += area.sharedArea(piece);
    return sum;
}

VoronoiSeries voronoiSeries(const Trajectories& trajectories, const Region& walkable, const Region& area,
                            const CutOff& cutOff, std::span<const double> speeds) {
    VoronoiSeries series;
    for (std::int32_t f = 0; f < trajectories.frameCount(); ++f) {
        const auto persons = trajectories.frame(f);
        const CellCutter cutter(persons);
        double density = 0.0, speed = 0.0;
        for (std::size_t i = 0; i < persons.size(); ++i) {
            if (isFar(persons[i].position, area, cutOff)) continue;
            const VoronoiCell cell = cellOf(cutter, persons[i], i, walkable, cutOff);
            const double within = areaWithin(cell, area);
            if (within <= 0.0 || cell.area <= 0.0) continue;
            density += within / cell.area;
            if (speeds.empty()) continue;
            const double own = speeds[&persons[i] - trajectories.all().data()];
            if (std::isfinite(own)) speed += own * within;
        }
        series.density.push_back(density / area.area());
        if (!speeds.empty()) series.speed.push_back(speed / area.area());
    }
    return series;
}

}  // namespace muster
