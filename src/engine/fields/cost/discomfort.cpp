#include "engine/fields/cost/dynamic_cost.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Speed below which an obstacle causes no discomfort [m/s].
constexpr double kDiscomfortSpeed = 1e-3;
constexpr int kMaxIterations = 48;

// The feature of a piece that is nearest to a point: a side or a corner, or the centre of a disc.
struct Nearest {
    bool inside = false;      // True if the point lies inside the piece.
    bool isSide = false;      // True if the feature is a side.
    std::int32_t index = -1;  // Index of the side or corner.
    double distance = 0.0;    // Distance from the piece [m].
    Vec2 normal;              // Outward unit normal of a side.
    Vec2 corner;              // The corner, or the centre of a disc.
};

Nearest nearestTo(const ObstaclePiece& piece, Vec2 p) {
    if (piece.corners.empty()) {
        const double away = distance(p, piece.centre) - piece.radius;
        Nearest disc;
        disc.inside = away <= 0.0;
        disc.index = 0;
        disc.distance = away;
        disc.corner = piece.centre;
        return disc;
    }
    Nearest best;
    best.inside = true;
    double least = 1e300;
    const auto count = static_cast<std::int32_t>(piece.corners.size());
    for (std::int32_t k = 0; k < count; ++k) {
        const Vec2 a = piece.corners[k];
        const Vec2 edge = piece.corners[k + 1 < count ? k + 1 : 0] - a;
        const Vec2 off = p - a;
        const double beyond = -cross(edge, off);  // Distance times the side's length; positive outside.
        if (beyond > 0.0) best.inside = false;
        const double along = dot(off, edge);
        const double squared = lengthSquared(edge);
        // The end of a side is the start of the next.
        if (along >= squared) continue;
        const bool isSide = along > 0.0 && beyond > 0.0;
        const double here = isSide ? beyond * beyond / squared : lengthSquared(off);
        if (here >= least || (along > 0.0 && !isSide)) continue;
        least = here;
        best.isSide = isSide;
        best.index = k;
        best.normal = Vec2{edge.y, -edge.x};
        best.corner = a;
    }
    best.distance = best.inside ? 0.0 : std::sqrt(least);
    if (best.isSide) best.normal = normalized(best.normal);
    return best;
}

// Finds the maximum of (1 - d(t) / range) (1 - t / time) over the time t, where d is the distance from a
// point to the piece moved by t. Both factors are concave where positive, so that there is only one maximum.
class PeakSearch {
public:
    PeakSearch(const Parameters::Discomfort& def, const ObstaclePiece& piece, Vec2 p, double precision)
        : def_(def), piece_(piece), p_(p), precision_(precision) {}

    double between(double low, double high) {
        low_ = low;
        high_ = high;
        double best = 0.0;
        double time = low;
        bool predicted = false;
        Nearest from;
        for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
            const Nearest here = nearestTo(piece_, p_ - piece_.velocity * time);
            const double away = std::max(0.0, here.distance);
            best = std::max(best, (1.0 - away / def_.range) * (1.0 - time / def_.time));
            const bool found = predicted && here.isSide == from.isSide && here.index == from.index;
            if (found || high_ - low_ <= precision_ * def_.time) break;
            from = here;
            const double peak = here.inside   ? time
                                : here.isSide ? sidePeak(here, time)
                                              : cornerPeak(here.corner);
            if (here.inside || peak <= time) high_ = std::min(high_, time);
            if (!here.inside && peak >= time) low_ = std::max(low_, time);
            if (time == low && high_ <= low) break;
            // The next time is the maximum for this side or corner alone, if that lies between the bounds;
            // otherwise their middle.
            predicted = peak > low_ && peak < high_;
            time = predicted ? peak : 0.5 * (low_ + high_);
        }
        return best;
    }

private:
    // The maximum before a side: d is linear in t, the product quadratic.
    double sidePeak(const Nearest& side, double time) const {
        const double closing = dot(piece_.velocity, side.normal);
        if (closing <= 0.0) return low_;
        const double meets = time + side.distance / closing;
        const double entersRange = meets - def_.range / closing;
        return std::min(0.5 * (entersRange + def_.time), meets);
    }

    // The maximum before a corner or a disc, where d^2 is a quadratic in t: Newton's method within
    // bounds.
    double cornerPeak(Vec2 corner) const {
        const double squared = lengthSquared(piece_.velocity);
        const double size = piece_.corners.empty() ? piece_.radius : 0.0;
        const Vec2 off = p_ - corner;
        const double nearest = dot(off, piece_.velocity) / squared;  // Time of the least distance.
        const double lateralSquared = lengthSquared(off) - squared * nearest * nearest;
        double before = std::min(low_, nearest);
        double after = std::min(nearest, def_.time);
        if (size > 0.0 && lateralSquared < size * size)
            after = std::min(after, nearest - std::sqrt((size * size - lateralSquared) / squared));
        const double range = def_.range + size;
        // Has the sign of the product's derivative where both factors are positive.
        double slope = 0.0;
        double derivative = 0.0;
        const auto at = [&](double t) {
            const double until = nearest - t;
            const double away = std::sqrt(std::max(0.0, lateralSquared + squared * until * until));
            slope = squared * until * (def_.time - t) - (range - away) * away;
            derivative = -squared * (def_.time - t + until) -
                         squared * until * (2.0 * away - range) / std::max(away, 1e-12);
        };
        if (after <= before) return after;
        at(after);
        if (slope >= 0.0) return after;
        double t = after;
        for (int k = 0; k < kMaxIterations && after - before > precision_ * def_.time; ++k) {
            const double step = derivative < 0.0 ? t - slope / derivative : before;
            const double next = step > before && step < after ? step : 0.5 * (before + after);
            const bool converged = std::fabs(next - t) <= precision_ * def_.time;
            t = next;
            if (converged) break;
            at(t);
            (slope >= 0.0 ? before : after) = t;
        }
        return t;
    }

    const Parameters::Discomfort& def_;
    const ObstaclePiece& piece_;
    Vec2 p_;
    double precision_;
    double low_ = 0.0;
    double high_ = 0.0;
};

}  // namespace

double discomfortAt(const Parameters::Discomfort& def, const ObstaclePiece& piece, Vec2 p, double precision) {
    const double speed = length(piece.velocity);
    if (speed < kDiscomfortSpeed || !(def.time > 0.0)) return 0.0;
    // The times at which the circumcircle of the piece is within the range.
    const Vec2 ahead = piece.velocity / speed;
    const double along = dot(p - piece.centre, ahead);
    const double lateral = cross(ahead, p - piece.centre);
    const double reach = piece.radius + def.range;
    if (std::fabs(lateral) >= reach) return 0.0;
    const double half = std::sqrt(reach * reach - lateral * lateral);
    const double low = std::max(0.0, (along - half) / speed);
    const double high = std::min(def.time, (along + half) / speed);
    if (low >= high) return 0.0;
    return def.gain * PeakSearch(def, piece, p, precision).between(low, high);
}

void addDiscomfort(const Parameters::Discomfort& def, const ObstaclePiece& piece, const Grid& grid,
                   std::vector<float>& discomfort, std::vector<std::int32_t>& cells) {
    if (!piece.moving || length(piece.velocity) < kDiscomfortSpeed || !(def.time > 0.0)) return;
    const Vec2 end = piece.centre + piece.velocity * def.time;
    const double reach = piece.radius + def.range;
    const Vec2 least{std::min(piece.centre.x, end.x) - reach, std::min(piece.centre.y, end.y) - reach};
    const Vec2 most{std::max(piece.centre.x, end.x) + reach, std::max(piece.centre.y, end.y) + reach};
    const Cell low = grid.cellOf(least);
    const Cell high = grid.cellOf(most);
    for (std::int32_t y = std::max(0, low.y); y <= std::min(grid.height - 1, high.y); ++y) {
        for (std::int32_t x = std::max(0, low.x); x <= std::min(grid.width - 1, high.x); ++x) {
            const auto g = static_cast<float>(discomfortAt(def, piece, grid.centre({x, y})));
            if (!(g > 0.0f)) continue;
            float& here = discomfort[grid.index({x, y})];
            if (here == 0.0f) cells.push_back(grid.index({x, y}));
            here = std::max(here, g);
        }
    }
}

}  // namespace muster
