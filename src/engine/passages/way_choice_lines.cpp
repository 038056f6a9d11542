// Those who go through each passage, and when the last of them is in place.
#include <algorithm>
#include <utility>

#include "base/infinite_cost.h"
#include "engine/passages/way_choice.h"

namespace muster {

// Makes the lines of all passages again.
void WayChoice::fillLines() {
    lines_.resize(std::max(lines_.size(), passages_));
    keys_.resize(std::max(keys_.size(), passages_));
    goalKeys_.resize(keys_.size());
    for (auto* keys : {&keys_, &goalKeys_})
        for (std::vector<SortKey>& k : *keys) k.clear();
    for (std::int32_t i = 0; std::cmp_less(i, people_); ++i) {
        const double arrival = cost(input_.arrival, i, way_[i]);
        const double onward = cost(input_.onward, i, goalWay_[i]);
        if (arrival < kInfiniteCost) keys_[way_[i]].push_back({arrival, i});
        if (onward < kInfiniteCost) goalKeys_[goalWay_[i]].push_back({-onward, i});
    }
    for (std::int32_t p = 0; std::cmp_less(p, passages_); ++p) {
        fill(lines_[p], keys_[p], goalKeys_[p]);
        last_[p] = lastOf(p, nullptr);
    }
    for (auto* orders : {&leavers_, &goalLeavers_})
        for (Order& order : *orders) order.known = false;
}

// Sorts both; the keys of goals are the negative walks.
void WayChoice::fill(Line& line, std::vector<SortKey>& people, std::vector<SortKey>& goals) {
    sort_.sort(people);
    sort_.sort(goals);
    line.queue.clear();
    for (const SortKey& k : people) line.queue.push_back({k.key, k.who, input_.pool[k.who]});
    line.poolEnd.assign(pools_, 0);
    for (const SortKey& k : goals) ++line.poolEnd[input_.pool[k.who]];
    std::int32_t sum = 0;
    for (std::int32_t& end : line.poolEnd) end = sum += end;
    line.goals.resize(goals.size());
    for (std::size_t k = goals.size(); k > 0; --k) {
        const std::int32_t who = goals[k - 1].who, pool = input_.pool[who];
        line.goals[--line.poolEnd[pool]] = {-goals[k - 1].key, who, pool};
    }
    for (const SortKey& k : goals) ++line.poolEnd[input_.pool[k.who]];
}

// The line of a passage without those who have another one now.
void WayChoice::dropLeft(const Line& line, std::int32_t passage, Line& out) const {
    out.queue.clear();
    out.goals.clear();
    out.poolEnd = line.poolEnd;
    for (const Turn& turn : line.queue)
        if (way_[turn.who] == passage) out.queue.push_back(turn);
    std::int32_t dropped = 0;
    std::size_t k = 0;
    for (std::size_t pool = 0; pool < out.poolEnd.size(); ++pool) {
        for (; std::cmp_less(k, line.poolEnd[pool]); ++k) {
            if (goalWay_[line.goals[k].who] == passage)
                out.goals.push_back(line.goals[k]);
            else
                ++dropped;
        }
        out.poolEnd[pool] -= dropped;
    }
}

void WayChoice::merge(const Line& one, const Line& other, Line& out) {
    const auto farther = [](const Turn& x, const Turn& y) {
        if (x.pool != y.pool) return x.pool < y.pool;
        return x.time > y.time || (x.time == y.time && x.who < y.who);
    };
    out.queue.resize(one.queue.size() + other.queue.size());
    std::merge(one.queue.begin(), one.queue.end(), other.queue.begin(), other.queue.end(), out.queue.begin(),
               isSooner);
    out.goals.resize(one.goals.size() + other.goals.size());
    std::merge(one.goals.begin(), one.goals.end(), other.goals.begin(), other.goals.end(), out.goals.begin(),
               farther);
    out.poolEnd.resize(one.poolEnd.size());
    for (std::size_t pool = 0; pool < out.poolEnd.size(); ++pool)
        out.poolEnd[pool] = one.poolEnd[pool] + other.poolEnd[pool];
}

// Serves in the order of arrival; who is served first gets the farthest of the goals. Writes when each is
// served, and returns when the last one is there [s].
double WayChoice::lastOf(std::int32_t passage, double* slot) {
    const Line& line = lines_[passage];
    Service service = beginService(passage, kInfiniteCost);
    cursor_.assign(1, 0);
    cursor_.insert(cursor_.end(), line.poolEnd.begin(), line.poolEnd.end());
    for (const Turn& turn : line.queue) {
        const double served = service.serve(turn.time);
        if (slot != nullptr) slot[turn.who] = served;
        std::int32_t& at = cursor_[turn.pool];
        if (at < line.poolEnd[turn.pool])
            service.last = std::max(service.last, served + line.goals[at++].time);
    }
    return service.last;
}

// The same without those who have another passage now. From `limit` on the result may be too early.
double WayChoice::lastWithout(std::int32_t passage, double limit) {
    const Line& line = lines_[passage];
    Service service = beginService(passage, limit);
    cursor_.assign(1, 0);
    cursor_.insert(cursor_.end(), line.poolEnd.begin(), line.poolEnd.end());
    for (const Turn& turn : line.queue) {
        if (way_[turn.who] != passage) continue;
        const double served = service.serve(turn.time);
        std::int32_t& at = cursor_[turn.pool];
        while (at < line.poolEnd[turn.pool] && goalWay_[line.goals[at].who] != passage) ++at;
        if (at < line.poolEnd[turn.pool] && service.isTooLate(served + line.goals[at++].time)) break;
    }
    return service.last;
}

// The same with those who have been moved.
double WayChoice::lastWithMoved(std::int32_t passage, double limit) {
    const Line& line = lines_[passage];
    Service service = beginService(passage, limit);
    cursor_.assign(1, 0);
    cursor_.insert(cursor_.end(), line.poolEnd.begin(), line.poolEnd.end());
    movedCursor_.assign(1, 0);
    movedCursor_.insert(movedCursor_.end(), moved_.poolEnd.begin(), moved_.poolEnd.end());
    for (std::size_t k = 0, m = 0; k < line.queue.size() || m < moved_.queue.size();) {
        const bool fromLine = m == moved_.queue.size() ||
                              (k < line.queue.size() && isSooner(line.queue[k], moved_.queue[m]));
        const Turn& turn = fromLine ? line.queue[k++] : moved_.queue[m++];
        const double served = service.serve(turn.time);
        std::int32_t& at = cursor_[turn.pool];
        std::int32_t& movedAt = movedCursor_[turn.pool];
        const bool here = at < line.poolEnd[turn.pool], there = movedAt < moved_.poolEnd[turn.pool];
        if (!here && !there) continue;
        const bool farther = here && (!there || line.goals[at].time >= moved_.goals[movedAt].time);
        const double onward = farther ? line.goals[at++].time : moved_.goals[movedAt++].time;
        if (service.isTooLate(served + onward)) break;
    }
    return service.last;
}

// Sorts those who have been moved to a passage.
void WayChoice::fillMoved(std::int32_t to) {
    std::vector<SortKey>& people = keys_.front();
    std::vector<SortKey>& goals = goalKeys_.front();
    people.clear();
    goals.clear();
    for (const std::int32_t i : movedPeople_) people.push_back({cost(input_.arrival, i, to), i});
    for (const std::int32_t g : movedGoals_) goals.push_back({-cost(input_.onward, g, to), g});
    fill(moved_, people, goals);
}

// Makes a move hold.
void WayChoice::keepMove(std::int32_t from, std::int32_t to) {
    dropLeft(lines_[from], from, other_);
    std::swap(lines_[from], other_);
    fillMoved(to);
    merge(lines_[to], moved_, other_);
    std::swap(lines_[to], other_);
    for (const std::int32_t p : {from, to}) last_[p] = lastOf(p, nullptr);
    for (std::size_t q = 0; q < passages_; ++q)
        leavers_[to * passages_ + q].known = goalLeavers_[to * passages_ + q].known = false;
}

}  // namespace muster
