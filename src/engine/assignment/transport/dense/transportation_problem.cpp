#include "engine/assignment/transport/dense/transportation_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "base/infinite_cost.h"
#include "engine/assignment/transport/dense/dulmage_mendelsohn.h"
#include "engine/assignment/transport/dense/jonker_volgenant.h"
#include "engine/assignment/transport/dense/successive_shortest_paths.h"

namespace muster {
namespace {

// Amounts below this share of the largest are due to rounding.
constexpr double kNegligibleShare = 1e-12;

Status checkAmounts(const char* what, std::span<const double> amounts, std::int32_t count) {
    if (amounts.empty()) return {};
    if (std::cmp_not_equal(amounts.size(), count))
        return invalidArgument(std::string(what) + " has " + std::to_string(amounts.size()) +
                               " values, expected " + std::to_string(count));
    for (std::size_t k = 0; k < amounts.size(); ++k)
        if (!(amounts[k] >= 0.0) || amounts[k] == kInfiniteCost)
            return invalidArgument(std::string(what) + " " + std::to_string(k) +
                                   " is not a finite number >= 0");
    return {};
}

Status check(const TransportationProblem& problem) {
    if (problem.rows < 0 || problem.columns < 0) return invalidArgument("rows or columns are negative");
    const auto count = static_cast<std::size_t>(problem.rows) * problem.columns;
    if (problem.cost.size() != count)
        return invalidArgument("cost has " + std::to_string(problem.cost.size()) + " values, expected " +
                               std::to_string(count));
    for (std::size_t k = 0; k < count; ++k)
        if (!(problem.cost[k] >= 0.0))
            return invalidArgument("cost of row " + std::to_string(k / problem.columns) + ", column " +
                                   std::to_string(k % problem.columns) + " is negative or not a number");
    if (Status status = checkAmounts("supply", problem.supply, problem.rows); !status.ok()) return status;
    return checkAmounts("demand", problem.demand, problem.columns);
}

}  // namespace

struct TransportationSolver::Impl {
    const TransportationProblem* problem = nullptr;
    TransportationSolution* solution = nullptr;
    // Active rows and columns: those with an amount > 0. "Position" means the index among these.
    std::vector<std::int32_t> rows;
    std::vector<std::int32_t> columns;
    std::vector<double> supply;  // Supply per active row.
    std::vector<double> demand;  // Demand per active column.
    std::vector<double> cost;    // Costs of active rows x active columns, row-major.
    double negligible = 0.0;     // Amounts up to this count as nothing.
    double unit = 0.0;           // Amount of all rows and columns; 0 where amounts differ.

    DulmageMendelsohn decomposition;
    std::vector<DulmageMendelsohnPart> rowPart;     // Part of each active row.
    std::vector<DulmageMendelsohnPart> columnPart;  // Part of each active column.
    std::vector<std::int32_t> partRows;             // Positions of the rows of this part.
    std::vector<std::int32_t> partColumns;          // Positions of its columns.
    // Costs, transposed for the vertical part, whose columns are the scarcer side.
    std::vector<double> partCost;
    std::vector<double> partSupply;
    std::vector<double> partDemand;
    JonkerVolgenantSolver assignmentSolver;
    SuccessiveShortestPaths flowSolver;

    void collectActive();
    void decompose();
    void collectPart(DulmageMendelsohnPart part);
    void solvePart(DulmageMendelsohnPart part);
    template <class Solver>
    void takeDuals(const Solver& solver, bool transposed);
    void takeAssignment(bool transposed);
    void takeFlows(bool transposed);
    void addFlow(std::int32_t row, std::int32_t column, double amount);
    void shiftDuals(DulmageMendelsohnPart part);
    void setInactiveDuals();
    void sumUp();
};

// Collects the rows and columns that have an amount, and whether all amounts are equal.
void TransportationSolver::Impl::collectActive() {
    const auto collect = [](std::span<const double> amounts, std::int32_t count,
                            std::vector<std::int32_t>& active, std::vector<double>& values) {
        active.clear();
        values.clear();
        for (std::int32_t k = 0; k < count; ++k) {
            const double amount = amounts.empty() ? 1.0 : amounts[k];
            if (amount <= 0.0) continue;
            active.push_back(k);
            values.push_back(amount);
        }
    };
    collect(problem->supply, problem->rows, rows, supply);
    collect(problem->demand, problem->columns, columns, demand);
    cost.clear();
    for (const std::int32_t i : rows) {
        const double* from = problem->cost.data() + static_cast<std::size_t>(i) * problem->columns;
        if (std::cmp_equal(columns.size(), problem->columns)) {
            cost.insert(cost.end(), from, from + problem->columns);
        } else {
            for (const std::int32_t j : columns) cost.push_back(from[j]);
        }
    }
    double largest = 0.0;
    double smallest = kInfiniteCost;
    for (const auto* amounts : {&supply, &demand})
        for (const double amount : *amounts) {
            largest = std::max(largest, amount);
            smallest = std::min(smallest, amount);
        }
    unit = largest == smallest ? largest : 0.0;
    negligible = largest * kNegligibleShare;
}

// Without impossible pairs there is one part.
void TransportationSolver::Impl::decompose() {
    const bool allPossible = std::all_of(cost.begin(), cost.end(),
                                         [](double c) { return c < kInfiniteCost; });
    if (!allPossible) {
        decomposition.decompose(static_cast<std::int32_t>(rows.size()),
                                static_cast<std::int32_t>(columns.size()), cost.data(), supply, demand,
                                negligible);
        rowPart.assign(decomposition.rowPart().begin(), decomposition.rowPart().end());
        columnPart.assign(decomposition.columnPart().begin(), decomposition.columnPart().end());
        return;
    }
    double supplied = 0.0;
    double demanded = 0.0;
    for (const double amount : supply) supplied += amount;
    for (const double amount : demand) demanded += amount;
    const DulmageMendelsohnPart only = supplied > demanded ? DulmageMendelsohnPart::Vertical
                                                           : DulmageMendelsohnPart::Horizontal;
    rowPart.assign(rows.size(), only);
    columnPart.assign(columns.size(), only);
}

void TransportationSolver::Impl::collectPart(DulmageMendelsohnPart part) {
    const bool transposed = part == DulmageMendelsohnPart::Vertical;
    partRows.clear();
    partColumns.clear();
    for (std::int32_t i = 0; i < std::ssize(rows); ++i)
        if (rowPart[i] == part) partRows.push_back(i);
    for (std::int32_t j = 0; j < std::ssize(columns); ++j)
        if (columnPart[j] == part) partColumns.push_back(j);
    partCost.resize(partRows.size() * partColumns.size());
    for (std::size_t a = 0; a < partRows.size(); ++a) {
        const double* from = cost.data() + partRows[a] * columns.size();
        for (std::size_t b = 0; b < partColumns.size(); ++b) {
            const std::size_t to = transposed ? b * partRows.size() + a : a * partColumns.size() + b;
            partCost[to] = from[partColumns[b]];
        }
    }
}

// Solves one part, with its scarcer side as rows.
void TransportationSolver::Impl::solvePart(DulmageMendelsohnPart part) {
    collectPart(part);
    if (partRows.empty() || partColumns.empty()) return;
    const bool transposed = part == DulmageMendelsohnPart::Vertical;
    const auto scarcer = static_cast<std::int32_t>(transposed ? partColumns.size() : partRows.size());
    const auto other = static_cast<std::int32_t>(transposed ? partRows.size() : partColumns.size());
    if (unit > 0.0) {
        assignmentSolver.solve(scarcer, other, partCost.data());
        takeDuals(assignmentSolver, transposed);
        takeAssignment(transposed);
        return;
    }
    partSupply.clear();
    partDemand.clear();
    for (const std::int32_t i : partRows) partSupply.push_back(supply[i]);
    for (const std::int32_t j : partColumns) partDemand.push_back(demand[j]);
    if (transposed) partSupply.swap(partDemand);
    flowSolver.solve(scarcer, other, partCost.data(), partSupply, partDemand, negligible);
    takeDuals(flowSolver, transposed);
    takeFlows(transposed);
}

template <class Solver>
void TransportationSolver::Impl::takeDuals(const Solver& solver, bool transposed) {
    const auto& rowDual = transposed ? solver.columnDual() : solver.rowDual();
    const auto& columnDual = transposed ? solver.rowDual() : solver.columnDual();
    for (std::size_t a = 0; a < partRows.size(); ++a) solution->rowDual[rows[partRows[a]]] = rowDual[a];
    for (std::size_t b = 0; b < partColumns.size(); ++b)
        solution->columnDual[columns[partColumns[b]]] = columnDual[b];
    solution->augmentations += solver.augmentations();
}

void TransportationSolver::Impl::addFlow(std::int32_t row, std::int32_t column, double amount) {
    solution->flows.push_back({rows[partRows[row]], columns[partColumns[column]], amount});
}

void TransportationSolver::Impl::takeAssignment(bool transposed) {
    const auto& columnOf = assignmentSolver.columnOf();
    for (std::int32_t k = 0; k < std::ssize(columnOf); ++k) {
        if (columnOf[k] < 0) continue;
        addFlow(transposed ? columnOf[k] : k, transposed ? k : columnOf[k], unit);
    }
}

void TransportationSolver::Impl::takeFlows(bool transposed) {
    for (std::int32_t a = 0; a < std::ssize(partRows); ++a)
        for (std::int32_t b = 0; b < std::ssize(partColumns); ++b) {
            const double amount = transposed ? flowSolver.flow(b, a) : flowSolver.flow(a, b);
            if (amount > negligible) addFlow(a, b, amount);
        }
}

// The duals of two parts may break the bound u_i + v_j <= c_ij for pairs between the parts. No possible pair
// joins a row of the vertical part with a column of another, so its u may rise and its v fall by the same
// amount; for the horizontal part the reverse holds.
void TransportationSolver::Impl::shiftDuals(DulmageMendelsohnPart part) {
    const bool vertical = part == DulmageMendelsohnPart::Vertical;
    double shift = 0.0;
    for (std::size_t a = 0; a < rows.size(); ++a) {
        if ((rowPart[a] == part) == vertical) continue;
        const double u = solution->rowDual[rows[a]];
        for (std::size_t b = 0; b < columns.size(); ++b) {
            if ((columnPart[b] == part) != vertical) continue;
            const double c = cost[a * columns.size() + b];
            if (c < kInfiniteCost) shift = std::max(shift, u + solution->columnDual[columns[b]] - c);
        }
    }
    if (shift <= 0.0) return;
    if (!vertical) shift = -shift;
    for (std::size_t a = 0; a < rows.size(); ++a)
        if (rowPart[a] == part) solution->rowDual[rows[a]] += shift;
    for (std::size_t b = 0; b < columns.size(); ++b)
        if (columnPart[b] == part) solution->columnDual[columns[b]] -= shift;
}

// Gives rows and columns without an amount the highest dual that keeps the bound.
void TransportationSolver::Impl::setInactiveDuals() {
    const auto costOf = [&](std::int32_t i, std::int32_t j) {
        return problem->cost[static_cast<std::size_t>(i) * problem->columns + j];
    };
    const auto isInactive = [](std::span<const double> amounts, std::int32_t k) {
        return !amounts.empty() && amounts[k] <= 0.0;
    };
    for (std::int32_t j = 0; j < problem->columns; ++j) {
        if (!isInactive(problem->demand, j)) continue;
        double lowest = kInfiniteCost;
        for (const std::int32_t i : rows) lowest = std::min(lowest, costOf(i, j) - solution->rowDual[i]);
        solution->columnDual[j] = lowest < kInfiniteCost ? lowest : 0.0;
    }
    for (std::int32_t i = 0; i < problem->rows; ++i) {
        if (!isInactive(problem->supply, i)) continue;
        double lowest = kInfiniteCost;
        for (std::int32_t j = 0; j < problem->columns; ++j)
            lowest = std::min(lowest, costOf(i, j) - solution->columnDual[j]);
        solution->rowDual[i] = lowest < kInfiniteCost ? lowest : 0.0;
    }
}

void TransportationSolver::Impl::sumUp() {
    std::sort(solution->flows.begin(), solution->flows.end(), [](const Flow& a, const Flow& b) {
        return a.character != b.character ? a.character < b.character : a.place < b.place;
    });
    for (const Flow& flow : solution->flows) {
        const std::size_t k = static_cast<std::size_t>(flow.character) * problem->columns + flow.place;
        solution->amount += flow.amount;
        solution->cost += problem->cost[k] * flow.amount;
    }
}

TransportationSolver::TransportationSolver() : impl_(std::make_unique<Impl>()) {}
TransportationSolver::~TransportationSolver() = default;
TransportationSolver::TransportationSolver(TransportationSolver&&) noexcept = default;
TransportationSolver& TransportationSolver::operator=(TransportationSolver&&) noexcept = default;

Status TransportationSolver::solve(const TransportationProblem& problem, TransportationSolution& solution) {
    if (Status status = check(problem); !status.ok()) return status;
    Impl& m = *impl_;
    m.problem = &problem;
    m.solution = &solution;
    solution.flows.clear();
    solution.amount = 0.0;
    solution.cost = 0.0;
    solution.augmentations = 0;
    solution.rowDual.assign(problem.rows, 0.0);
    solution.columnDual.assign(problem.columns, 0.0);
    m.collectActive();
    m.decompose();
    for (const DulmageMendelsohnPart part :
         {DulmageMendelsohnPart::Vertical, DulmageMendelsohnPart::Square, DulmageMendelsohnPart::Horizontal})
        m.solvePart(part);
    m.shiftDuals(DulmageMendelsohnPart::Vertical);
    m.shiftDuals(DulmageMendelsohnPart::Horizontal);
    m.setInactiveDuals();
    m.sumUp();
    m.problem = nullptr;
    m.solution = nullptr;
    return {};
}

}  // namespace muster
