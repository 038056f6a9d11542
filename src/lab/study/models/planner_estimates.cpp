// Estimated times of plans.
#include "lab/study/models/planner.h"

#include <algorithm>

namespace muster {
namespace {

constexpr double kSwathShare = 0.8;   // Share of a part's width that the operator counts on.
constexpr double kFrontShare = 0.75;  // Share of a walker's speed that a wide front makes.
// Share of a walker's speed that a front of a single rank makes: it bends more, and misses more.
constexpr double kThinShare = 0.6;
constexpr double kThinRanks = 1.3;     // Number of ranks below which a front is thin.
constexpr double kTapDownTime = 0.05;  // Time that a finger is down for a tap [s].

double wayLength(Vec2 from, std::span<const Vec2> way) {
    double sum = 0.0;
    for (const Vec2 p : way) {
        sum += distance(from, p);
        from = p;
    }
    return sum;
}

}  // namespace

double toleranceOf(const SeenPart& part) {
    return std::max(kTargetMetres, kSwathShare * std::min(part.bounds.width(), part.bounds.height()));
}

double Planner::cutSeconds() const {
    const double mm = def_.mmPerMetre;
    return motor_->point(6.0 * mm, kTargetMetres * mm) + motor_->drag(8.0 * mm, kTargetMetres * mm) +
           motor_->device().handOff + motor_->factor() * def_.parameters.decideNext + 2.0 * motor_->press();
}

double Planner::selectSeconds(const PlannedPart& planned) const {
    const double mm = def_.mmPerMetre;
    const double size = distance(planned.part.bounds.min, planned.part.bounds.max);
    double seconds = motor_->point(8.0 * mm, kTargetMetres * mm) +
                     motor_->drag(size * mm, kTargetMetres * mm);
    seconds += 2.0 * motor_->press();
    return seconds + motor_->factor() * def_.parameters.attention;
}

double Planner::clickSeconds(const PlannedPart& planned, double metres) const {
    const double mm = def_.mmPerMetre;
    return motor_->point(metres * mm, toleranceOf(planned.part) * mm) + 2.0 * motor_->press() +
           motor_->factor() * def_.parameters.decideNext;
}

double Planner::sendSeconds(const PlannedPart& planned) const {
    const double mm = def_.mmPerMetre;
    const double next = motor_->factor() * def_.parameters.decideNext;
    if (!def_.repertoire.draws) {
        double seconds = selectSeconds(planned);
        Vec2 at = planned.part.centre;
        for (const Vec2 p : planned.way) {
            seconds += clickSeconds(planned, distance(at, p));
            at = p;
        }
        return seconds;
    }
    const double across = std::min(planned.part.bounds.width(), planned.part.bounds.height()) + 1.0;
    const double wide = std::max(across, kTargetMetres) * mm;
    double seconds = motor_->point(8.0 * mm, wide) + motor_->factor() * def_.parameters.attention;
    const double stops = std::max<double>(1.0, static_cast<double>(planned.stops.size()));
    seconds += motor_->draw(wayLength(planned.part.centre, planned.way) * mm,
                            toleranceOf(planned.part) * mm) +
               next * stops;
    if (planned.width > 0.0)
        seconds += motor_->factor() * def_.parameters.secondHand +
                   motor_->drag(0.5 * planned.width * mm, kTargetMetres * mm);
    return seconds + 2.0 * motor_->press();
}

double Planner::walkSeconds(const PlannedPart& planned) const {
    if (planned.width > 0.0) return sweepSeconds(planned);
    Vec2 at = planned.part.centre;
    double metres = 0.0;
    for (const Vec2 p : planned.way) {
        metres += def_.repertoire.draws ? distance(at, p) : tours_->ground().distance(at, p);
        at = p;
    }
    return metres / def_.speed;
}

// A wide front is as slow as those of its characters that have the longest detour.
double Planner::sweepSeconds(const PlannedPart& planned) const {
    const Vec2 across = perpendicular(planned.along);
    double most = 0.0;
    for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const Vec2 side = across * (0.5 * share * planned.width);
        Vec2 at = def_.border.clamp(planned.part.centre + side);
        double metres = 0.0;
        for (const Vec2 p : planned.way) {
            const Vec2 to = def_.border.clamp(p + side);
            metres += tours_->ground().distance(at, to);
            at = to;
        }
        most = std::max(most, metres);
    }
    const bool thin = kThinRanks * planned.width >
                      def_.spacing * static_cast<double>(planned.part.ids.size());
    return most / ((thin ? kThinShare : kFrontShare) * def_.speed) + foldSeconds(planned);
}

// A front folds where it finds little of its width, and unfolds behind.
double Planner::foldSeconds(const PlannedPart& planned) const {
    double most = 0.0;
    Vec2 at = planned.part.centre;
    for (const Vec2 to : planned.way) {
        const SeenGround::Narrow narrow = tours_->ground().narrowest(at, to, planned.width);
        if (narrow.end > 0.0) most = std::max(most, planned.width - narrow.least);
        at = to;
    }
    return most / def_.speed;
}

// Estimate for parts that go on by themselves once they are sent.
double Planner::estimateQueued(const OperatorPlan& plan) const {
    double now = cutSeconds() * static_cast<double>(plan.cuts.size());
    if (!def_.repertoire.draws) now = 0.0;
    double last = 0.0;
    for (const PlannedPart& planned : plan.parts) {
        if (planned.way.empty()) continue;
        const double send = sendSeconds(planned);
        const double first = def_.repertoire.draws ? 0.3 * send
                                                   : selectSeconds(planned) + clickSeconds(planned, 5.0);
        last = std::max(
            {last, now + first + planned.reforms + walkSeconds(planned) + planned.later, now + send});
        now += send;
    }
    return last;
}

// Estimate for parts that wait for their next point until the operator comes back to them.
double Planner::estimateAttended(const OperatorPlan& plan) const {
    const std::size_t n = plan.parts.size();
    std::vector<double> due(n, 0.0);
    std::vector<std::size_t> next(n, 0);
    double now = 0.0;
    double last = 0.0;
    std::size_t before = n;
    for (;;) {
        std::size_t chosen = n;
        for (std::size_t i = 0; i < n; ++i)
            if (next[i] < plan.parts[i].way.size() && (chosen == n || due[i] < due[chosen])) chosen = i;
        if (chosen == n) return last;
        const PlannedPart& planned = plan.parts[chosen];
        const Vec2 from = next[chosen] == 0 ? planned.part.centre : planned.way[next[chosen] - 1];
        const Vec2 to = planned.way[next[chosen]];
        now = std::max(now, due[chosen] + (next[chosen] > 0 ? def_.parameters.reaction : 0.0));
        if (chosen != before) now += selectSeconds(planned);
        now += clickSeconds(planned, distance(from, to));
        due[chosen] = now + tours_->ground().distance(from, to) / def_.speed;
        last = std::max(last, due[chosen]);
        ++next[chosen];
        before = chosen;
    }
}

double Planner::estimate(const OperatorPlan& plan) const {
    return def_.repertoire.draws || def_.repertoire.queues ? estimateQueued(plan) : estimateAttended(plan);
}

double Planner::partSeconds(const PlannedPart& planned) const {
    OperatorPlan plan{.parts = {planned}};
    return estimate(plan);
}

double Planner::takeOutSeconds(const PlannedPart& few) const {
    if (!def_.repertoire.draws) return 0.0;  // A scheme without strokes selects them anyway.
    const double mm = def_.mmPerMetre;
    const double round = 2.0 * (few.part.bounds.width() + few.part.bounds.height() + 4.0 * kTakenMargin);
    return motor_->point(6.0 * mm, kTargetMetres * mm) + motor_->draw(round * mm, kTargetMetres * mm) +
           motor_->device().handOff + motor_->factor() * def_.parameters.decideNext + 2.0 * motor_->press();
}

double Planner::callSeconds() const {
    const double mm = def_.mmPerMetre;
    return motor_->point(8.0 * mm, kTargetMetres * mm) + 2.0 * kTapDownTime + kBetweenTaps +
           motor_->factor() * def_.parameters.decideNext;
}

}  // namespace muster
