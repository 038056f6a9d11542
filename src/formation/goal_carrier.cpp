#include "formation/goal_carrier.h"

#include <algorithm>
#include <cmath>

#include "muster/base/maths.h"

namespace muster {
namespace {

constexpr std::size_t kChunk = 256;        // Places a task carries.
constexpr std::size_t kLeapShare = 8;      // More than one of so many that leap: all seats are sought anew.
constexpr std::int32_t kLeastSpots = 400;  // Looked at in a step for those without a good seat,
constexpr std::size_t kPlacesPerSpot = 5;  // and one more for so many places.
constexpr std::int32_t kSpared = 4;        // Of these one in so many is for those who have a seat, but not a good one.
constexpr std::int32_t kSeekCost = 8;      // In spots, of asking where one could best be.
constexpr std::int32_t kRings = 8;         // Round that spot, one diameter wide each.
constexpr double kWorthwhile = 2.0;        // A new seat is this much nearer, in diameters, but on the target itself.
constexpr double kTouch = 1.0 - 1e-9;      // Of what is asked for: seats that touch stay so while they are carried.

}  // namespace

// Out of what is in the way, unless that leads too far.
bool GoalCarrier::settle(Vec2& spot, Vec2 from) const {
    const double most = SeatList::slack(apart_);
    spot = from + clampLength(spot - from, most);
    if (!ground_.standable(spot)) spot = ground_.pushed(spot);
    return lengthSquared(spot - from) <= most * most * (1.0 + 1e-9) && ground_.standable(spot);
}

void GoalCarrier::carry(std::size_t k, Vec2 target) {
    const Vec2 seat = s_.goal[k];
    const Vec2 way = target - s_.target[k];
    m_.level[k] = Stays;
    m_.next[k] = m_.carried[k] = seat;
    if (s_.fit[k] == 0) return;
    const double most = SeatList::slack(apart_);
    m_.exact[k] = seat == s_.target[k] ? 1 : 0;
    if (!(lengthSquared(way) <= most * most)) {
        m_.level[k] = Leapt;
        return;
    }
    Vec2& carried = m_.carried[k];
    carried = m_.exact[k] != 0 ? target : seat + way;
    const bool free = ground_.standable(carried);
    if (free || settle(carried, seat)) m_.level[k] = Carried;
    else carried = seat;
    if (m_.exact[k] != 0 && free) return;
    Vec2& next = m_.next[k];
    next = carried + clampLength(target - carried, pull_);
    if (distance(carried, target) <= pull_) next = target;
    if (distance(next, seat) > most || next == carried || !(ground_.standable(next) || settle(next, seat))) return;
    m_.level[k] = Drawn;
}

Vec2 GoalCarrier::spotOf(std::size_t k) const {
    return m_.level[k] == Drawn ? m_.next[k] : m_.level[k] == Carried ? m_.carried[k] : s_.goal[k];
}

void GoalCarrier::lower(std::size_t k) {
    if (m_.losing[k] != 0) return;
    m_.losing[k] = 1;
    m_.losers.push_back(static_cast<std::int32_t>(k));
}

// Of two that would come too near the one that moves more freely gives way; those on their targets last.
void GoalCarrier::meet(std::size_t a, std::size_t b) {
    if (s_.fit[a] == 0 || s_.fit[b] == 0) return;
    const double least = apart_ * kTouch;
    if (lengthSquared(spotOf(a) - spotOf(b)) >= least * least) return;
    const auto rank = [&](std::size_t k) {
        return 2 * m_.level[k] + (m_.level[k] != Stays && m_.exact[k] == 0 ? 1 : 0);
    };
    const int ra = rank(a), rb = rank(b);
    lower(ra != rb ? (ra > rb ? a : b) : std::max(a, b));
}

// In rounds, each decided by what stood before it: the order in which pairs are looked at means nothing.
void GoalCarrier::giveWay() {
    m_.losers.clear();
    m_.losing.assign(s_.goal.size(), 0);
    m_.seats.forPairs([&](std::size_t a, std::size_t b) { meet(a, b); });
    while (!m_.losers.empty()) {
        m_.lowered.swap(m_.losers);
        m_.losers.clear();
        for (const std::int32_t loser : m_.lowered) {
            const auto k = static_cast<std::size_t>(loser);
            m_.losing[k] = 0;
            if (m_.level[k] == Stays) s_.fit[k] = 0;
            else m_.level[k] = m_.level[k] == Drawn ? Carried : Stays;
            // An obstacle may have come to where it stood.
            if (m_.level[k] == Stays && !ground_.standable(s_.goal[k])) s_.fit[k] = 0;
        }
        for (const std::int32_t loser : m_.lowered)
            for (const std::int32_t other : m_.seats.near(static_cast<std::size_t>(loser)))
                meet(static_cast<std::size_t>(loser), static_cast<std::size_t>(other));
    }
}

bool GoalCarrier::offer(std::size_t k, Vec2 spot) {
    const double least = apart_ * apart_;
    for (const std::int32_t taken : m_.taken)
        if (lengthSquared(s_.goal[static_cast<std::size_t>(taken)] - spot) < least) return false;
    if (m_.seats.occupied(spot, s_.goal, s_.fit, k) || !ground_.standable(spot)) return false;
    s_.goal[k] = spot;
    s_.fit[k] = 1;
    m_.taken.push_back(static_cast<std::int32_t>(k));
    return true;
}

// From the spot where it could best be outwards, as long as that is a gain.
bool GoalCarrier::seat(std::size_t k, Vec2 target, std::int32_t& left) {
    left -= kSeekCost;
    const Vec2 best = ground_.reachable(target);
    double gain = 1e300;
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
    const std::size_t first = s_.turn % n;
    for (const bool seated : {false, true}) {
        const std::int32_t spare = seated ? 0 : left / kSpared;
        for (std::size_t k = 0; k < n && left > spare; ++k) {
            const std::size_t place = (first + k) % n;
            if ((s_.fit[place] != 0) != seated || (seated && s_.goal[place] == targets[place])) continue;
            seat(place, targets[place], left);
            s_.turn = static_cast<std::uint32_t>((place + 1) % n);
        }
    }
}

bool GoalCarrier::run(std::span<const Vec2> targets, ThreadPool* pool) {
    const std::size_t n = targets.size();
    if (n == 0 || s_.goal.size() != n || s_.target.size() != n || s_.fit.size() != n) return false;
    for (auto* points : {&m_.next, &m_.carried}) points->resize(n);
    for (auto* marks : {&m_.level, &m_.exact, &m_.losing}) marks->resize(n);
    forChunks(pool, n, kChunk, [&](std::size_t k) { carry(k, targets[k]); });
    const auto leapt = static_cast<std::size_t>(std::count(m_.level.begin(), m_.level.end(), std::uint8_t{Leapt}));
    if (leapt * kLeapShare > n) return false;
    for (std::size_t k = 0; k < n; ++k) {
        const bool stays = m_.level[k] == Stays && (s_.fit[k] == 0 || ground_.standable(s_.goal[k]));
        if (stays || m_.level[k] == Carried || m_.level[k] == Drawn) continue;
        m_.level[k] = Stays;
        s_.fit[k] = 0;
    }
    for (std::size_t k = 0; k < n; ++k)
        if (m_.level[k] != Drawn) m_.next[k] = m_.carried[k];
    m_.seats.update(s_.goal, m_.next, s_.fit, apart_);
    giveWay();
    for (std::size_t k = 0; k < n; ++k) s_.goal[k] = spotOf(k);
    s_.target.assign(targets.begin(), targets.end());
    seatInTurns(targets);
    return true;
}

}  // namespace muster
