#include "assignment/dense/bottleneck_assignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

double costOf(const TransportationProblem& problem, std::int32_t row, std::int32_t column) {
    return problem.cost[static_cast<std::size_t>(row) * static_cast<std::size_t>(problem.columns) +
                        static_cast<std::size_t>(column)];
}

// Infinite pairs never match, whatever the bound.
bool within(double cost, double most) {
    return cost <= most && cost < kInfinite;
}

}  // namespace

double BottleneckSolver::solve(const TransportationProblem& problem) {
    reset(problem);
    grow(problem, kInfinite);
    const double all = state_.amount;
    if (!(all > 0.0)) return 0.0;
    collectCosts(problem);
    reset(problem);
    double least = kInfinite;
    auto begin = costs_.begin();
    auto end = costs_.end();
    while (begin < end) {
        const auto middle = begin + (end - begin) / 2;
        std::nth_element(begin, middle, end);
        kept_ = state_;
        grow(problem, *middle);
        if (state_.amount >= all - dust_) {
            // This flow may use pairs that the next bound forbids.
            least = *middle;
            end = middle;
            std::swap(state_, kept_);
        } else {
            begin = middle + 1;
        }
    }
    return least;
}

void BottleneckSolver::reset(const TransportationProblem& problem) {
    if (problem.supply.empty())
        state_.supply.assign(static_cast<std::size_t>(problem.rows), 1.0);
    else
        state_.supply.assign(problem.supply.begin(), problem.supply.end());
    if (problem.demand.empty())
        state_.demand.assign(static_cast<std::size_t>(problem.columns), 1.0);
    else
        state_.demand.assign(problem.demand.begin(), problem.demand.end());
    state_.first.assign(static_cast<std::size_t>(problem.columns), -1);
    state_.shares.clear();
    state_.amount = 0.0;
    dust_ = 0.0;
    for (const double amount : state_.supply) dust_ = std::max(dust_, 1e-9 * amount);
}

void BottleneckSolver::collectCosts(const TransportationProblem& problem) {
    costs_.clear();
    for (const double cost : problem.cost)
        if (cost < kInfinite) costs_.push_back(cost);
}

// Adds to the flow until pairs within the bound carry no more.
void BottleneckSolver::grow(const TransportationProblem& problem, double most) {
    while (layer(problem, most)) {
        next_.assign(static_cast<std::size_t>(problem.rows), 0);
        for (std::int32_t i = 0; i < problem.rows; ++i)
            while (state_.supply[i] > dust_ && descend(problem, most, i)) {
            }
    }
}

// Layers of rows and columns by the length of the shortest way from a row with something left. True where a
// column with room is among them; layers end there.
bool BottleneckSolver::layer(const TransportationProblem& problem, double most) {
    rowLevel_.assign(static_cast<std::size_t>(problem.rows), -1);
    columnLevel_.assign(static_cast<std::size_t>(problem.columns), -1);
    queue_.clear();
    unseen_.clear();
    for (std::int32_t j = 0; j < problem.columns; ++j) unseen_.push_back(j);
    for (std::int32_t i = 0; i < problem.rows; ++i) {
        if (!(state_.supply[i] > dust_)) continue;
        rowLevel_[i] = 0;
        queue_.push_back(i);
    }
    std::int32_t last = std::numeric_limits<std::int32_t>::max();
    for (std::size_t k = 0; k < queue_.size(); ++k) {
        const std::int32_t i = queue_[k];
        const std::int32_t level = rowLevel_[i];
        if (level > last) break;
        std::size_t left = 0;
        for (const std::int32_t j : unseen_) {
            if (!within(costOf(problem, i, j), most)) {
                unseen_[left++] = j;
                continue;
            }
            enter(j, level);
            if (state_.demand[j] > dust_) last = level;
        }
        unseen_.resize(left);
    }
    return last != std::numeric_limits<std::int32_t>::max();
}

void BottleneckSolver::enter(std::int32_t column, std::int32_t level) {
    columnLevel_[column] = level;
    if (state_.demand[column] > dust_) return;
    for (std::int32_t s = state_.first[column]; s >= 0; s = state_.shares[s].next) {
        const Share& share = state_.shares[s];
        if (!(share.amount > dust_) || rowLevel_[share.row] >= 0) continue;
        rowLevel_[share.row] = level + 1;
        queue_.push_back(share.row);
    }
}

// A share of the column through which the path can go on to a row of that level, or -1.
std::int32_t BottleneckSolver::shareTo(std::int32_t column, std::int32_t level) const {
    for (std::int32_t s = state_.first[column]; s >= 0; s = state_.shares[s].next)
        if (state_.shares[s].amount > dust_ && rowLevel_[state_.shares[s].row] == level) return s;
    return -1;
}

// Follows the layers from a row to a column with room and sends what the path can carry. What leads nowhere
// is not tried again in this phase.
bool BottleneckSolver::descend(const TransportationProblem& problem, double most, std::int32_t root) {
    path_.clear();
    std::int32_t row = root;
    for (;;) {
        std::int32_t& j = next_[row];
        while (j < problem.columns &&
               (columnLevel_[j] != rowLevel_[row] || !within(costOf(problem, row, j), most)))
            ++j;
        if (j == problem.columns) {
            if (path_.empty()) return false;
            rowLevel_[row] = -1;
            row = path_.back().row;
            path_.pop_back();
            continue;
        }
        if (state_.demand[j] > dust_) {
            path_.push_back({row, j, -1});
            push(root, j);
            return true;
        }
        const std::int32_t share = shareTo(j, rowLevel_[row] + 1);
        if (share < 0) {
            ++j;
            continue;
        }
        path_.push_back({row, j, share});
        row = state_.shares[share].row;
    }
}

void BottleneckSolver::push(std::int32_t root, std::int32_t column) {
    double amount = std::min(state_.supply[root], state_.demand[column]);
    for (const Turn& turn : path_)
        if (turn.share >= 0) amount = std::min(amount, state_.shares[turn.share].amount);
    for (const Turn& turn : path_) {
        if (turn.share >= 0) state_.shares[turn.share].amount -= amount;
        add(turn.row, turn.column, amount);
    }
    state_.supply[root] -= amount;
    state_.demand[column] -= amount;
    state_.amount += amount;
}

void BottleneckSolver::add(std::int32_t row, std::int32_t column, double amount) {
    std::int32_t spare = -1;
    for (std::int32_t s = state_.first[column]; s >= 0; s = state_.shares[s].next) {
        if (state_.shares[s].row == row) {
            state_.shares[s].amount += amount;
            return;
        }
        if (state_.shares[s].amount == 0.0) spare = s;
    }
    if (spare >= 0) {
        state_.shares[spare].row = row;
        state_.shares[spare].amount = amount;
        return;
    }
    state_.shares.push_back({row, amount, state_.first[column]});
    state_.first[column] = static_cast<std::int32_t>(state_.shares.size()) - 1;
}

}  // namespace muster
