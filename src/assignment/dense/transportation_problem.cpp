#include "assignment/dense/transportation_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "assignment/dense/dulmage_mendelsohn.h"
#include "assignment/dense/jonker_volgenant.h"
#include "assignment/dense/successive_shortest_paths.h"

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Amounts below this share of the largest are rounding.
constexpr double kDustShare = 1e-12;

Status checkAmounts(const char* what, std::span<const double> amounts, std::int32_t count) {
    if (amounts.empty()) return {};
    if (amounts.size() != static_cast<std::size_t>(count))
        return invalidArgument(std::string(what) + " has " + std::to_string(amounts.size()) +
                               " values, expected " + std::to_string(count));
    for (std::size_t k = 0; k < amounts.size(); ++k)
        if (!(amounts[k] >= 0.0) || amounts[k] == kInfinite)
            return invalidArgument(std::string(what) + " " + std::to_string(k) +
                                   " is not a finite number >= 0");
    return {};
}

Status check(const TransportationProblem& problem) {
    if (problem.rows < 0 || problem.columns < 0) return invalidArgument("rows or columns are negative");
    const auto count = static_cast<std::size_t>(problem.rows) * static_cast<std::size_t>(problem.columns);
    if (problem.cost.size() != count)
        return invalidArgument("cost has " + std::to_string(problem.cost.size()) + " values, expected " +
                               std::to_string(count));
    for (std::size_t k = 0; k < count; ++k)
        if (!(problem.cost[k] >= 0.0))
            return invalidArgument(
                "cost of row " + std::to_string(k / static_cast<std::size_t>(problem.columns)) + ", column " +
                std::to_string(k % static_cast<std::size_t>(problem.columns)) +
                " is negative or not a number");
    if (Status status = checkAmounts("supply", problem.supply, problem.rows); !status.ok()) return status;
    return checkAmounts("demand", problem.demand, problem.columns);
}

}  // namespace

struct TransportationSolver::Impl {
    const TransportationProblem* problem = nullptr;
    TransportationSolution* solution = nullptr;
    std::vector<std::int32_t> rows;     // With something to send.
    std::vector<std::int32_t> columns;  // With something to fill.
    std::vector<double> supply;         // Of these.
    std::vector<double> demand;
    std::vector<double> cost;  // Between these.
    double dust = 0.0;
    double unit = 0.0;  // The one amount that all have; 0 where amounts differ.

    DulmageMendelsohn parts;
    std::vector<DulmageMendelsohnPart> rowPart;
    std::vector<DulmageMendelsohnPart> columnPart;
    std::vector<std::int32_t> partRows;  // Positions in `rows` of the part under way.
    std::vector<std::int32_t> partColumns;
    std::vector<double> partCost;  // Transposed where rows are left over.
    std::vector<double> partSupply;
    std::vector<double> partDemand;
    JonkerVolgenantSolver unitMatching;
    SuccessiveShortestPaths flowMatching;

    void gather();
    void split();
    void collectPart(DulmageMendelsohnPart part);
    void solvePart(DulmageMendelsohnPart part);
    template <class Matching>
    void takePrices(const Matching& matching, bool transposed);
    void takeUnits(bool transposed);
    void takeFlows(bool transposed);
    void addFlow(std::int32_t row, std::int32_t column, double amount);
    void levelPrices(DulmageMendelsohnPart part);
    void priceIdle();
    void total();
};

// Keeps the rows and columns that have an amount, and finds out whether all amounts are alike.
void TransportationSolver::Impl::gather() {
    const auto keep = [](std::span<const double> amounts, std::int32_t count, std::vector<std::int32_t>& kept,
                         std::vector<double>& values) {
        kept.clear();
        values.clear();
        for (std::int32_t k = 0; k < count; ++k) {
            const double amount = amounts.empty() ? 1.0 : amounts[k];
            if (amount <= 0.0) continue;
            kept.push_back(k);
            values.push_back(amount);
        }
    };
    keep(problem->supply, problem->rows, rows, supply);
    keep(problem->demand, problem->columns, columns, demand);
    cost.clear();
    for (const std::int32_t i : rows) {
        const double* from = problem->cost.data() +
                             static_cast<std::size_t>(i) * static_cast<std::size_t>(problem->columns);
        if (columns.size() == static_cast<std::size_t>(problem->columns)) {
            cost.insert(cost.end(), from, from + problem->columns);
        } else {
            for (const std::int32_t j : columns) cost.push_back(from[j]);
        }
    }
    double largest = 0.0;
    double smallest = kInfinite;
    for (const auto* amounts : {&supply, &demand})
        for (const double amount : *amounts) {
            largest = std::max(largest, amount);
            smallest = std::min(smallest, amount);
        }
    unit = largest == smallest ? largest : 0.0;
    dust = largest * kDustShare;
}

// Without impossible pairs there is one part: the scarcer side is used up.
void TransportationSolver::Impl::split() {
    const bool allPossible = std::all_of(cost.begin(), cost.end(), [](double c) { return c < kInfinite; });
    if (!allPossible) {
        parts.find(static_cast<std::int32_t>(rows.size()), static_cast<std::int32_t>(columns.size()),
                   cost.data(), supply, demand, dust);
        rowPart.assign(parts.rowPart().begin(), parts.rowPart().end());
        columnPart.assign(parts.columnPart().begin(), parts.columnPart().end());
        return;
    }
    double supplied = 0.0;
    double demanded = 0.0;
    for (const double amount : supply) supplied += amount;
    for (const double amount : demand) demanded += amount;
    const DulmageMendelsohnPart only = supplied > demanded ? DulmageMendelsohnPart::RowsLeft
                                                           : DulmageMendelsohnPart::ColumnsLeft;
    rowPart.assign(rows.size(), only);
    columnPart.assign(columns.size(), only);
}

void TransportationSolver::Impl::collectPart(DulmageMendelsohnPart part) {
    const bool transposed = part == DulmageMendelsohnPart::RowsLeft;
    partRows.clear();
    partColumns.clear();
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(rows.size()); ++i)
        if (rowPart[i] == part) partRows.push_back(i);
    for (std::int32_t j = 0; j < static_cast<std::int32_t>(columns.size()); ++j)
        if (columnPart[j] == part) partColumns.push_back(j);
    partCost.resize(partRows.size() * partColumns.size());
    for (std::size_t a = 0; a < partRows.size(); ++a) {
        const double* from = cost.data() + static_cast<std::size_t>(partRows[a]) * columns.size();
        for (std::size_t b = 0; b < partColumns.size(); ++b) {
            const std::size_t to = transposed ? b * partRows.size() + a : a * partColumns.size() + b;
            partCost[to] = from[partColumns[b]];
        }
    }
}

// Solves one part from its side that is used up.
void TransportationSolver::Impl::solvePart(DulmageMendelsohnPart part) {
    collectPart(part);
    if (partRows.empty() || partColumns.empty()) return;
    const bool transposed = part == DulmageMendelsohnPart::RowsLeft;
    const auto near = static_cast<std::int32_t>(transposed ? partColumns.size() : partRows.size());
    const auto far = static_cast<std::int32_t>(transposed ? partRows.size() : partColumns.size());
    if (unit > 0.0) {
        unitMatching.solve(near, far, partCost.data());
        takePrices(unitMatching, transposed);
        takeUnits(transposed);
        return;
    }
    partSupply.clear();
    partDemand.clear();
    for (const std::int32_t i : partRows) partSupply.push_back(supply[i]);
    for (const std::int32_t j : partColumns) partDemand.push_back(demand[j]);
    if (transposed) partSupply.swap(partDemand);
    flowMatching.solve(near, far, partCost.data(), partSupply, partDemand, dust);
    takePrices(flowMatching, transposed);
    takeFlows(transposed);
}

template <class Matching>
void TransportationSolver::Impl::takePrices(const Matching& matching, bool transposed) {
    const auto& rowDual = transposed ? matching.columnDual() : matching.rowDual();
    const auto& columnDual = transposed ? matching.rowDual() : matching.columnDual();
    for (std::size_t a = 0; a < partRows.size(); ++a) solution->rowDual[rows[partRows[a]]] = rowDual[a];
    for (std::size_t b = 0; b < partColumns.size(); ++b)
        solution->columnDual[columns[partColumns[b]]] = columnDual[b];
    solution->augmentations += matching.augmentations();
}

void TransportationSolver::Impl::addFlow(std::int32_t row, std::int32_t column, double amount) {
    solution->flows.push_back({rows[partRows[row]], columns[partColumns[column]], amount});
}

void TransportationSolver::Impl::takeUnits(bool transposed) {
    const auto& match = unitMatching.columnOf();
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(match.size()); ++k) {
        if (match[k] < 0) continue;
        addFlow(transposed ? match[k] : k, transposed ? k : match[k], unit);
    }
}

void TransportationSolver::Impl::takeFlows(bool transposed) {
    for (std::int32_t a = 0; a < static_cast<std::int32_t>(partRows.size()); ++a)
        for (std::int32_t b = 0; b < static_cast<std::int32_t>(partColumns.size()); ++b) {
            const double amount = transposed ? flowMatching.flow(b, a) : flowMatching.flow(a, b);
            if (amount > dust) addFlow(a, b, amount);
        }
}

// Between parts prices may be too high for pairs that no largest transport uses. A part whose rows are left
// over has no way out of its columns, so these may become cheaper and its rows dearer by any amount; the part
// whose columns are left over may do the reverse.
void TransportationSolver::Impl::levelPrices(DulmageMendelsohnPart part) {
    const bool left = part == DulmageMendelsohnPart::RowsLeft;
    double excess = 0.0;
    for (std::size_t a = 0; a < rows.size(); ++a) {
        if ((rowPart[a] == part) == left) continue;
        const double u = solution->rowDual[rows[a]];
        for (std::size_t b = 0; b < columns.size(); ++b) {
            if ((columnPart[b] == part) != left) continue;
            const double c = cost[a * columns.size() + b];
            if (c < kInfinite) excess = std::max(excess, u + solution->columnDual[columns[b]] - c);
        }
    }
    if (excess <= 0.0) return;
    if (!left) excess = -excess;
    for (std::size_t a = 0; a < rows.size(); ++a)
        if (rowPart[a] == part) solution->rowDual[rows[a]] += excess;
    for (std::size_t b = 0; b < columns.size(); ++b)
        if (columnPart[b] == part) solution->columnDual[columns[b]] -= excess;
}

// Rows and columns without an amount take the highest price that breaks no arc.
void TransportationSolver::Impl::priceIdle() {
    const auto costOf = [&](std::int32_t i, std::int32_t j) {
        return problem->cost[static_cast<std::size_t>(i) * static_cast<std::size_t>(problem->columns) +
                             static_cast<std::size_t>(j)];
    };
    const auto idle = [](std::span<const double> amounts, std::int32_t k) {
        return !amounts.empty() && amounts[k] <= 0.0;
    };
    for (std::int32_t j = 0; j < problem->columns; ++j) {
        if (!idle(problem->demand, j)) continue;
        double lowest = kInfinite;
        for (const std::int32_t i : rows) lowest = std::min(lowest, costOf(i, j) - solution->rowDual[i]);
        solution->columnDual[j] = lowest < kInfinite ? lowest : 0.0;
    }
    for (std::int32_t i = 0; i < problem->rows; ++i) {
        if (!idle(problem->supply, i)) continue;
        double lowest = kInfinite;
        for (std::int32_t j = 0; j < problem->columns; ++j)
            lowest = std::min(lowest, costOf(i, j) - solution->columnDual[j]);
        solution->rowDual[i] = lowest < kInfinite ? lowest : 0.0;
    }
}

void TransportationSolver::Impl::total() {
    std::sort(solution->flows.begin(), solution->flows.end(), [](const Flow& a, const Flow& b) {
        return a.character != b.character ? a.character < b.character : a.place < b.place;
    });
    for (const Flow& flow : solution->flows) {
        const std::size_t k = static_cast<std::size_t>(flow.character) *
                                  static_cast<std::size_t>(problem->columns) +
                              static_cast<std::size_t>(flow.place);
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
    m.gather();
    m.split();
    for (const DulmageMendelsohnPart part :
         {DulmageMendelsohnPart::RowsLeft, DulmageMendelsohnPart::Even, DulmageMendelsohnPart::ColumnsLeft})
        m.solvePart(part);
    m.levelPrices(DulmageMendelsohnPart::RowsLeft);
    m.levelPrices(DulmageMendelsohnPart::ColumnsLeft);
    m.priceIdle();
    m.total();
    m.problem = nullptr;
    m.solution = nullptr;
    return {};
}

}  // namespace muster
