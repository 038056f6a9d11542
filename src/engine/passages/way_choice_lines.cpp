// The agents that go through each passage, and the time when the last of them is in place.
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
        last_[p] = lastOf(p, nobody_, kInfiniteCost, nullptr);
    }
    for (auto* orders : {&leavers_, &goalLeavers_})
        for (Order& order : *orders) order.known = false;
}

// Sorts people and goals; the keys of goals are the negative walks.
void WayChoice::fill(Line& line, std::vector<SortKey>& people, std::vector<SortKey>& goals) {
    sort_.sort(people);
    sort_.sort(goals);
    line.queue.clear();
    for (const SortKey& k : people) line.queue.push_back({k.key, k.index, input_.pool[k.index]});
    line.poolEnd.assign(pools_, 0);
    for (const SortKey& k : goals) ++line.poolEnd[input_.pool[k.index]];
    std::int32_t sum = 0;
    for (std::int32_t& end : line.poolEnd) end = sum += end;
    line.goals.resize(goals.size());
    for (std::size_t k = goals.size(); k > 0; --k) {
        const std::int32_t index = goals[k - 1].index, pool = input_.pool[index];
        line.goals[--line.poolEnd[pool]] = {-goals[k - 1].key, index, pool};
    }
    for (const SortKey& k : goals) ++line.poolEnd[input_.pool[k.index]];
}

// The line of a passage without agents that have another one now.
void WayChoice::dropLeft(const Line& line, std::int32_t passage, Line& out) const {
    out.queue.clear();
    out.goals.clear();
    out.poolEnd = line.poolEnd;
    for (const Turn& turn : line.queue)
        if (way_[turn.index] == passage) out.queue.push_back(turn);
    std::int32_t dropped = 0;
    std::size_t k = 0;
    for (std::size_t pool = 0; pool < out.poolEnd.size(); ++pool) {
        for (; std::cmp_less(k, line.poolEnd[pool]); ++k) {
            if (goalWay_[line.goals[k].index] == passage)
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
        return x.time > y.time || (x.time == y.time && x.index < y.index);
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

// Serves the agents of a passage, and those of `joining`, in the order of arrival; the first one served gets
// the farthest goal. Writes when each is served, and returns when the last one is at its goal [s]; from
// `limit` on the result may be too early.
double WayChoice::lastOf(std::int32_t passage, const Line& joining, double limit, double* slot) {
    const Line& line = lines_[passage];
    const auto begin = [](const Line& of, std::vector<std::int32_t>& cursor) {
        cursor.assign(1, 0);
        cursor.insert(cursor.end(), of.poolEnd.begin(), of.poolEnd.end());
    };
    begin(line, cursor_);
    begin(joining, joiningCursor_);
    double free = 0.0, last = 0.0;
    for (std::size_t k = 0, m = 0; k < line.queue.size() || m < joining.queue.size();) {
        const bool fromLine = m == joining.queue.size() ||
                              (k < line.queue.size() && isSooner(line.queue[k], joining.queue[m]));
        const Turn& turn = fromLine ? line.queue[k++] : joining.queue[m++];
        if (way_[turn.index] != passage) continue;  // This agent has left the passage.
        const double served = std::max(turn.time, free);
        free = served + 1.0 / input_.capacity[passage];
        if (slot != nullptr) slot[turn.index] = served;
        std::int32_t& at = cursor_[turn.pool];
        std::int32_t& joiningAt = joiningCursor_[turn.pool];
        while (at < line.poolEnd[turn.pool] && goalWay_[line.goals[at].index] != passage) ++at;
        const bool here = at < line.poolEnd[turn.pool], there = joiningAt < joining.poolEnd[turn.pool];
        if (!here && !there) continue;
        const bool farther = here && (!there || line.goals[at].time >= joining.goals[joiningAt].time);
        last = std::max(last, served + (farther ? line.goals[at++] : joining.goals[joiningAt++]).time);
        if (last >= limit) break;
    }
    return last;
}

// Sorts agents that have been moved to a passage.
void WayChoice::fillMoved(std::int32_t to) {
    std::vector<SortKey>& people = keys_.front();
    std::vector<SortKey>& goals = goalKeys_.front();
    people.clear();
    goals.clear();
    for (const std::int32_t i : movedPeople_) people.push_back({cost(input_.arrival, i, to), i});
    for (const std::int32_t g : movedGoals_) goals.push_back({-cost(input_.onward, g, to), g});
    fill(moved_, people, goals);
}

// Makes a move permanent.
void WayChoice::keepMove(std::int32_t from, std::int32_t to) {
    dropLeft(lines_[from], from, other_);
    std::swap(lines_[from], other_);
    fillMoved(to);
    merge(lines_[to], moved_, other_);
    std::swap(lines_[to], other_);
    for (const std::int32_t p : {from, to}) last_[p] = lastOf(p, nobody_, kInfiniteCost, nullptr);
    for (std::size_t q = 0; q < passages_; ++q)
        leavers_[to * passages_ + q].known = goalLeavers_[to * passages_ + q].known = false;
}

}  // namespace muster
