#include "assignment/dynamic/initial_duals.h"

#include <algorithm>
#include <cmath>

#include "assignment/dynamic/kd_partition.h"

namespace muster {
namespace {

constexpr std::int32_t kPerPart = 40;
constexpr std::int32_t kMostParts = 256;
constexpr std::int32_t kSweeps = 6;
constexpr std::int32_t kLanes = ExchangeArcs::kLanes;

}  // namespace

void InitialDuals::run(const AssignmentStep& context, ExchangeGraph& state) {
    pairArcs(state);
    divide(context, state);
    fitSlopes();
    fitHeights();
    listCoupled();
    solveHeights();
    for (std::int32_t s = 0; s < state.seats.count(); ++s) {
        const Plane& plane = planes_[partOf(s)];
        state.price[s] = plane.height + dot(plane.slope, at(s) - plane.middle);
    }
    smooth(state);
}

// Of arcs both ways. Those of one way say nothing.
void InitialDuals::pairArcs(const ExchangeGraph& state) {
    paired_.clear();
    paired_.reserve(state.arcs.targets().size());
    pairedEnd_.clear();
    // Widths near the mean cost say little about prices.
    double soft = 1e-12;
    for (const double c : state.ownPower) soft += 0.02 * c / static_cast<double>(state.ownPower.size());
    for (std::int32_t from = 0; from < state.seats.count(); ++from) {
        for (std::int32_t arc = from * kLanes; arc < (from + 1) * kLanes; ++arc) {
            const std::int32_t to = state.arcs.target(arc);
            const std::int32_t back = to != from ? state.arcs.find(to, from) : -1;
            if (back < 0) continue;
            const double there = state.arcs.weight(arc);
            const double again = state.arcs.weight(back);
            const double width = std::max(there + again, 0.0);
            const auto weight = static_cast<float>((soft / (soft + width)) * (soft / (soft + width)));
            if (weight > 0.0f)
                paired_.push_back({from, to, static_cast<float>(0.5 * (there - again)), weight});
        }
        pairedEnd_.push_back(paired_.size());
    }
}

void InitialDuals::divide(const AssignmentStep& context, const ExchangeGraph& state) {
    const std::int32_t seats = state.seats.count();
    at_.resize(seats);
    order_.resize(at_.size());
    for (std::int32_t s = 0; s < seats; ++s) {
        at_[s] = state.seats.at(s, context);
        order_[s] = s;
    }
    ends_.clear();
    divideIntoLeaves(at_, order_, std::clamp(seats / kPerPart, 1, kMostParts), 0, ends_);
    partOf_.assign(at_.size(), 0);
    planes_.assign(ends_.size(), {});
    std::int32_t begin = 0;
    for (std::size_t k = 0; k < ends_.size(); ++k) {
        for (std::int32_t m = begin; m < ends_[k]; ++m) {
            partOf_[order_[m]] = static_cast<std::int32_t>(k);
            planes_[k].middle += at_[order_[m]];
        }
        planes_[k].middle = planes_[k].middle / std::max(1.0, static_cast<double>(ends_[k] - begin));
        begin = ends_[k];
    }
}

void InitialDuals::fitSlopes() {
    normals_.assign(planes_.size(), {});
    for (const Paired& pair : paired_) {
        const double weight = pair.weight;
        const Vec2 way = at(pair.to) - at(pair.from);
        for (const std::int32_t s : {pair.from, pair.to}) {
            Normal& normal = normals_[partOf(s)];
            normal.xx += weight * way.x * way.x;
            normal.xy += weight * way.x * way.y;
            normal.yy += weight * way.y * way.y;
            normal.right += way * (weight * pair.middle);
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

void InitialDuals::fitHeights() {
    const std::size_t parts = planes_.size();
    coupling_.assign(parts * parts, 0.0);
    wanted_.assign(parts, 0.0);
    for (const Paired& pair : paired_) {
        const double weight = pair.weight;
        const std::size_t a = partOf(pair.from);
        const std::size_t b = partOf(pair.to);
        if (a == b) continue;
        const double inA = dot(planes_[a].slope, at(pair.from) - planes_[a].middle);
        const double inB = dot(planes_[b].slope, at(pair.to) - planes_[b].middle);
        const double rise = pair.middle + inA - inB;  // Height of b less height of a.
        coupling_[a * parts + b] += weight;
        coupling_[b * parts + a] += weight;
        wanted_[a] -= weight * rise;
        wanted_[b] += weight * rise;
    }
}

// Of some hundreds of parts each touches a dozen.
void InitialDuals::listCoupled() {
    const std::size_t parts = planes_.size();
    coupled_.clear();
    coupledEnd_.clear();
    for (std::size_t a = 0; a < parts; ++a) {
        for (std::size_t b = 0; b < parts; ++b)
            if (const double weight = coupling_[a * parts + b]; weight != 0.0)
                coupled_.push_back({b, weight});
        coupledEnd_.push_back(coupled_.size());
    }
}

// Gauss-Seidel with over-relaxation: a part's height is the mean of what its neighbours ask.
void InitialDuals::solveHeights() {
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

void InitialDuals::smooth(ExchangeGraph& state) const {
    for (std::int32_t sweep = 0; sweep < kSweeps; ++sweep) {
        std::size_t k = 0;
        for (std::size_t s = 0; s < pairedEnd_.size(); ++s) {
            double sum = 0.0;
            double weight = 0.0;
            for (; k < pairedEnd_[s]; ++k) {
                const double w = paired_[k].weight;
                sum += w * (state.price[paired_[k].to] - paired_[k].middle);
                weight += w;
            }
            if (weight > 0.0) state.price[s] = sum / weight;
        }
    }
}

}  // namespace muster
