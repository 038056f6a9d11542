#include "formation/places/goal_carrier.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster {
namespace {

constexpr std::size_t kChunk = 256;        // Places a task carries.
constexpr std::size_t kLeapShare = 8;      // More than one of so many that leap: all seats are sought anew.
constexpr std::int32_t kLeastSpots = 400;  // Looked at in a step for those without a good seat,
constexpr std::size_t kPlacesPerSpot = 5;  // and one more for so many places.
// Of these one in so many is for those who have a seat, but not a good one.
constexpr std::int32_t kSpared = 4;
constexpr std::int32_t kSeekCost = 8;  // In spots, of asking where one could best be.
constexpr std::int32_t kRings = 8;     // Round that spot, one diameter wide each.
// A new seat is this much nearer, in diameters, but on the target itself.
constexpr double kWorthwhile = 2.0;
// Of what is asked for: seats that touch stay so while they are carried.
constexpr double kTouch = 1.0 - 1e-9;

}  // namespace

// For a spot where nobody can stand: out of what is in the way, unless that leads too far.
bool GoalCarrier::settle(Vec2& spot, Vec2 from) const {
    const double most = SeatList::slack(apart_);
    const Vec2 near = from + clampLength(spot - from, most);
    const bool free = near != spot && ground_.standable(near);
    spot = free ? near : ground_.pushed(near);
    return lengthSquared(spot - from) <= most * most * (1.0 + 1e-9) && (free || ground_.standable(spot));
}

void GoalCarrier::carry(std::size_t k, Vec2 target) {
    const Vec2 seat = s_.goal[k];
    const Vec2 way = target - s_.target[k];
    const double most = SeatList::slack(apart_);
    const bool exact = seat == s_.target[k];
    const bool leaps = !(lengthSquared(way) <= most * most);
    const bool fit = s_.fit[k] != 0;
    // Most sit on their targets and go with them.
    const bool free = fit && !leaps && ground_.standable(exact ? target : seat + way);
    const bool rides = exact && free;
    m_.carried[k] = m_.next[k] = rides ? target : seat;
    m_.level[k] = rides ? Carried : fit && leaps ? Leapt : Stays;
    m_.exact[k] = exact ? 1 : 0;
    if (fit && !leaps && !rides) approach(k, target, exact ? target : seat + way, free);
}

// For those who are not where they would be: with their targets, if they can, and nearer to them.
void GoalCarrier::approach(std::size_t k, Vec2 target, Vec2 carried, bool free) {
    const Vec2 seat = s_.goal[k];
    if (free || settle(carried, seat)) {
        m_.level[k] = Carried;
        m_.next[k] = m_.carried[k] = carried;
    } else {
        carried = seat;
    }
    Vec2 next = carried + clampLength(target - carried, pull_);
    if (distance(carried, target) <= pull_) next = target;
    const bool near = distance(next, seat) <= SeatList::slack(apart_) && next != carried;
    if (!near || !(ground_.standable(next) || settle(next, seat))) return;
    m_.level[k] = Drawn;
    m_.next[k] = next;
}

bool GoalCarrier::tooNear(std::size_t a, std::size_t b) const {
    const double least = apart_ * kTouch;
    return lengthSquared(m_.next[a] - m_.next[b]) < least * least && s_.fit[a] != 0 && s_.fit[b] != 0;
}

// Of two that would come too near the one that moves more freely gives way; those on their targets last.
void GoalCarrier::part(std::size_t a, std::size_t b) {
    const auto rank = [&](std::size_t k) {
        return 2 * m_.level[k] + (m_.level[k] != Stays && m_.exact[k] == 0 ? 1 : 0);
    };
    const int ra = rank(a), rb = rank(b);
    const std::size_t loser = ra != rb ? (ra > rb ? a : b) : std::max(a, b);
    if (m_.losing[loser] != 0) return;
    m_.losing[loser] = 1;
    m_.losers.push_back(static_cast<std::int32_t>(loser));
}

void GoalCarrier::lower(std::size_t k) {
    m_.losing[k] = 0;
    if (m_.level[k] == Stays)
        s_.fit[k] = 0;
    else
        m_.level[k] = m_.level[k] == Drawn ? Carried : Stays;
    m_.next[k] = m_.level[k] == Carried ? m_.carried[k] : s_.goal[k];
    // An obstacle may have come to where it stood.
    if (m_.level[k] == Stays && !ground_.standable(s_.goal[k])) s_.fit[k] = 0;
}

// In rounds, each decided by what stood before it: the order in which pairs are looked at means nothing.
void GoalCarrier::giveWay() {
    m_.losers.clear();
    m_.losing.assign(s_.goal.size(), 0);
    const auto meet = [&](std::size_t a, std::size_t b) {
        if (tooNear(a, b)) part(a, b);
    };
    m_.seats.forPairs(meet);
    while (!m_.losers.empty()) {
        m_.lowered.swap(m_.losers);
        m_.losers.clear();
        for (const std::int32_t loser : m_.lowered) lower(static_cast<std::size_t>(loser));
        for (const std::int32_t loser : m_.lowered) {
            const auto k = static_cast<std::size_t>(loser);
            m_.seats.forNear(k, [&](std::size_t other) { meet(k, other); });
        }
    }
}

bool GoalCarrier::offer(std::size_t k, Vec2 spot) {
    const double least = apart_ * apart_;
    for (const std::int32_t taken : m_.taken)
        if (lengthSquared(s_.goal[taken] - spot) < least) return false;
    if (m_.seats.occupied(spot, s_.goal, s_.fit, k) || !ground_.standable(spot)) return false;
    s_.goal[k] = spot;
    s_.fit[k] = 1;
    m_.taken.push_back(static_cast<std::int32_t>(k));
    return true;
}

// From the spot where it could best be outwards, as long as that is a gain.
bool GoalCarrier::seat(std::size_t k, Vec2 target, std::int32_t& left) {
    left -= kSeekCost;
    double gain = 1e300;
    // Near its target it leaves a seat for nothing but the target itself.
    if (s_.fit[k] != 0 && distance(s_.goal[k], target) <= kWorthwhile * apart_) return offer(k, target);
    const Vec2 best = ground_.reachable(target);
    if (s_.fit[k] != 0) gain = distance(s_.goal[k], target) - distance(best, target) - kWorthwhile * apart_;
    if ((gain > 0.0 || best == target) && offer(k, best)) return true;
    for (std::int32_t ring = 1; ring <= kRings; ++ring) {
        const double radius = 1.01 * apart_ * ring;
        if (radius > gain) return false;
        const std::int32_t spots = 6 * ring;
        for (std::int32_t s = 0; s < spots; ++s, --left) {
            const double angle = 2.0 * kPi * (s + 0.5 * (ring % 2)) / spots;
            if (offer(k, best + Vec2{cosine(angle), sine(angle)} * radius)) return true;
        }
    }
    if (s_.fit[k] == 0) s_.goal[k] = best;
    return false;
}

// First those who have none, then those who might have better ones.
void GoalCarrier::seatInTurns(std::span<const Vec2> targets) {
    m_.taken.clear();
    const std::size_t n = targets.size();
    std::int32_t left = kLeastSpots + static_cast<std::int32_t>(n / kPlacesPerSpot);
    listSeekers(targets, s_.turn % n);
    for (const bool seated : {false, true}) {
        const std::int32_t spare = seated ? 0 : left / kSpared;
        for (std::size_t at = 0; at < m_.seekers.size() && left > spare; ++at) {
            const auto place = static_cast<std::size_t>(m_.seekers[at]);
            if ((s_.fit[place] != 0) != seated || (seated && s_.goal[place] == targets[place])) continue;
            seat(place, targets[place], left);
            s_.turn = static_cast<std::uint32_t>((place + 1) % n);
        }
    }
}

// Those without the best seat, the one whose turn it is first.
void GoalCarrier::listSeekers(std::span<const Vec2> targets, std::size_t first) {
    m_.seekers.clear();
    const auto list = [&](std::size_t from, std::size_t to) {
        for (std::size_t k = from; k < to; ++k)
            if (s_.fit[k] == 0 || s_.goal[k] != targets[k])
                m_.seekers.push_back(static_cast<std::int32_t>(k));
    };
    list(first, targets.size());
    list(0, first);
}

bool GoalCarrier::run(std::span<const Vec2> targets, ThreadPool* pool) {
    const std::size_t n = targets.size();
    if (n == 0 || s_.goal.size() != n || s_.target.size() != n || s_.fit.size() != n) return false;
    for (auto* points : {&m_.next, &m_.carried}) points->resize(n);
    for (auto* marks : {&m_.level, &m_.exact, &m_.losing}) marks->resize(n);
    forChunks(pool, n, kChunk, [&](std::size_t k) { carry(k, targets[k]); });
    const auto leapt = static_cast<std::size_t>(
        std::count(m_.level.begin(), m_.level.end(), std::uint8_t{Leapt}));
    if (leapt * kLeapShare > n) return false;
    for (std::size_t k = 0; k < n; ++k) {
        if (m_.level[k] == Carried || m_.level[k] == Drawn) continue;
        if (m_.level[k] == Stays && (s_.fit[k] == 0 || ground_.standable(s_.goal[k]))) continue;
        m_.level[k] = Stays;
        s_.fit[k] = 0;
    }
    m_.seats.update(s_.goal, m_.next, s_.fit, apart_);
    giveWay();
    s_.goal.swap(m_.next);
    s_.target.assign(targets.begin(), targets.end());
    seatInTurns(targets);
    return true;
}

}  // namespace muster
