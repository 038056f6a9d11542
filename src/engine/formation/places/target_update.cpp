#include "engine/formation/places/target_update.h"

#include <algorithm>
#include <cmath>

#include "engine/formation/places/ring_search.h"
#include "engine/formation/places/target_separation.h"

namespace muster {
namespace {

// Greatest movement of a reachable target in a step, as a share of the separation.
constexpr double kMaxStep = 0.3;
// Ratio to the distance of others from which on a place in a wall leaps to its target.
constexpr double kStray = 3.0;
// Inverse share of jumping targets above which all are separated again.
constexpr std::size_t kDiscontinuousShare = 8;
constexpr std::int32_t kBaseBudget = 400;   // Number of points examined per step by places that search,
constexpr std::size_t kPlacesPerPoint = 5;  // and number of places for each of which one more is added.
// Inverse share that is reserved for places that have a point already.
constexpr std::int32_t kReservedShare = 4;
constexpr std::int32_t kProjectionCost = 8;  // Cost of a projection onto the free space, in examined points.
// Distance by which a new point must be nearer to the target, in separations.
constexpr double kLeastGain = 2.0;
constexpr std::uint32_t kFloodPause = 120;  // Steps before the next flood where a region is full.
// Inverse share of points with which places go on where all have searched in vain and nothing has moved
// since.
constexpr std::int32_t kQuietShare = 16;

}  // namespace

double TargetUpdate::maxStep() const {
    return kMaxStep * separation_;
}

// Corrects a point outside the free space: a shorter step, else a projection, unless that leads too far.
bool TargetUpdate::correct(Vec2& point, Vec2 from) const {
    const double most = maxStep();
    const Vec2 near = from + clampLength(point - from, most);
    const bool free = near != point && space_.contains(near);
    point = free ? near : space_.project(near);
    return lengthSquared(point - from) <= most * most * (1.0 + 1e-9) && (free || space_.contains(point));
}

// True where the proposals of the last step were made on this ground.
bool TargetUpdate::restingHold() {
    RestingProposals& r = m_.resting;
    const Environment& environment = space_.routes().environment();
    const bool holds = r.proposals.size() == s_.reachable.size() && r.instance == environment.instance() &&
                       r.version == environment.staticVersion() && r.region == space_.region() &&
                       r.attraction == attraction_ && r.separation == separation_ &&
                       r.clear == space_.clearRadius();
    r.instance = environment.instance();
    r.version = environment.staticVersion();
    r.region = space_.region();
    r.attraction = attraction_;
    r.separation = separation_;
    r.clear = space_.clearRadius();
    if (!holds) r.proposals.assign(s_.reachable.size(), {});
    return environment.movingObstacleAreas().empty();
}

// Proposes again, or recalls the last proposal: that of a resting target does not change while nothing does.
void TargetUpdate::proposeOrRecall(std::int32_t k, Vec2 target, bool recalls) {
    RestingProposals::Proposal& last = m_.resting.proposals[k];
    m_.inWall[k] = s_.reachable[k] != s_.target[k] && !space_.contains(target) ? 1 : 0;
    const bool rests = recalls && s_.fit[k] != 0 && s_.target[k] == target;
    if (rests && last.known && last.reachable == s_.reachable[k] && last.target == target) {
        m_.advected[k] = last.advected;
        m_.next[k] = last.next;
        m_.level[k] = last.level;
        m_.exact[k] = last.exact;
        return;
    }
    propose(k, target);
    // A fixed point is proposed again in each step, since an obstacle may have come over it.
    last.known = rests && m_.level[k] != Fixed;
    if (last.known)
        last = {s_.reachable[k], target, m_.advected[k], m_.next[k], m_.level[k], m_.exact[k], true};
}

bool TargetUpdate::mostAreInWalls() const {
    return 2 * std::count(m_.inWall.begin(), m_.inWall.end(), std::uint8_t{1}) > std::ssize(m_.inWall);
}

// True where none of the listed pairs is nearer than `distance`.
bool TargetUpdate::nobodyIsNear(double distance) const {
    const double least = distance * kSeparationTolerance;
    const auto isNear = [&](NeighbourPair pair) {
        return lengthSquared(s_.reachable[pair.low] - s_.reachable[pair.high]) < least * least &&
               s_.fit[pair.low] != 0 && s_.fit[pair.high] != 0;
    };
    const auto pairs = m_.neighbours.pairs();
    return std::none_of(pairs.begin(), pairs.end(), isNear);
}

// Once all targets are loose they stay so; a flood that finds no room ends that.
void TargetUpdate::listNeighbours() {
    const double loose = kLooseSpacing * separation_;
    const bool wide = mostAreInWalls();
    m_.neighbours.updateRows(s_.reachable, m_.next, s_.fit, wide ? loose : separation_, kTargetSkin);
    if (wide && nobodyIsNear(loose)) separation_ = loose;
}

void TargetUpdate::propose(std::int32_t k, Vec2 target) {
    const Vec2 now = s_.reachable[k];
    const Vec2 displacement = target - s_.target[k];
    const double most = maxStep();
    const bool exact = now == s_.target[k];
    const bool jumps = !(lengthSquared(displacement) <= most * most);
    const bool fit = s_.fit[k] != 0;
    // Most reachable targets are on their targets and move with them.
    const bool free = fit && !jumps && space_.contains(exact ? target : now + displacement);
    const bool follows = exact && free;
    m_.advected[k] = m_.next[k] = follows ? target : now;
    m_.level[k] = follows ? Advected : fit && jumps ? Discontinuous : Fixed;
    m_.exact[k] = exact ? 1 : 0;
    if (fit && !jumps && !follows) proposeAttracted(k, target, exact ? target : now + displacement, free);
}

// Proposes for a point that is not on its target.
void TargetUpdate::proposeAttracted(std::int32_t k, Vec2 target, Vec2 advected, bool free) {
    const Vec2 now = s_.reachable[k];
    if (free || correct(advected, now)) {
        m_.level[k] = Advected;
        m_.next[k] = m_.advected[k] = advected;
    } else {
        advected = now;
    }
    Vec2 next = advected + clampLength(target - advected, attraction_);
    if (distance(advected, target) <= attraction_) next = target;
    const bool near = distance(next, now) <= maxStep() && next != advected;
    if (!near || !(space_.contains(next) || correct(next, now))) return;
    m_.level[k] = Attracted;
    m_.next[k] = next;
}

bool TargetUpdate::inConflict(std::int32_t a, std::int32_t b) const {
    const double least = separation_ * kSeparationTolerance;
    return lengthSquared(m_.next[a] - m_.next[b]) < least * least && s_.fit[a] != 0 && s_.fit[b] != 0;
}

// Chooses which of two points in conflict yields: the one of higher level; at the same level points on their
// targets have priority.
void TargetUpdate::chooseYielding(std::int32_t a, std::int32_t b) {
    const auto rank = [&](std::int32_t k) {
        return 2 * m_.level[k] + (m_.level[k] != Fixed && m_.exact[k] == 0 ? 1 : 0);
    };
    const int ra = rank(a), rb = rank(b);
    const std::int32_t chosen = ra != rb ? (ra > rb ? a : b) : std::max(a, b);
    if (m_.yielding[chosen] != 0) return;
    m_.yielding[chosen] = 1;
    m_.yields.push_back(chosen);
}

void TargetUpdate::lowerLevel(std::int32_t k) {
    m_.yielding[k] = 0;
    if (m_.level[k] == Fixed)
        s_.fit[k] = 0;
    else
        m_.level[k] = m_.level[k] == Attracted ? Advected : Fixed;
    m_.next[k] = m_.level[k] == Advected ? m_.advected[k] : s_.reachable[k];
    // An obstacle may have moved over the point.
    if (m_.level[k] == Fixed && !space_.contains(s_.reachable[k])) s_.fit[k] = 0;
}

// Each round lists all conflicts before it lowers levels, so the order of pairs does not matter.
void TargetUpdate::resolveConflicts() {
    m_.yields.clear();
    m_.yielding.assign(s_.reachable.size(), 0);
    const auto examine = [&](std::int32_t a, std::int32_t b) {
        if (inConflict(a, b)) chooseYielding(a, b);
    };
    for (const NeighbourPair pair : m_.neighbours.pairs()) examine(pair.low, pair.high);
    while (!m_.yields.empty()) {
        m_.lowered.swap(m_.yields);
        m_.yields.clear();
        for (const std::int32_t k : m_.lowered) lowerLevel(k);
        for (const std::int32_t k : m_.lowered)
            m_.neighbours.forRow(k, [&](std::int32_t other) { examine(k, other); });
    }
}

bool TargetUpdate::tryPoint(std::int32_t k, Vec2 point) {
    const double least = separation_ * separation_;
    for (const std::int32_t other : m_.relocated)
        if (lengthSquared(s_.reachable[other] - point) < least) return false;
    const bool occupied = m_.neighbours.anyNear(point, [&](std::int32_t other) {
        return other != k && s_.fit[other] != 0 && lengthSquared(s_.reachable[other] - point) < least;
    });
    if (occupied || !space_.contains(point)) return false;
    s_.reachable[k] = point;
    s_.fit[k] = 1;
    m_.relocated.push_back(k);
    return true;
}

// Tries the free point nearest to the target, then rings about it as long as they are a gain.
bool TargetUpdate::relocate(std::int32_t k, Vec2 target, std::int32_t& budget) {
    budget -= kProjectionCost;
    double gain = 1e300;
    // Near its target a place gives up its point only for the target itself.
    if (s_.fit[k] != 0 && distance(s_.reachable[k], target) <= kLeastGain * separation_)
        return tryPoint(k, target);
    // In walls one point is as good as another, unless the others are far ahead.
    if (s_.fit[k] != 0 && m_.inWall[k] != 0 && distance(s_.reachable[k], target) <= stray_) return false;
    const Vec2 best = space_.nearest(target);
    if (s_.fit[k] != 0)
        gain = distance(s_.reachable[k], target) - distance(best, target) - kLeastGain * separation_;
    if ((gain > 0.0 || best == target) && tryPoint(k, best)) return true;
    if (searchRings(best, separation_, gain, budget, [&](Vec2 p) { return tryPoint(k, p); })) return true;
    if (s_.fit[k] == 0) s_.reachable[k] = best;
    return false;
}

// Distance from its target at which a place leaves a wall for a point nearer to it.
double TargetUpdate::strayDistance(std::span<const Vec2> targets) const {
    double sum = 0.0;
    std::size_t count = 0;
    for (const std::int32_t k : m_.searching) {
        if (s_.fit[k] == 0) continue;
        sum += distance(s_.reachable[k], targets[k]);
        ++count;
    }
    return count > 0 ? kStray * sum / static_cast<double>(count) : 0.0;
}

// Relocates first places without a point, then places that may find a better one.
void TargetUpdate::relocateRoundRobin(std::span<const Vec2> targets, double tight) {
    m_.relocated.clear();
    const std::size_t n = targets.size();
    std::int32_t budget = kBaseBudget + static_cast<std::int32_t>(n / kPlacesPerPoint);
    if (s_.quiet > n) budget /= kQuietShare;
    listSearching(targets, static_cast<std::int32_t>(s_.nextSearch % n));
    stray_ = strayDistance(targets);
    for (const bool fit : {false, true}) {
        const std::int32_t reserved = fit ? 0 : budget / kReservedShare;
        for (std::size_t at = 0; at < m_.searching.size() && budget > reserved; ++at) {
            const std::int32_t k = m_.searching[at];
            if ((s_.fit[k] != 0) != fit || (fit && s_.reachable[k] == targets[k])) continue;
            s_.quiet = relocate(k, targets[k], budget) ? 0 : s_.quiet + 1;
            s_.nextSearch = static_cast<std::uint32_t>((k + 1) % n);
        }
    }
    if (s_.pause > 0) --s_.pause;
    if (s_.pause > 0) return;
    if (separation_ > tight && !flood()) separation_ = tight;
    if (separation_ <= tight && !flood()) s_.pause = kFloodPause;
}

// Floods once for the places without a point that it meets. False where there is no room.
bool TargetUpdate::flood() {
    bool any = false;
    for (const std::int32_t k : m_.searching) {
        if (s_.fit[k] != 0) continue;
        if (!any) m_.flood.begin(space_.routes(), space_.region(), kSiteSpacing * separation_);
        any = true;
        m_.flood.add(k, s_.reachable[k]);
    }
    if (!any) return true;
    const bool served = m_.flood.run(1, [&](std::int32_t k, Vec2 p) { return tryPoint(k, p); });
    s_.quiet = 0;
    return served;
}

// Lists places that are not on their targets, from `first` on and round.
void TargetUpdate::listSearching(std::span<const Vec2> targets, std::int32_t first) {
    m_.searching.clear();
    const auto list = [&](std::int32_t from, std::int32_t to) {
        for (std::int32_t k = from; k < to; ++k)
            if (s_.fit[k] == 0 || s_.reachable[k] != targets[k]) m_.searching.push_back(k);
    };
    list(first, static_cast<std::int32_t>(targets.size()));
    list(0, first);
}

bool TargetUpdate::run(std::span<const Vec2> targets, ThreadPool* pool) {
    const std::size_t n = targets.size();
    if (n == 0 || s_.reachable.size() != n || s_.target.size() != n || s_.fit.size() != n) return false;
    for (auto* points : {&m_.next, &m_.advected}) points->resize(n);
    for (auto* marks : {&m_.level, &m_.exact, &m_.inWall, &m_.yielding}) marks->resize(n);
    for (auto* list : {&m_.yields, &m_.lowered, &m_.searching, &m_.relocated}) list->reserve(n);
    const bool recalls = restingHold();
    forChunks(pool, n, kPerTask,
              [&](std::size_t k) { proposeOrRecall(static_cast<std::int32_t>(k), targets[k], recalls); });
    const std::size_t jumps = std::count(m_.level.begin(), m_.level.end(), std::uint8_t{Discontinuous});
    if (jumps * kDiscontinuousShare > n) return false;
    for (std::size_t k = 0; k < n; ++k) {
        if (m_.level[k] == Advected || m_.level[k] == Attracted) continue;
        if (m_.level[k] == Fixed && (s_.fit[k] == 0 || space_.contains(s_.reachable[k]))) continue;
        m_.level[k] = Fixed;
        s_.fit[k] = 0;
    }
    const double tight = separation_;
    listNeighbours();
    resolveConflicts();
    if (s_.reachable != m_.next) s_.quiet = 0;
    s_.reachable.swap(m_.next);
    s_.target.assign(targets.begin(), targets.end());
    relocateRoundRobin(targets, tight);
    return true;
}

}  // namespace muster
