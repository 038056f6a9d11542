#include "engine/orders/avoidance.h"

#include <algorithm>
#include <cmath>

#include "base/infinite_cost.h"
#include "base/maths.h"

namespace muster {
namespace {

// Angles to the way [degrees], the right first, so that those who meet head-on both pass to the right.
constexpr double kAngles[] = {-15, 15, -30, 30, -50, 50, -80, 80};
constexpr double kShares[] = {1.0, 0.6};
constexpr double kTimes[] = {2.0, 4.0, 8.0};
constexpr double kBackAngles[] = {-130, 130, 180};
constexpr double kBackTimes[] = {2.0, 4.0};
constexpr double kSlowShares[] = {0.75, 0.5, 0.25, 0.0};
constexpr double kSlowTimes[] = {1.0, 2.0, 4.0, 7.0};
constexpr double kStopAngles[] = {0, -20, 20, -50, 50};
constexpr double kStopShares[] = {1.0, 0.5};
constexpr double kStopsIn = 0.3;      // It goes on for so long before it stops [s].
constexpr double kHurries = 6.0;      // It goes faster than it would for so long [s].
constexpr double kWait = 2.5;         // What it costs to wait for moving obstacles, about [s]...
constexpr double kMeshWait = 4.0;     // ... for a mesh ...
constexpr double kStandWait = 20.0;   // ... and for what stands.
constexpr double kFaster = 2.0;       // Of a speed above that which it would have, by its own [s].
constexpr double kLeftFactor = 1.15;  // To the left it costs more...
constexpr double kLeft = 0.15;        // ... and as much more [s].
constexpr double kYieldFactor = 1.5;  // To let somebody pass who has to let it pass costs more...
constexpr double kYield = 0.5;        // ... and as much more [s].
constexpr double kChange = 0.3;       // Of a change by its whole speed [s].
constexpr double kTowards = 4.0;      // Of going into somebody whom it overlaps, at its whole speed [s].
constexpr double kKept = 0.6;         // Share of the margin to which it goes on with what it does.
constexpr double kStopMargin = 0.2;   // It stops farther off [m].
constexpr double kLater = 0.05;       // A contact is later by more than this [s].
constexpr double kMargins[] = {1.0, 0.75, 0.5, 0.25, 0.0};

Vec2 velocityOf(const AvoidanceQuery& query, const Manoeuvre& manoeuvre) {
    const Vec2 way = normalized(query.ahead.front() - query.middle, query.own.axis);
    return rotationBy(manoeuvre.angle).apply(way) * manoeuvre.speed;
}

}  // namespace

Avoider::Avoider() {
    constexpr std::size_t kCandidates = 128;
    candidates_.reserve(kCandidates);
    order_.reserve(kCandidates);
}

// Who is nearer than the margin already has less of it; who overlaps is no neighbour any more.
void Avoider::readNeighbours(const AvoidanceQuery& query, std::span<const Neighbour> neighbours) {
    near_.clear();
    met_.clear();
    near_.reserve(neighbours.size());
    met_.reserve(neighbours.size());
    MovingBox now = query.own;
    now.to = 0.0;
    for (const Neighbour& neighbour : neighbours) {
        MovingBox other = neighbour.box;
        bool clear = other.from > 0.0;
        double margin = neighbour.margin;
        const double farther = margin + kStopMargin;
        const bool far = clear || contactSpan(now, other, farther).empty();
        for (std::size_t k = 0; k < std::size(kMargins) && !clear; ++k) {
            margin = kMargins[k] * neighbour.margin;
            clear = contactSpan(now, other, margin).empty();
        }
        if (!clear) {
            if (!neighbour.isMesh) met_.push_back(normalized(other.centre - now.centre));
            continue;
        }
        near_.push_back({neighbour, far ? farther : margin});
        near_.back().neighbour.margin = margin;
    }
}

// Who has met the last one looked at mostly meets this one, too.
double Avoider::contactOf(const AvoidanceQuery& query, const Candidate& candidate, bool whole) {
    const bool stops = candidate.manoeuvre.stops;
    const Course course = courseOf(query, candidate.manoeuvre);
    double first = kInfiniteCost;
    for (std::size_t k = 0; k < near_.size(); ++k) {
        const std::size_t index = k == 0 ? first_ : k <= first_ ? k - 1 : k;
        const auto& [neighbour, stopMargin] = near_[index];
        const double margin = candidate.kept ? neighbour.margin * kKept
                              : stops        ? stopMargin
                                             : neighbour.margin;
        first = std::min(first, firstContact(query, course, stops, neighbour, margin));
        if (first == kInfiniteCost || whole) continue;
        first_ = index;
        return first;
    }
    return first;
}

Avoider::Hindrance Avoider::hindranceOf(const AvoidanceQuery& query, const Manoeuvre& alone) const {
    Hindrance hindrance;
    const Course course = courseOf(query, alone);
    const Vec2 way = normalized(query.ahead.front() - query.middle, query.own.axis);
    for (std::size_t k = 0; k < near_.size(); ++k) {
        const Neighbour& neighbour = near_[k].neighbour;
        const double contact = firstContact(query, course, false, neighbour, neighbour.margin);
        if (contact >= hindrance.contact) continue;
        const MovingBox& box = neighbour.box;
        // From the left: it comes across, and not from ahead.
        const bool across = cross(way, box.velocity) < -0.4 * length(box.velocity);
        hindrance = {contact, length(box.velocity) < kMeshStands, neighbour.isMesh,
                     neighbour.shares && across && cross(way, box.centre - query.own.centre) > 0.0, k};
    }
    return hindrance;
}

// The time that is lost by it, and some more for what others do not expect.
double Avoider::costOf(const AvoidanceQuery& query, const Hindrance& hindrance, double alone,
                       const Manoeuvre& manoeuvre) const {
    const double cruise = query.cruise;
    const double along = manoeuvre.speed * cosine(manoeuvre.angle);
    double cost = 0.0;
    if (manoeuvre.stops)
        cost = (hindrance.stands   ? kStandWait
                : hindrance.isMesh ? kMeshWait
                                   : kWait) +
               0.5 * (1.0 - along / cruise);
    else
        cost = std::max(0.0, arrivalOf(query, manoeuvre) - alone);
    cost += kFaster * std::max(0.0, along - std::max(query.preferred, 0.1 * cruise)) / cruise;
    if (hindrance.fromLeft && manoeuvre.speed < 0.9 * cruise) cost = cost * kYieldFactor + kYield;
    if (manoeuvre.angle > 0.0) cost = cost * kLeftFactor + kLeft;
    const Vec2 velocity = velocityOf(query, manoeuvre);
    cost += kChange * distance(velocity, velocityOf(query, query.last)) / cruise;
    for (const Vec2 towards : met_) cost += kTowards * std::max(0.0, dot(towards, velocity)) / cruise;
    return cost;
}

void Avoider::listCandidates(const AvoidanceQuery& query, const Hindrance& hindrance, double alone) {
    constexpr double kDegree = kPi / 180.0;
    const auto add = [&](Manoeuvre manoeuvre, bool kept = false) {
        order_.emplace_back(costOf(query, hindrance, alone, manoeuvre),
                            static_cast<std::int32_t>(candidates_.size()));
        candidates_.push_back({manoeuvre, kInfiniteCost, kept});
    };
    if (query.hindered && query.last.seconds > 0.0) add(query.last, true);
    if (query.top > 1.05 * query.preferred) add({query.top, 0.0, kHurries, false});
    for (const double share : kSlowShares)
        for (const double seconds : kSlowTimes) add({share * query.cruise, 0.0, seconds, false});
    for (const double angle : kAngles)
        for (const double share : kShares)
            for (const double seconds : kTimes) add({share * query.top, angle * kDegree, seconds, false});
    for (const double angle : kBackAngles)
        for (const double seconds : kBackTimes) add({0.5 * query.top, angle * kDegree, seconds, false});
    for (const double angle : kStopAngles)
        for (const double share : kStopShares) add({share * query.top, angle * kDegree, kStopsIn, true});
    add({0.0, 0.0, kStopsIn, true});
    std::sort(order_.begin(), order_.end());
}

// The one that meets somebody last; contacts known so far are at most too late.
AvoidanceChoice Avoider::latest(const AvoidanceQuery& query, HasRoom hasRoom) {
    for (auto& [cost, k] : order_) cost = -candidates_[k].contact;
    std::sort(order_.begin(), order_.end());
    AvoidanceChoice choice{{0.0, 0.0, kStopsIn, true}, true, false};
    double latest = contactOf(query, candidates_.back(), true);
    for (const auto& [contact, k] : order_) {
        if (-contact <= latest + kLater) break;
        const Manoeuvre& manoeuvre = candidates_[k].manoeuvre;
        if (manoeuvre.angle != 0.0 && !hasRoom(velocityOf(query, manoeuvre))) continue;
        const double first = contactOf(query, candidates_[k], true);
        if (first <= latest + kLater) continue;
        latest = first;
        choice.manoeuvre = manoeuvre;
    }
    return choice;
}

AvoidanceChoice Avoider::choose(const AvoidanceQuery& query, std::span<const Neighbour> neighbours,
                                HasRoom hasRoom) {
    readNeighbours(query, neighbours);
    const Manoeuvre alone{query.preferred, 0.0, kMoverHorizon, false};
    const Hindrance hindrance = hindranceOf(query, alone);
    if (hindrance.contact == kInfiniteCost && met_.empty()) return {alone, false, true};
    candidates_.assign(1, {alone, kInfiniteCost, false});
    order_.assign(1, {0.0, 0});
    listCandidates(query, hindrance, arrivalOf(query, {query.cruise, 0.0, 0.0, false}));
    first_ = hindrance.who;
    for (const auto& [cost, k] : order_) {
        Candidate& candidate = candidates_[k];
        candidate.contact = contactOf(query, candidate, false);
        if (candidate.contact < kInfiniteCost) continue;
        const Manoeuvre& manoeuvre = candidate.manoeuvre;
        if (manoeuvre.angle == 0.0 || hasRoom(velocityOf(query, manoeuvre))) return {manoeuvre, k > 0, true};
    }
    return latest(query, hasRoom);
}

}  // namespace muster
