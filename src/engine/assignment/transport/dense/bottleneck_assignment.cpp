#include "engine/assignment/transport/dense/bottleneck_assignment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/infinite_cost.h"

namespace muster {
namespace {

double costOf(const TransportationProblem& problem, std::int32_t row, std::int32_t column) {
    return problem.cost[static_cast<std::size_t>(row) * problem.columns + column];
}

// Impossible pairs are excluded whatever the threshold.
bool within(double cost, double threshold) {
    return cost <= threshold && cost < kInfiniteCost;
}

}  // namespace

double BottleneckSolver::solve(const TransportationProblem& problem) {
    reset(problem);
    maximizeFlow(problem, kInfiniteCost);
    const double all = flow_.amount;
    if (!(all > 0.0)) return 0.0;
    collectCosts(problem);
    reset(problem);
    double least = kInfiniteCost;
    auto begin = costs_.begin();
    auto end = costs_.end();
    while (begin < end) {
        const auto middle = begin + (end - begin) / 2;
        std::nth_element(begin, middle, end);
        startFlow_ = flow_;
        maximizeFlow(problem, *middle);
        if (flow_.amount >= all - negligible_) {
            // This flow may use pairs that the next threshold excludes.
            least = *middle;
            end = middle;
            std::swap(flow_, startFlow_);
        } else {
            begin = middle + 1;
        }
    }
    return least;
}

void BottleneckSolver::reset(const TransportationProblem& problem) {
    if (problem.supply.empty())
        flow_.remainingSupply.assign(problem.rows, 1.0);
    else
        flow_.remainingSupply.assign(problem.supply.begin(), problem.supply.end());
    if (problem.demand.empty())
        flow_.remainingDemand.assign(problem.columns, 1.0);
    else
        flow_.remainingDemand.assign(problem.demand.begin(), problem.demand.end());
    flow_.first.assign(problem.columns, -1);
    flow_.entries.clear();
    flow_.amount = 0.0;
    negligible_ = 0.0;
    for (const double amount : flow_.remainingSupply) negligible_ = std::max(negligible_, 1e-9 * amount);
}

void BottleneckSolver::collectCosts(const TransportationProblem& problem) {
    costs_.clear();
    for (const double cost : problem.cost)
        if (cost < kInfiniteCost) costs_.push_back(cost);
}

// Augments until the pairs within the threshold can send no more.
void BottleneckSolver::maximizeFlow(const TransportationProblem& problem, double threshold) {
    while (buildLevels(problem, threshold)) {
        nextColumn_.assign(problem.rows, 0);
        for (std::int32_t i = 0; i < problem.rows; ++i)
            while (flow_.remainingSupply[i] > negligible_ && augmentFrom(problem, threshold, i)) {
            }
    }
}

// Builds the level graph: the level of a row or column is the length of the shortest path to it from a row
// with supply left. True where it reaches a column with demand left; levels end there.
bool BottleneckSolver::buildLevels(const TransportationProblem& problem, double threshold) {
    rowLevel_.assign(problem.rows, -1);
    columnLevel_.assign(problem.columns, -1);
    queue_.clear();
    unreachedColumns_.clear();
    for (std::int32_t j = 0; j < problem.columns; ++j) unreachedColumns_.push_back(j);
    for (std::int32_t i = 0; i < problem.rows; ++i) {
        if (!(flow_.remainingSupply[i] > negligible_)) continue;
        rowLevel_[i] = 0;
        queue_.push_back(i);
    }
    std::int32_t last = std::numeric_limits<std::int32_t>::max();
    for (std::size_t k = 0; k < queue_.size(); ++k) {
        const std::int32_t i = queue_[k];
        const std::int32_t level = rowLevel_[i];
        if (level > last) break;
        std::size_t open = 0;
        for (const std::int32_t j : unreachedColumns_) {
            if (!within(costOf(problem, i, j), threshold)) {
                unreachedColumns_[open++] = j;
                continue;
            }
            reachRowsOf(j, level);
            if (flow_.remainingDemand[j] > negligible_) last = level;
        }
        unreachedColumns_.resize(open);
    }
    return last != std::numeric_limits<std::int32_t>::max();
}

void BottleneckSolver::reachRowsOf(std::int32_t column, std::int32_t level) {
    columnLevel_[column] = level;
    if (flow_.remainingDemand[column] > negligible_) return;
    for (std::int32_t e = flow_.first[column]; e >= 0; e = flow_.entries[e].next) {
        const ColumnEntry& entry = flow_.entries[e];
        if (!(entry.amount > negligible_) || rowLevel_[entry.row] >= 0) continue;
        rowLevel_[entry.row] = level + 1;
        queue_.push_back(entry.row);
    }
}

// The entry of a row of `level` that sends to the column, or -1.
std::int32_t BottleneckSolver::entryAtLevel(std::int32_t column, std::int32_t level) const {
    for (std::int32_t e = flow_.first[column]; e >= 0; e = flow_.entries[e].next)
        if (flow_.entries[e].amount > negligible_ && rowLevel_[flow_.entries[e].row] == level) return e;
    return -1;
}

// Follows the levels from a row to a column with demand left, depth first, and sends as much as the path can
// carry. A row or column without a path is not tried again in this phase.
bool BottleneckSolver::augmentFrom(const TransportationProblem& problem, double threshold,
                                   std::int32_t source) {
    path_.clear();
    std::int32_t row = source;
    for (;;) {
        std::int32_t& j = nextColumn_[row];
        while (j < problem.columns &&
               (columnLevel_[j] != rowLevel_[row] || !within(costOf(problem, row, j), threshold)))
            ++j;
        if (j == problem.columns) {
            if (path_.empty()) return false;
            rowLevel_[row] = -1;
            row = path_.back().row;
            path_.pop_back();
            continue;
        }
        if (flow_.remainingDemand[j] > negligible_) {
            path_.push_back({row, j, -1});
            sendAlongPath(source, j);
            return true;
        }
        const std::int32_t entry = entryAtLevel(j, rowLevel_[row] + 1);
        if (entry < 0) {
            ++j;
            continue;
        }
        path_.push_back({row, j, entry});
        row = flow_.entries[entry].row;
    }
}

void BottleneckSolver::sendAlongPath(std::int32_t source, std::int32_t column) {
    double amount = std::min(flow_.remainingSupply[source], flow_.remainingDemand[column]);
    for (const PathArc& arc : path_)
        if (arc.entry >= 0) amount = std::min(amount, flow_.entries[arc.entry].amount);
    for (const PathArc& arc : path_) {
        if (arc.entry >= 0) flow_.entries[arc.entry].amount -= amount;
        add(arc.row, arc.column, amount);
    }
    flow_.remainingSupply[source] -= amount;
    flow_.remainingDemand[column] -= amount;
    flow_.amount += amount;
}

void BottleneckSolver::add(std::int32_t row, std::int32_t column, double amount) {
    std::int32_t unused = -1;
    for (std::int32_t e = flow_.first[column]; e >= 0; e = flow_.entries[e].next) {
        if (flow_.entries[e].row == row) {
            flow_.entries[e].amount += amount;
            return;
        }
        if (flow_.entries[e].amount == 0.0) unused = e;
    }
    if (unused >= 0) {
        flow_.entries[unused].row = row;
        flow_.entries[unused].amount = amount;
        return;
    }
    flow_.entries.push_back({row, amount, flow_.first[column]});
    flow_.first[column] = static_cast<std::int32_t>(flow_.entries.size()) - 1;
}

}  // namespace muster
