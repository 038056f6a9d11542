#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/assignment/planning/exact/connected_regions.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "scale/judge.h"
#include "scale/sparse_assignment.h"

namespace muster::scale {
namespace {

// The first cost field of a place reaches kReachFactor times the distance to its assignee plus kReachOffset,
// which takes in about a hundred characters.
constexpr double kReachFactor = 1.2;
constexpr double kReachOffset = 5.5;  // [m]
constexpr double kTolerance = 1e-9;   // Reduced costs are compared up to this share of the least one.

struct Worker {
    EikonalSolver solver;
    CostField field;
    std::vector<Vec2> targets;
    std::vector<std::int32_t> near;
};

// A lower bound of the optimum by linear programming duality. Rows are matched places, columns characters.
class Judgement {
public:
    Judgement(const UnitCost& cost, const Committed& plan, ThreadPool& pool)
        : cost_(cost), plan_(plan), pool_(pool), workers_(static_cast<std::size_t>(pool.threads())) {}

    Verdict run(std::int32_t rounds);

private:
    void prepare();
    void evaluate(const std::vector<std::int32_t>& rows);
    void evaluateRow(std::int32_t row, Worker& worker);
    void dropUnreachable();
    std::vector<double> initialDuals() const;
    double certify(std::vector<std::int32_t>& unproven);
    double boundOf(std::int32_t row, double& reach) const;
    double straightBound(std::int32_t row, std::size_t column) const;
    double powered(double c) const { return plan_.exponent == 2.0 ? c * c : power(c, plan_.exponent); }

    const UnitCost& cost_;
    const Committed& plan_;
    ThreadPool& pool_;
    std::vector<Worker> workers_;
    ConnectedRegions regions_;
    std::vector<Vec2> standing_;          // Per character: nearest free point [m].
    std::vector<std::int32_t> region_;    // Per character: connected region.
    std::vector<std::int32_t> byX_;       // Characters from left to right.
    std::vector<std::int32_t> placeOf_;   // Per row: index of the place.
    std::vector<std::int32_t> assignee_;  // Per row: character at the place.
    std::vector<double> reach_;           // Per row: pairs nearer than this have their exact costs [m].
    std::vector<std::vector<Arc>> arcs_;  // Per row: pairs with exact costs.
    std::vector<double> own_;             // Per row: cost of its assignee.
    SparseAssignment solver_;
};

void Judgement::prepare() {
    regions_.label(cost_);
    for (std::size_t i = 0; i < plan_.characters.size(); ++i) {
        standing_.push_back(regions_.nearestFreePoint(plan_.characters[i]));
        region_.push_back(regions_.at(standing_.back()));
        byX_.push_back(static_cast<std::int32_t>(i));
        if (plan_.placeOf[i] < 0) continue;
        placeOf_.push_back(plan_.placeOf[i]);
        assignee_.push_back(static_cast<std::int32_t>(i));
        const Vec2 place = plan_.places[plan_.placeOf[i]];
        reach_.push_back(kReachFactor * distance(plan_.characters[i], place) + kReachOffset);
    }
    std::sort(byX_.begin(), byX_.end(), [&](std::int32_t a, std::int32_t b) {
        return plan_.characters[a].x != plan_.characters[b].x ? plan_.characters[a].x < plan_.characters[b].x
                                                              : a < b;
    });
    arcs_.resize(placeOf_.size());
    own_.assign(placeOf_.size(), kInfinite);
}

// Solves one cost field and evaluates the costs of all characters within reach.
void Judgement::evaluateRow(std::int32_t row, Worker& worker) {
    const Vec2 place = plan_.places[placeOf_[row]];
    const std::int32_t ground = regions_.at(place);
    worker.targets.clear();
    worker.near.clear();
    const double reach = reach_[row];
    auto at = std::lower_bound(byX_.begin(), byX_.end(), place.x - reach,
                               [&](std::int32_t i, double x) { return plan_.characters[i].x < x; });
    for (; at != byX_.end() && plan_.characters[*at].x <= place.x + reach; ++at) {
        if (region_[*at] != ground || distance(plan_.characters[*at], place) > reach) continue;
        worker.near.push_back(*at);
        worker.targets.push_back(standing_[*at]);
    }
    arcs_[row].clear();
    own_[row] = kInfinite;
    if (worker.near.empty() || ground < 0) return;
    worker.solver.solve(cost_, place, worker.targets, worker.field);
    for (const std::int32_t i : worker.near) {
        const double c = std::max(0.0, worker.field.cost(standing_[i])) +
                         distance(plan_.characters[i], standing_[i]);
        if (!(c < kInfinite)) continue;
        arcs_[row].push_back({i, powered(c)});
        if (i == assignee_[row]) own_[row] = arcs_[row].back().cost;
    }
}

void Judgement::evaluate(const std::vector<std::int32_t>& rows) {
    const auto work = [&](std::int32_t item, std::int32_t worker) {
        evaluateRow(rows[item], workers_[worker]);
    };
    pool_.run(static_cast<std::int32_t>(rows.size()), work);
}

// Leaves out places that their assignees cannot reach on this ground, from the plan and from the bound.
void Judgement::dropUnreachable() {
    std::size_t count = 0;
    for (std::size_t row = 0; row < placeOf_.size(); ++row) {
        if (!(own_[row] < kInfinite)) continue;
        placeOf_[count] = placeOf_[row];
        assignee_[count] = assignee_[row];
        reach_[count] = reach_[row];
        own_[count] = own_[row];
        std::swap(arcs_[count], arcs_[row]);
        ++count;
    }
    placeOf_.resize(count);
    assignee_.resize(count);
    reach_.resize(count);
    own_.resize(count);
    arcs_.resize(count);
}

// Where a crowd follows a moving formation, optimal duals are nearly linear in position. Starting from that
// linear function saves most augmentations. It is only valid where every column is matched.
std::vector<double> Judgement::initialDuals() const {
    if (placeOf_.size() != plan_.characters.size()) return {};
    Vec2 mean;
    for (std::size_t row = 0; row < placeOf_.size(); ++row)
        mean += plan_.places[placeOf_[row]] - plan_.characters[assignee_[row]];
    mean = mean / static_cast<double>(std::max<std::size_t>(1, placeOf_.size()));
    const double slope = length(mean) > 1e-9 ? plan_.exponent * power(length(mean), plan_.exponent - 2.0)
                                             : 0.0;
    std::vector<double> duals;
    for (const Vec2 p : plan_.characters) duals.push_back(-slope * dot(mean, p));
    return duals;
}

double Judgement::straightBound(std::int32_t row, std::size_t column) const {
    return powered(static_cast<double>(cost_.lowest) *
                   distance(plan_.characters[column], plan_.places[placeOf_[row]]));
}

// The least reduced cost of the row. `reach` is raised to the distance up to which exact costs are needed for
// the bound to reach the least known reduced cost.
double Judgement::boundOf(std::int32_t row, double& reach) const {
    const std::vector<double>& dual = solver_.duals();
    double known = kInfinite;
    for (const Arc& arc : arcs_[row]) known = std::min(known, arc.cost - dual[arc.column]);
    const double tolerance = kTolerance * std::max(1.0, std::fabs(known));
    double least = known;
    const Vec2 place = plan_.places[placeOf_[row]];
    for (std::size_t i = 0; i < plan_.characters.size(); ++i) {
        const double away = distance(plan_.characters[i], place);
        if (away <= reach_[row]) continue;
        const double bound = straightBound(row, i) - dual[i];
        least = std::min(least, bound);
        if (bound < known - tolerance) reach = std::max(reach, away + 1e-6);
    }
    return least;
}

// The dual objective. By weak duality it is a lower bound for any duals that are at most zero, and for any
// duals at all where every column is matched.
double Judgement::certify(std::vector<std::int32_t>& unproven) {
    std::vector<double> least(placeOf_.size());
    std::vector<double> wanted(reach_);
    const auto work = [&](std::int32_t row, std::int32_t) { least[row] = boundOf(row, wanted[row]); };
    pool_.run(static_cast<std::int32_t>(placeOf_.size()), work);
    unproven.clear();
    double sum = 0.0;
    for (std::size_t row = 0; row < placeOf_.size(); ++row) {
        sum += least[row];
        if (wanted[row] > reach_[row]) unproven.push_back(static_cast<std::int32_t>(row));
    }
    for (const double v : solver_.duals()) sum += v;
    reach_ = std::move(wanted);
    return sum;
}

Verdict Judgement::run(std::int32_t rounds) {
    prepare();
    std::vector<std::int32_t> rows(placeOf_.size());
    for (std::size_t k = 0; k < rows.size(); ++k) rows[k] = static_cast<std::int32_t>(k);
    evaluate(rows);
    dropUnreachable();
    Verdict verdict;
    verdict.matched = static_cast<std::int32_t>(placeOf_.size());
    for (const double c : own_) verdict.committed += c;
    if (verdict.matched == 0) return verdict;
    const std::vector<double> start = initialDuals();
    while (verdict.rounds < rounds) {
        ++verdict.rounds;
        solver_.solve(arcs_, static_cast<std::int32_t>(plan_.characters.size()), start);
        verdict.bound = std::max(verdict.bound, certify(rows));
        if (rows.empty()) break;
        if (verdict.rounds < rounds) evaluate(rows);
    }
    for (const std::vector<Arc>& arcs : arcs_) verdict.pairs += static_cast<std::int64_t>(arcs.size());
    return verdict;
}

}  // namespace

Verdict judgeByBound(const UnitCost& cost, const Committed& plan, ThreadPool& pool, std::int32_t rounds) {
    return Judgement(cost, plan, pool).run(std::max(1, rounds));
}

}  // namespace muster::scale
