#include "engine/passages/way_choice.h"

#include <algorithm>
#include <utility>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr double kLeastGain = 0.02;  // Least gain of a move for agents without a passage [s].
constexpr int kExchangeRounds = 4;
// Detour for which a goal that is a second nearer makes up [s]. An agent that moves to another passage comes
// late, so that of goals with about the same detour the near ones are moved.
constexpr double kNearGoalShare = 0.1;
constexpr std::int32_t kMostBatches = 500;  // Most parts in which a large crowd is moved.
constexpr double kLeastTurnGain = 0.5;      // Least gain of all changes of agents that have a passage [s]...
constexpr double kLeastTurnShare = 0.05;    // ... and as a share of the time that is left.
constexpr double kRounding = 1e-9;          // Upper bound of the rounding of sums of detours [s].

}  // namespace

// Gives an agent without an open passage the shortest route.
void WayChoice::begin(std::span<const std::int32_t> way) {
    way_.assign(way.begin(), way.end());
    for (std::size_t i = 0; i < people_; ++i) {
        const auto total = [&](std::size_t p) {
            return input_.arrival[i * passages_ + p] + input_.onward[i * passages_ + p];
        };
        if (way_[i] >= 0 && total(way_[i]) < kInfiniteCost) continue;
        way_[i] = 0;
        for (std::size_t p = 1; p < passages_; ++p)
            if (total(p) < total(way_[i])) way_[i] = static_cast<std::int32_t>(p);
    }
    goalWay_ = way_;
    exchangeAll(input_.onward, goalWay_, {});
    fillLines();
}

// Exchanges the passages of two agents of one pool for as long as that shortens both walks together; `free`
// may be empty for all. True where any were exchanged.
bool WayChoice::exchangeAll(std::span<const double> table, std::vector<std::int32_t>& way,
                            std::span<const std::uint8_t> free) {
    bool changed = false;
    for (int round = 0; round < kExchangeRounds; ++round) {
        bool any = false;
        for (std::int32_t p = 0; std::cmp_less(p, passages_); ++p)
            for (std::int32_t q = p + 1; std::cmp_less(q, passages_); ++q)
                any = exchange(table, way, free, p, q) || any;
        if (!any) break;
        changed = true;
    }
    return changed;
}

// Exchanges agents between two passages; true where any were exchanged.
bool WayChoice::exchange(std::span<const double> table, std::vector<std::int32_t>& way,
                         std::span<const std::uint8_t> free, std::int32_t p, std::int32_t q) {
    there_.clear();
    back_.clear();
    for (std::int32_t i = 0; std::cmp_less(i, people_); ++i) {
        if ((way[i] != p && way[i] != q) || (!free.empty() && free[i] == 0)) continue;
        const double byP = cost(table, i, p), byQ = cost(table, i, q);
        if (!(byP < kInfiniteCost) || !(byQ < kInfiniteCost)) continue;
        if (way[i] == p)
            there_.push_back({byQ - byP, i});
        else
            back_.push_back({byP - byQ, i});
    }
    if (!keepWorthwhile()) return false;
    sort_.sort(there_);
    sort_.sort(back_);
    bool any = false;
    for (std::int32_t pool = 0; std::cmp_less(pool, pools_); ++pool)
        for (std::size_t there = 0, back = 0;; ++there, ++back) {
            const std::int32_t i = nextOf(there_, there, pool), j = nextOf(back_, back, pool);
            if (i < 0 || j < 0) break;
            const double change = cost(table, i, q) - cost(table, i, p) + cost(table, j, p) -
                                  cost(table, j, q);
            if (!(change < -kLeastGain)) break;
            std::swap(way[i], way[j]);
            any = true;
        }
    return any;
}

// Drops candidates that cannot gain by an exchange. True where some are left on both sides.
bool WayChoice::keepWorthwhile() {
    leastThere_.assign(pools_, kInfiniteCost);
    leastBack_.assign(pools_, kInfiniteCost);
    for (const SortKey& k : there_)
        leastThere_[input_.pool[k.index]] = std::min(leastThere_[input_.pool[k.index]], k.key);
    for (const SortKey& k : back_)
        leastBack_[input_.pool[k.index]] = std::min(leastBack_[input_.pool[k.index]], k.key);
    const auto drop = [&](std::vector<SortKey>& keys, const std::vector<double>& other) {
        std::erase_if(keys, [&](const SortKey& k) {
            return !(k.key + other[input_.pool[k.index]] < kRounding - kLeastGain);
        });
    };
    drop(there_, leastBack_);
    drop(back_, leastThere_);
    return !there_.empty() && !back_.empty();
}

std::int32_t WayChoice::nextOf(const std::vector<SortKey>& order, std::size_t& at, std::int32_t pool) const {
    while (at < order.size() && input_.pool[order[at].index] != pool) ++at;
    return at < order.size() ? order[at].index : -1;
}

// Agents that may leave a passage for another one, the least detour first; some may have left already. With
// `goals` the goals instead, near ones first where the detour is equal.
const std::vector<SortKey>& WayChoice::leavers(bool goals, std::int32_t from, std::int32_t to) {
    Order& order = (goals ? goalLeavers_ : leavers_)[from * passages_ + to];
    if (order.known) return order.keys;
    order.keys.clear();
    for (const Turn& turn : goals ? lines_[from].goals : lines_[from].queue) {
        const double there = cost(goals ? input_.onward : input_.arrival, turn.index, to);
        if (!(there < kInfiniteCost) || (!goals && free_[turn.index] == 0)) continue;
        order.keys.push_back({there - (goals ? 1.0 - kNearGoalShare : 1.0) * turn.time, turn.index});
    }
    sort_.sort(order.keys);
    order.known = true;
    return order.keys;
}

bool WayChoice::move(std::int32_t from, std::int32_t to, std::int32_t batch) {
    movedPeople_.clear();
    movedGoals_.clear();
    wanted_.assign(pools_, 0);
    for (const SortKey& k : leavers(false, from, to)) {
        if (std::ssize(movedPeople_) >= batch) break;
        if (way_[k.index] != from) continue;
        movedPeople_.push_back(k.index);
        ++wanted_[input_.pool[k.index]];
    }
    if (movedPeople_.empty()) return false;
    for (const SortKey& k : leavers(true, from, to)) {
        if (movedGoals_.size() >= movedPeople_.size()) break;
        if (goalWay_[k.index] != from || wanted_[input_.pool[k.index]] == 0) continue;
        movedGoals_.push_back(k.index);
        --wanted_[input_.pool[k.index]];
    }
    if (movedGoals_.size() < movedPeople_.size()) return false;
    for (const std::int32_t i : movedPeople_) way_[i] = to;
    for (const std::int32_t g : movedGoals_) goalWay_[g] = to;
    return true;
}

void WayChoice::takeBack(std::int32_t from) {
    for (const std::int32_t i : movedPeople_) way_[i] = from;
    for (const std::int32_t g : movedGoals_) goalWay_[g] = from;
}

// Moves `batch` agents to the passage where that makes the later of the two ends earliest.
bool WayChoice::improveFrom(std::int32_t from, std::int32_t batch) {
    std::int32_t best = -1;
    double least = last_[from] - kLeastGain;
    for (std::int32_t to = 0; std::cmp_less(to, passages_); ++to) {
        // More people never shorten a line.
        if (to == from || last_[to] >= least || !move(from, to, batch)) continue;
        double later = lastOf(from, nobody_, least, nullptr);
        if (later < least) {
            fillMoved(to);
            later = std::max(later, lastOf(to, moved_, least, nullptr));
        }
        if (later < least) {
            least = later;
            best = to;
        }
        takeBack(from);
    }
    if (best < 0) return false;
    move(from, best, batch);
    keepMove(from, best);
    return true;
}

// Moves agents away from the passage whose last agent arrives latest, in ever smaller numbers; when that
// gains nothing more, from the next one.
double WayChoice::improve() {
    if (exchangeAll(input_.arrival, way_, free_)) fillLines();
    for (Order& order : leavers_) order.known = false;
    settled_.assign(passages_, 0);
    for (;;) {
        std::int32_t worst = -1;
        for (std::int32_t p = 0; std::cmp_less(p, passages_); ++p)
            if (settled_[p] == 0 && (worst < 0 || last_[p] > last_[worst])) worst = p;
        if (worst < 0) break;
        const auto there = static_cast<std::int32_t>(std::count(way_.begin(), way_.end(), worst));
        const std::int32_t least = 1 + static_cast<std::int32_t>(people_) / kMostBatches;
        std::int32_t batch = std::max(1, there / 4);
        while (batch >= least && !improveFrom(worst, batch)) batch /= 2;
        if (batch < least) settled_[worst] = 1;
    }
    return *std::max_element(last_.begin(), last_.end());
}

void WayChoice::read(const WayChoiceInput& input) {
    input_ = input;
    passages_ = input.capacity.size();
    people_ = input.pool.size();
    if (people_ == 0 || passages_ == 0) return;
    last_.assign(passages_, 0.0);
    pools_ = 1 + static_cast<std::size_t>(*std::max_element(input.pool.begin(), input.pool.end()));
    nobody_.poolEnd.assign(pools_, 0);
    leavers_.resize(std::max(leavers_.size(), passages_ * passages_));
    goalLeavers_.resize(leavers_.size());
}

double WayChoice::longestWait() {
    if (people_ == 0 || passages_ == 0) return 0.0;
    none_.assign(people_, -1);
    begin(none_);
    slots_.assign(people_, 0.0);
    readSlots(slots_);
    double longest = 0.0;
    for (std::size_t i = 0; i < people_; ++i)
        longest = std::max(longest, slots_[i] - cost(input_.arrival, static_cast<std::int32_t>(i), way_[i]));
    return longest;
}

void WayChoice::readSlots(std::span<double> slot) {
    for (std::int32_t p = 0; std::cmp_less(p, passages_); ++p) lastOf(p, nobody_, kInfiniteCost, slot.data());
}

// Frees movable agents that have a passage. True where there are any.
bool WayChoice::freeOthers(std::span<const std::int32_t> way) {
    bool any = false;
    for (std::size_t i = 0; i < people_; ++i) {
        if (free_[i] != 0) continue;
        free_[i] = way_[i] != way[i] || input_.movable[i] != 0 ? 1 : 0;
        any = any || free_[i] != 0;
    }
    return any;
}

double WayChoice::choose(std::span<std::int32_t> way, std::span<double> slot) {
    if (people_ == 0 || passages_ == 0) return 0.0;
    begin(way);
    // First the best for agents without a passage; then the gain of turning others.
    free_.resize(people_);
    for (std::size_t i = 0; i < people_; ++i) free_[i] = way_[i] != way[i] ? 1 : 0;
    double last = improve();
    before_ = way_;
    beforeGoals_ = goalWay_;
    if (freeOthers(way)) {
        const double turned = improve();
        if (turned < last - std::max(kLeastTurnGain, kLeastTurnShare * last)) {
            last = turned;
        } else {
            way_ = before_;
            goalWay_ = beforeGoals_;
            fillLines();
        }
    }
    readSlots(slot);
    std::copy(way_.begin(), way_.end(), way.begin());
    return last;
}

}  // namespace muster
