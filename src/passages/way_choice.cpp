#include "passages/way_choice.h"

#include <algorithm>
#include <utility>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr double kLeastGain = 0.02;  // Of a move, for those who have no passage yet [s].
constexpr int kExchangeRounds = 4;
// Who is moved to another passage comes late: of goals with about the same detour it takes the near ones. A
// second nearer is worth so much detour [s].
constexpr double kNearer = 0.1;
constexpr std::int32_t kMostBatches = 500;  // A large crowd is moved by at least this part at a time.
constexpr double kWorthTurning = 0.5;       // Of all changes of those who have one [s]...
constexpr double kWorthShare = 0.05;        // ... and as a share of the time that is left.

}  // namespace

void WayChoice::sortAll() {
    byArrival_.resize(passages_);
    byOnward_.resize(passages_);
    byDetour_.resize(passages_ * passages_);
    byGoalDetour_.resize(passages_ * passages_);
    byNearGoal_.resize(passages_ * passages_);
    for (std::vector<std::int32_t>& order : byNearGoal_) order.clear();
    const auto sortBy = [&](std::vector<std::int32_t>& order, const auto& key) {
        keys_.clear();
        for (std::int32_t i = 0; std::cmp_less(i, people_); ++i)
            if (const double k = key(i); k < kInfiniteCost) keys_.push_back({k, i});
        std::sort(keys_.begin(), keys_.end());
        order.clear();
        for (const auto& [k, i] : keys_) order.push_back(i);
    };
    // The same for the negative keys of the last order.
    const auto sortBack = [&](std::vector<std::int32_t>& order) {
        order.clear();
        for (std::size_t end = keys_.size(); end > 0;) {
            std::size_t first = end - 1;
            while (first > 0 && keys_[first - 1].first == keys_[end - 1].first) --first;
            for (std::size_t k = first; k < end; ++k) order.push_back(keys_[k].second);
            end = first;
        }
    };
    for (std::size_t p = 0; p < passages_; ++p) {
        sortBy(byArrival_[p], [&](std::int32_t i) { return cost(input_.arrival, i, p); });
        sortBy(byOnward_[p], [&](std::int32_t i) {
            const double onward = cost(input_.onward, i, p);
            return onward < kInfiniteCost ? -onward : kInfiniteCost;
        });
        for (std::size_t q = p + 1; q < passages_; ++q) {
            const auto detour = [&](std::span<const double> table, std::int32_t i) {
                const double from = cost(table, i, p), to = cost(table, i, q);
                return from < kInfiniteCost && to < kInfiniteCost ? to - from : kInfiniteCost;
            };
            sortBy(byDetour_[p * passages_ + q], [&](std::int32_t i) { return detour(input_.arrival, i); });
            sortBack(byDetour_[q * passages_ + p]);
            sortBy(byGoalDetour_[p * passages_ + q],
                   [&](std::int32_t i) { return detour(input_.onward, i); });
            sortBack(byGoalDetour_[q * passages_ + p]);
        }
    }
}

// Goals by detour, near ones first among equals. Few pairs of passages are asked for, so each is sorted when
// it is.
const std::vector<std::int32_t>& WayChoice::nearGoals(std::int32_t from, std::int32_t to) {
    std::vector<std::int32_t>& order = byNearGoal_[from * passages_ + to];
    if (!order.empty()) return order;
    keys_.clear();
    for (std::int32_t i = 0; std::cmp_less(i, people_); ++i) {
        const double before = cost(input_.onward, i, from), behind = cost(input_.onward, i, to);
        if (before < kInfiniteCost && behind < kInfiniteCost)
            keys_.push_back({behind - (1.0 - kNearer) * before, i});
    }
    std::sort(keys_.begin(), keys_.end());
    for (const auto& [key, i] : keys_) order.push_back(i);
    return order;
}

// Whoever has no passage, or one that is not open any more, takes the shortest way.
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
    exchangeAll(byGoalDetour_, goalWay_, {});
    for (std::size_t p = 0; p < passages_; ++p) last_[p] = lastBy(static_cast<std::int32_t>(p), nullptr);
}

// Exchanges the passages of two of one pool for as long as that shortens both walks together; `free` may be
// empty for all.
void WayChoice::exchangeAll(const std::vector<std::vector<std::int32_t>>& byDetour,
                            std::vector<std::int32_t>& way, std::span<const std::uint8_t> free) {
    const bool goals = &byDetour == &byGoalDetour_;
    const std::span<const double> table = goals ? input_.onward : input_.arrival;
    const auto next = [&](const std::vector<std::int32_t>& order, std::size_t& at, std::int32_t from,
                          std::int32_t pool) {
        while (at < order.size() && (way[order[at]] != from || input_.pool[order[at]] != pool ||
                                     (!free.empty() && free[order[at]] == 0)))
            ++at;
        return at < order.size() ? order[at] : -1;
    };
    for (int round = 0; round < kExchangeRounds; ++round) {
        bool any = false;
        for (std::int32_t p = 0; std::cmp_less(p, passages_); ++p)
            for (std::int32_t q = p + 1; std::cmp_less(q, passages_); ++q)
                for (std::int32_t pool = 0; std::cmp_less(pool, cursor_.size()); ++pool) {
                    std::size_t there = 0, back = 0;
                    for (;;) {
                        const std::int32_t i = next(byDetour[p * passages_ + q], there, p, pool);
                        const std::int32_t j = next(byDetour[q * passages_ + p], back, q, pool);
                        if (i < 0 || j < 0) break;
                        const double change = cost(table, i, q) - cost(table, i, p) + cost(table, j, p) -
                                              cost(table, j, q);
                        if (!(change < -kLeastGain)) break;
                        std::swap(way[i], way[j]);
                        any = true;
                    }
                }
        if (!any) return;
    }
}

// Serves in the order of arrival; who is served first gets the farthest of the goals.
double WayChoice::lastBy(std::int32_t passage, double* slot) {
    const double service = 1.0 / input_.capacity[passage];
    const std::vector<std::int32_t>& goals = byOnward_[passage];
    std::fill(cursor_.begin(), cursor_.end(), 0);
    double free = 0.0, last = 0.0;
    for (const std::int32_t i : byArrival_[passage]) {
        if (way_[i] != passage) continue;
        const double served = std::max(cost(input_.arrival, i, passage), free);
        free = served + service;
        if (slot != nullptr) slot[i] = served;
        std::size_t& at = cursor_[input_.pool[i]];
        while (at < goals.size() &&
               (goalWay_[goals[at]] != passage || input_.pool[goals[at]] != input_.pool[i]))
            ++at;
        if (at < goals.size()) last = std::max(last, served + cost(input_.onward, goals[at++], passage));
    }
    return last;
}

bool WayChoice::move(std::int32_t from, std::int32_t to, std::int32_t batch) {
    movedPeople_.clear();
    movedGoals_.clear();
    std::fill(wanted_.begin(), wanted_.end(), 0);
    for (const std::int32_t i : byDetour_[from * passages_ + to]) {
        if (std::ssize(movedPeople_) >= batch) break;
        if (way_[i] != from || free_[i] == 0) continue;
        movedPeople_.push_back(i);
        ++wanted_[input_.pool[i]];
    }
    for (const std::int32_t g : nearGoals(from, to)) {
        if (movedGoals_.size() >= movedPeople_.size()) break;
        if (goalWay_[g] != from || wanted_[input_.pool[g]] == 0) continue;
        movedGoals_.push_back(g);
        --wanted_[input_.pool[g]];
    }
    if (movedPeople_.empty() || movedGoals_.size() < movedPeople_.size()) return false;
    for (const std::int32_t i : movedPeople_) way_[i] = to;
    for (const std::int32_t g : movedGoals_) goalWay_[g] = to;
    return true;
}

void WayChoice::takeBack(std::int32_t from) {
    for (const std::int32_t i : movedPeople_) way_[i] = from;
    for (const std::int32_t g : movedGoals_) goalWay_[g] = from;
}

// Moves so many to the passage where that makes the later of the two ends earliest.
bool WayChoice::improveFrom(std::int32_t from, std::int32_t batch) {
    std::int32_t best = -1;
    double least = last_[from] - kLeastGain;
    for (std::int32_t to = 0; std::cmp_less(to, passages_); ++to) {
        if (to == from || !move(from, to, batch)) continue;
        const double later = std::max(lastBy(from, nullptr), lastBy(to, nullptr));
        if (later < least) {
            least = later;
            best = to;
        }
        takeBack(from);
    }
    if (best < 0) return false;
    move(from, best, batch);
    last_[from] = lastBy(from, nullptr);
    last_[best] = lastBy(best, nullptr);
    return true;
}

// The passage where the last arrives latest gives characters away, in ever smaller numbers; when it cannot
// gain any more, the next one does.
double WayChoice::improve() {
    exchangeAll(byDetour_, way_, free_);
    for (std::size_t p = 0; p < passages_; ++p) last_[p] = lastBy(static_cast<std::int32_t>(p), nullptr);
    std::vector<std::uint8_t>& settled = settled_;
    settled.assign(passages_, 0);
    for (;;) {
        std::int32_t worst = -1;
        for (std::int32_t p = 0; std::cmp_less(p, passages_); ++p)
            if (settled[p] == 0 && (worst < 0 || last_[p] > last_[worst])) worst = p;
        if (worst < 0) break;
        const auto there = static_cast<std::int32_t>(std::count(way_.begin(), way_.end(), worst));
        const std::int32_t least = 1 + static_cast<std::int32_t>(people_) / kMostBatches;
        std::int32_t batch = std::max(1, there / 4);
        while (batch >= least && !improveFrom(worst, batch)) batch /= 2;
        if (batch < least) settled[worst] = 1;
    }
    return *std::max_element(last_.begin(), last_.end());
}

void WayChoice::read(const WayChoiceInput& input) {
    input_ = input;
    passages_ = input.capacity.size();
    people_ = input.pool.size();
    if (people_ == 0 || passages_ == 0) return;
    last_.assign(passages_, 0.0);
    const std::size_t pools = 1 + *std::max_element(input.pool.begin(), input.pool.end());
    cursor_.assign(pools, 0);
    wanted_.assign(pools, 0);
    sortAll();
}

double WayChoice::longestWait() {
    if (people_ == 0 || passages_ == 0) return 0.0;
    none_.assign(people_, -1);
    begin(none_);
    slots_.assign(people_, 0.0);
    for (std::size_t p = 0; p < passages_; ++p) lastBy(static_cast<std::int32_t>(p), slots_.data());
    double longest = 0.0;
    for (std::size_t i = 0; i < people_; ++i)
        longest = std::max(longest, slots_[i] - cost(input_.arrival, static_cast<std::int32_t>(i), way_[i]));
    return longest;
}

double WayChoice::choose(std::span<std::int32_t> way, std::span<double> slot) {
    if (people_ == 0 || passages_ == 0) return 0.0;
    begin(way);
    // First the best for those who have none; then what turning others would gain.
    free_.resize(people_);
    for (std::size_t i = 0; i < people_; ++i) free_[i] = way_[i] != way[i] ? 1 : 0;
    double last = improve();
    before_ = way_;
    beforeGoals_ = goalWay_;
    for (std::size_t i = 0; i < people_; ++i) free_[i] = way_[i] != way[i] || input_.movable[i] != 0 ? 1 : 0;
    const double turned = improve();
    if (turned < last - std::max(kWorthTurning, kWorthShare * last)) {
        last = turned;
    } else {
        way_ = before_;
        goalWay_ = beforeGoals_;
    }
    for (std::size_t p = 0; p < passages_; ++p) lastBy(static_cast<std::int32_t>(p), slot.data());
    std::copy(way_.begin(), way_.end(), way.begin());
    return last;
}

}  // namespace muster
