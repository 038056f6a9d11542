#include "cost/discomfort.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Pieces slower than this are not predicted [m/s].
constexpr double kStill = 1e-3;
constexpr int kMostRounds = 48;

// What of a piece is nearest to a point outside it: the side with this outward normal, or else the corner.
struct Nearest {
    bool inside = false;
    bool isSide = false;
    std::int32_t number = -1;  // Of the side or the corner.
    double distance = 0.0;
    Vec2 normal;
    Vec2 corner;
};

Nearest nearestTo(const ObstaclePiece& piece, Vec2 p) {
    if (piece.corners.empty()) {
        const double away = distance(p, piece.centre) - piece.radius;
        Nearest disc;
        disc.inside = away <= 0.0;
        disc.number = 0;
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
        const Vec2 way = piece.corners[k + 1 < count ? k + 1 : 0] - a;
        const Vec2 off = p - a;
        const double beyond = -cross(way, off);  // Times the side's length; positive outside.
        if (beyond > 0.0) best.inside = false;
        const double along = dot(off, way);
        const double squared = lengthSquared(way);
        // The end of a side is the next one's beginning.
        if (along >= squared) continue;
        const bool isSide = along > 0.0 && beyond > 0.0;
        const double here = isSide ? beyond * beyond / squared : lengthSquared(off);
        if (here >= least || (along > 0.0 && !isSide)) continue;
        least = here;
        best.isSide = isSide;
        best.number = k;
        best.normal = Vec2{way.y, -way.x};
        best.corner = a;
    }
    best.distance = best.inside ? 0.0 : std::sqrt(least);
    if (best.isSide) best.normal = normalized(best.normal);
    return best;
}

// The search for the peak of (1 - d / range) (1 - t / time) over t, d the distance from a point to the piece
// moved by t. Both factors are concave where positive, so that there is one.
class PeakSearch {
public:
    PeakSearch(const UnitCostDef& def, const ObstaclePiece& piece, Vec2 p, double precision)
        : def_(def), piece_(piece), p_(p), precision_(precision) {}

    double between(double low, double high) {
        low_ = low;
        high_ = high;
        double best = 0.0;
        double time = low;
        bool foreseen = false;
        Nearest from;
        for (int round = 0; round < kMostRounds; ++round) {
            const Nearest here = nearestTo(piece_, p_ - piece_.velocity * time);
            const double away = std::max(0.0, here.distance);
            best = std::max(best, (1.0 - away / def_.discomfortRange) * (1.0 - time / def_.discomfortTime));
            const bool found = foreseen && here.isSide == from.isSide && here.number == from.number;
            if (found || high_ - low_ <= precision_ * def_.discomfortTime) break;
            from = here;
            const double peak = here.inside   ? time
                                : here.isSide ? sidePeak(here, time)
                                              : cornerPeak(here.corner);
            if (here.inside || peak <= time) high_ = std::min(high_, time);
            if (!here.inside && peak >= time) low_ = std::max(low_, time);
            if (time == low && high_ <= low) break;
            // As if this side or corner stayed the nearest, where that is not beyond what is known.
            foreseen = peak > low_ && peak < high_;
            time = foreseen ? peak : 0.5 * (low_ + high_);
        }
        return best;
    }

private:
    // Before a side the product is a quadratic in t.
    double sidePeak(const Nearest& side, double time) const {
        const double closing = dot(piece_.velocity, side.normal);
        if (closing <= 0.0) return low_;
        const double meets = time + side.distance / closing;
        const double entersRange = meets - def_.discomfortRange / closing;
        return std::min(0.5 * (entersRange + def_.discomfortTime), meets);
    }

    // Before a corner, or a disc, d is the root of a quadratic in t: Newton's steps, kept between bounds.
    double cornerPeak(Vec2 corner) const {
        const double squared = lengthSquared(piece_.velocity);
        const double size = piece_.corners.empty() ? piece_.radius : 0.0;
        const Vec2 off = p_ - corner;
        const double nearest = dot(off, piece_.velocity) / squared;  // The time of least distance.
        const double aside = lengthSquared(off) - squared * nearest * nearest;
        double before = std::min(low_, nearest);
        double after = std::min(nearest, def_.discomfortTime);
        if (size > 0.0 && aside < size * size)
            after = std::min(after, nearest - std::sqrt((size * size - aside) / squared));
        const double range = def_.discomfortRange + size;
        // Has the sign of the product's slope where both factors are positive, and rises before that.
        double slope = 0.0;
        double bend = 0.0;
        const auto at = [&](double t) {
            const double until = nearest - t;
            const double away = std::sqrt(std::max(0.0, aside + squared * until * until));
            slope = squared * until * (def_.discomfortTime - t) - (range - away) * away;
            bend = -squared * (def_.discomfortTime - t + until) -
                   squared * until * (2.0 * away - range) / std::max(away, 1e-12);
        };
        if (after <= before) return after;
        at(after);
        if (slope >= 0.0) return after;
        double t = after;
        for (int k = 0; k < kMostRounds && after - before > precision_ * def_.discomfortTime; ++k) {
            const double step = bend < 0.0 ? t - slope / bend : before;
            const double next = step > before && step < after ? step : 0.5 * (before + after);
            const bool still = std::fabs(next - t) <= precision_ * def_.discomfortTime;
            t = next;
            if (still) break;
            at(t);
            (slope >= 0.0 ? before : after) = t;
        }
        return t;
    }

    const UnitCostDef& def_;
    const ObstaclePiece& piece_;
    Vec2 p_;
    double precision_;
    double low_ = 0.0;
    double high_ = 0.0;
};

}  // namespace

double discomfortAt(const UnitCostDef& def, const ObstaclePiece& piece, Vec2 p, double precision) {
    const double speed = length(piece.velocity);
    if (speed < kStill || !(def.discomfortTime > 0.0)) return 0.0;
    // Only while the circle round the piece is near enough to the point can there be any.
    const Vec2 ahead = piece.velocity / speed;
    const double along = dot(p - piece.centre, ahead);
    const double aside = cross(ahead, p - piece.centre);
    const double reach = piece.radius + def.discomfortRange;
    if (std::fabs(aside) >= reach) return 0.0;
    const double half = std::sqrt(reach * reach - aside * aside);
    const double low = std::max(0.0, (along - half) / speed);
    const double high = std::min(def.discomfortTime, (along + half) / speed);
    if (low >= high) return 0.0;
    return def.discomfortGain * PeakSearch(def, piece, p, precision).between(low, high);
}

void addDiscomfort(const UnitCostDef& def, const ObstaclePiece& piece, const Grid& grid,
                   std::vector<float>& discomfort, std::vector<std::int32_t>& touched) {
    if (!piece.moving || length(piece.velocity) < kStill || !(def.discomfortTime > 0.0)) return;
    const Vec2 end = piece.centre + piece.velocity * def.discomfortTime;
    const double reach = piece.radius + def.discomfortRange;
    const Vec2 least{std::min(piece.centre.x, end.x) - reach, std::min(piece.centre.y, end.y) - reach};
    const Vec2 most{std::max(piece.centre.x, end.x) + reach, std::max(piece.centre.y, end.y) + reach};
    const Cell low = grid.cellOf(least);
    const Cell high = grid.cellOf(most);
    for (std::int32_t y = std::max(0, low.y); y <= std::min(grid.height - 1, high.y); ++y) {
        for (std::int32_t x = std::max(0, low.x); x <= std::min(grid.width - 1, high.x); ++x) {
            const auto g = static_cast<float>(discomfortAt(def, piece, grid.centre({x, y})));
            if (!(g > 0.0f)) continue;
            float& here = discomfort[grid.index({x, y})];
            if (here == 0.0f) touched.push_back(grid.index({x, y}));
            here = std::max(here, g);
        }
    }
}

}  // namespace muster
