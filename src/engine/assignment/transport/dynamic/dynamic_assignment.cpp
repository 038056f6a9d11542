#include "engine/assignment/transport/dynamic/dynamic_assignment.h"

#include <algorithm>
#include <utility>

namespace muster {
namespace {

// Number of nodes of which more than one violated node lets the duals be fitted again.
constexpr std::int32_t kNodesPerViolated = 8;
constexpr std::int32_t kFitDelay = 8;  // Number of repairs between two fits of the duals.
// Number of repairs between two fits while the crowd is far and little changes.
constexpr std::int32_t kFarFitDelay = 40;

}  // namespace

// Defined here once, since these functions are long.
DynamicAssignment::DynamicAssignment() = default;
DynamicAssignment::DynamicAssignment(const DynamicAssignment& other) = default;
DynamicAssignment& DynamicAssignment::operator=(const DynamicAssignment& other) = default;
DynamicAssignment::DynamicAssignment(DynamicAssignment&& other) noexcept = default;
DynamicAssignment& DynamicAssignment::operator=(DynamicAssignment&& other) noexcept = default;
DynamicAssignment::~DynamicAssignment() = default;

void DynamicAssignment::clear() {
    reset({}, 0, 0);
    objective_ = dualityGap_ = 0.0;
    dualSlope_ = {};
    units_ = 1.0;
}

void DynamicAssignment::reserve(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places) {
    reset(def, characters, places);
    reset(def, 0, 0);
}

void DynamicAssignment::reset(const DynamicAssignmentDef& def, std::size_t characters, std::size_t places) {
    round_ = stepOfRound_ = fitDelay_ = violatedNodes_ = unstarted_ = 0;
    far_ = near_ = false;
    graph_.reset(static_cast<std::int32_t>(characters), static_cast<std::int32_t>(places));
    initialAssignment_.reserve(characters, places);
    searchLimit_ = def.searchLimit;
    cycleCancelling_.reset(graph_.count(), def.searchLimit);
    columnGeneration_.reset(graph_.count());
    placeOf_.assign(characters, -1);
    cost_.assign(characters, 0.0f);
}

AssignmentStep DynamicAssignment::start(const AssignmentProblem& problem,
                                        std::span<const std::int32_t> placeOf) {
    reset(problem.def, problem.input.characters.size(), problem.input.places.size());
    if (!placeOf.empty()) graph_.assignPlaces(placeOf);
    const AssignmentStep step = graph_.beginStep(problem, initialAssignment_);
    measureDistance(problem.def);
    graph_.rebuildArcs(step);
    graph_.indexIncomingArcs();
    initialDuals_.run(step, graph_);
    publish(step);
    measureDualityGap(step);
    return step;
}

void DynamicAssignment::warmStart(const DynamicAssignmentDef& def, const AssignmentInput& input,
                                  std::span<const std::int32_t> placeOf, CostOracle& costs,
                                  ThreadPool& pool) {
    start({def, input, costs, pool}, placeOf);
}

void DynamicAssignment::beginFrom(const DynamicAssignmentDef& def, const AssignmentInput& input,
                                  std::span<const std::int32_t> placeOf, CostOracle& costs,
                                  ThreadPool& pool) {
    reset(def, input.characters.size(), input.places.size());
    graph_.assignPlaces(placeOf);
    publish(graph_.beginStep({def, input, costs, pool}, initialAssignment_));
    dualityGap_ = objective_;
    unstarted_ = graph_.count() + 1;
}

void DynamicAssignment::continueStart(const AssignmentStep& step) {
    if (unstarted_ > 1) {
        const std::int32_t first = graph_.count() + 1 - unstarted_;
        const std::int32_t end = std::min(first + std::max(1, step.def.startNodes), graph_.count());
        graph_.startArcs(step, first, end);
        unstarted_ -= end - first;
    } else {
        graph_.indexIncomingArcs();
        initialDuals_.run(step, graph_);
        unstarted_ = 0;
    }
    publish(step);
    dualityGap_ = objective_;  // No duals are known yet.
    if (unstarted_ == 0) measureDualityGap(step);
}

void DynamicAssignment::coldStart(const DynamicAssignmentDef& def, const AssignmentInput& input,
                                  CostOracle& costs, ThreadPool& pool) {
    const AssignmentStep first = start({def, input, costs, pool}, {});
    for (std::int32_t k = 0; k < def.initialRounds && graph_.count() > 0; ++k) {
        const AssignmentStep step = graph_.reshifted(first);
        repair(step);
        publish(step);
    }
}

void DynamicAssignment::update(const DynamicAssignmentDef& def, const AssignmentInput& input,
                               CostOracle& costs, ThreadPool& pool) {
    if (std::cmp_not_equal(graph_.nodes().characters(), input.characters.size()) ||
        std::cmp_not_equal(graph_.nodes().places(), input.places.size())) {
        coldStart(def, input, costs, pool);
        return;
    }
    if (searchLimit_ != def.searchLimit) {
        searchLimit_ = def.searchLimit;
        cycleCancelling_.reset(graph_.count(), def.searchLimit);
    }
    if (unstarted_ > 0) return continueStart(graph_.beginStep({def, input, costs, pool}, initialAssignment_));
    if (stepOfRound_ >= def.stepsPerRound) stepOfRound_ = 0;
    if (stepOfRound_ == 0) ++round_;
    const AssignmentStep step = graph_.beginStep({def, input, costs, pool}, initialAssignment_);
    if (stepOfRound_ < def.refreshSteps()) refresh(step);
    graph_.updateChangedDuals();
    if (stepOfRound_ >= def.stepsPerRound - def.repairSteps()) repair(step);
    publish(step);
    ++stepOfRound_;
}

void DynamicAssignment::refresh(const AssignmentStep& step) {
    measureDistance(step.def);
    graph_.refreshArcs(step, schedule(step.def));
    // While the crowd is far, straight lines bound costs too loosely, and arcs to neighbours suffice.
    if (!far_) columnGeneration_.run(step, graph_, CycleCancelling::tolerance(step, graph_));
}

void DynamicAssignment::measureDistance(const DynamicAssignmentDef& def) {
    double sum = 0.0;
    for (const float c : graph_.matchedCosts()) sum += c;
    far_ = sum > def.farCost * graph_.count();
    near_ = sum < def.nearCost * graph_.count();
}

RefreshSchedule DynamicAssignment::schedule(const DynamicAssignmentDef& def) const {
    const std::int64_t count = graph_.count();
    const std::int32_t period = far_    ? def.farRefreshPeriod
                                : near_ ? def.nearRefreshPeriod
                                        : def.refreshPeriod;
    RefreshSchedule schedule;
    schedule.round = round_;
    schedule.beginsRound = stepOfRound_ == 0;
    schedule.first = static_cast<std::int32_t>(count * stepOfRound_ / def.refreshSteps());
    schedule.end = static_cast<std::int32_t>(count * (stepOfRound_ + 1) / def.refreshSteps());
    schedule.period = def.rounds(period);
    schedule.candidatePeriod = def.rounds(def.candidatePeriod);
    return schedule;
}

void DynamicAssignment::repair(const AssignmentStep& step) {
    const DynamicAssignmentDef& def = step.def;
    // Where many arcs are violated, searches find no direction, so the duals are fitted again.
    if (fitDelay_ > 0) --fitDelay_;
    if (fitDelay_ == 0 && violatedNodes_ > graph_.count() / kNodesPerViolated) {
        initialDuals_.run(step, graph_);
        fitDelay_ = far_ ? kFarFitDelay : kFitDelay;
    }
    const double settledPerNode = far_ ? std::min(def.settledPerNode, def.farSettledPerNode)
                                       : def.settledPerNode;
    cycleCancelling_.run(step, graph_, static_cast<std::int64_t>(settledPerNode * graph_.count()),
                         far_ ? def.farRetryDelay : def.retryDelay);
    violatedNodes_ = cycleCancelling_.violatedNodes();
    if (violatedNodes_ > 0)
        measureDualityGap(step);
    else
        dualityGap_ = cycleCancelling_.gapBefore() * step.power.units();
}

void DynamicAssignment::publish(const AssignmentStep& step) {
    const AssignmentNodes& nodes = graph_.nodes();
    double sum = 0.0;
    for (const double power : graph_.matchedPowers()) sum += power;
    for (std::int32_t i = 0; i < nodes.characters(); ++i) {
        const std::int32_t node = nodes.nodeOf(i);
        const bool matched = node >= 0 && nodes.isPlace(node);
        placeOf_[i] = matched ? node : -1;
        cost_[i] = matched ? graph_.matchedCost(node) : 0.0f;
    }
    dualSlope_ = step.dualSlope;
    units_ = step.power.units();
    objective_ = sum * units_;
}

void DynamicAssignment::measureDualityGap(const AssignmentStep& step) {
    double gap = 0.0;
    for (std::int32_t node = 0; node < graph_.count(); ++node)
        gap -= std::min(0.0, graph_.leastReducedCost(node));
    dualityGap_ = gap * step.power.units();
}

void DynamicAssignment::duals(const AssignmentInput& input, std::span<double> dual) const {
    for (std::size_t j = 0; j < dual.size(); ++j)
        dual[j] = units_ * (graph_.duals()[j] + dot(dualSlope_, input.places[j]));
}

void DynamicAssignment::afterReading() {
    searchLimit_ = 0;
    columnGeneration_.afterReading(graph_.count());
}

}  // namespace muster
