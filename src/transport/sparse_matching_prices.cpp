#include "transport/sparse_matching_prices.h"

#include <algorithm>
#include <cmath>

#include "transport/sparse_matching_kd.h"

namespace muster {
namespace {

constexpr std::int32_t kPerPart = 40;
constexpr std::int32_t kMostParts = 256;
constexpr std::int32_t kSweeps = 6;
constexpr std::int32_t kLanes = MatchingArcs::kLanes;

double mid(const std::vector<float>& values, std::int32_t arc) { return values[static_cast<std::size_t>(arc)]; }

}  // namespace

void PriceFit::run(const MatchingContext& context, MatchingState& state) {
    pairArcs(state);
    divide(context, state);
    fitSlopes(context, state);
    fitHeights(context, state);
    listCoupled();
    solveHeights();
    for (std::int32_t s = 0; s < state.seats.count(); ++s) {
        const Plane& plane = planes_[static_cast<std::size_t>(partOf_[static_cast<std::size_t>(s)])];
        state.price[static_cast<std::size_t>(s)] =
            plane.height + dot(plane.slope, state.seats.at(s, context) - plane.middle);
    }
    smooth(state);
}

void PriceFit::pairArcs(const MatchingState& state) {
    const auto arcs = state.arcs.targets().size();
    middle_.assign(arcs, 0.0f);
    weight_.assign(arcs, 0.0f);
    // Widths near the mean cost say little about prices.
    double soft = 1e-12;
    for (const double c : state.ownPower) soft += 0.02 * c / static_cast<double>(state.ownPower.size());
    for (std::int32_t arc = 0; arc < static_cast<std::int32_t>(arcs); ++arc) {
        const std::int32_t from = arc / kLanes;
        const std::int32_t to = state.arcs.target(arc);
        const std::int32_t back = to != from ? state.arcs.find(to, from) : -1;
        if (back < 0) continue;
        const double there = state.arcs.weight(arc);
        const double again = state.arcs.weight(back);
        const double width = std::max(there + again, 0.0);
        middle_[static_cast<std::size_t>(arc)] = static_cast<float>(0.5 * (there - again));
        weight_[static_cast<std::size_t>(arc)] = static_cast<float>((soft / (soft + width)) * (soft / (soft + width)));
    }
}

void PriceFit::divide(const MatchingContext& context, const MatchingState& state) {
    const std::int32_t seats = state.seats.count();
    at_.resize(static_cast<std::size_t>(seats));
    order_.resize(at_.size());
    for (std::int32_t s = 0; s < seats; ++s) {
        at_[static_cast<std::size_t>(s)] = state.seats.at(s, context);
        order_[static_cast<std::size_t>(s)] = s;
    }
    ends_.clear();
    divideIntoLeaves(at_, order_, std::clamp(seats / kPerPart, 1, kMostParts), 0, ends_);
    partOf_.assign(at_.size(), 0);
    planes_.assign(ends_.size(), {});
    std::int32_t begin = 0;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
        for (std::int32_t m = begin; m < ends_[k]; ++m) {
            partOf_[static_cast<std::size_t>(order_[static_cast<std::size_t>(m)])] = static_cast<std::int32_t>(k);
            planes_[k].middle += at_[static_cast<std::size_t>(order_[static_cast<std::size_t>(m)])];
        }
        planes_[k].middle = planes_[k].middle / std::max(1.0, static_cast<double>(ends_[k] - begin));
        begin = ends_[k];
    }
}

void PriceFit::fitSlopes(const MatchingContext& context, const MatchingState& state) {
    normals_.assign(planes_.size(), {});
    for (std::int32_t arc = 0; arc < static_cast<std::int32_t>(weight_.size()); ++arc) {
        const double weight = mid(weight_, arc);
        if (weight == 0.0) continue;
        const std::int32_t to = state.arcs.target(arc);
        const Vec2 way = state.seats.at(to, context) - state.seats.at(arc / kLanes, context);
        for (const std::int32_t s : {arc / kLanes, to}) {
            Normal& normal = normals_[static_cast<std::size_t>(partOf_[static_cast<std::size_t>(s)])];
            normal.xx += weight * way.x * way.x;
            normal.xy += weight * way.x * way.y;
            normal.yy += weight * way.y * way.y;
            normal.right += way * (weight * mid(middle_, arc));
        }
    }
    for (std::size_t k = 0; k < planes_.size(); ++k) {
        const Normal& n = normals_[k];
        const double trace = n.xx + n.yy;
        if (!(trace > 0.0)) continue;
        const double xx = n.xx + 1e-6 * trace;
        const double yy = n.yy + 1e-6 * trace;
        const double determinant = xx * yy - n.xy * n.xy;
        planes_[k].slope = {(yy * n.right.x - n.xy * n.right.y) / determinant,
                            (xx * n.right.y - n.xy * n.right.x) / determinant};
    }
}

void PriceFit::fitHeights(const MatchingContext& context, const MatchingState& state) {
    const std::size_t parts = planes_.size();
    coupling_.assign(parts * parts, 0.0);
    wanted_.assign(parts, 0.0);
    for (std::int32_t arc = 0; arc < static_cast<std::int32_t>(weight_.size()); ++arc) {
        const double weight = mid(weight_, arc);
        const std::int32_t from = arc / kLanes;
        const std::int32_t to = state.arcs.target(arc);
        const auto a = static_cast<std::size_t>(partOf_[static_cast<std::size_t>(from)]);
        const auto b = static_cast<std::size_t>(partOf_[static_cast<std::size_t>(to)]);
        if (weight == 0.0 || a == b) continue;
        const double inA = dot(planes_[a].slope, state.seats.at(from, context) - planes_[a].middle);
        const double inB = dot(planes_[b].slope, state.seats.at(to, context) - planes_[b].middle);
        const double rise = mid(middle_, arc) + inA - inB;  // Height of b less height of a.
        coupling_[a * parts + b] += weight;
        coupling_[b * parts + a] += weight;
        wanted_[a] -= weight * rise;
        wanted_[b] += weight * rise;
    }
}

// Of some hundreds of parts each touches a dozen.
void PriceFit::listCoupled() {
    const std::size_t parts = planes_.size();
    coupled_.clear();
    coupledEnd_.clear();
    for (std::size_t a = 0; a < parts; ++a) {
        for (std::size_t b = 0; b < parts; ++b)
            if (const double weight = coupling_[a * parts + b]; weight != 0.0) coupled_.push_back({b, weight});
        coupledEnd_.push_back(coupled_.size());
    }
}

// Gauss-Seidel with over-relaxation: a part's height is the mean of what its neighbours ask.
void PriceFit::solveHeights() {
    constexpr std::int32_t kRounds = 60;
    constexpr double kOver = 1.7;
    for (std::int32_t round = 0; round < kRounds; ++round) {
        std::size_t k = 0;
        for (std::size_t a = 0; a < planes_.size(); ++a) {
            double sum = wanted_[a];
            double weight = 0.0;
            for (; k < coupledEnd_[a]; ++k) {
                sum += coupled_[k].weight * planes_[coupled_[k].part].height;
                weight += coupled_[k].weight;
            }
            if (weight > 0.0) planes_[a].height += kOver * (sum / weight - planes_[a].height);
        }
    }
}

void PriceFit::smooth(MatchingState& state) const {
    for (std::int32_t sweep = 0; sweep < kSweeps; ++sweep)
        for (std::int32_t s = 0; s < state.seats.count(); ++s) {
            double sum = 0.0;
            double weight = 0.0;
            for (std::int32_t arc = s * kLanes; arc < (s + 1) * kLanes; ++arc) {
                const double w = mid(weight_, arc);
                sum += w * (state.price[static_cast<std::size_t>(state.arcs.target(arc))] - mid(middle_, arc));
                weight += w;
            }
            if (weight > 0.0) state.price[static_cast<std::size_t>(s)] = sum / weight;
        }
}

}  // namespace muster
