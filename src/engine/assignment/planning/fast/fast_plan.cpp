#include "engine/assignment/planning/fast/fast_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/infinite_cost.h"
#include "base/maths.h"
#include "engine/assignment/planning/assigner.h"
#include "engine/fields/cost/ground_level.h"

namespace muster {
namespace {

constexpr std::size_t kChunk = 128;  // Number of characters in one piece of parallel work.
// Share by which other places cost more for each change of place since places have come to rest.
constexpr float kReluctance = 0.004f;
constexpr double kRestMove = 1e-4;     // Movement of a place in a step below which it rests [m].
constexpr float kDistantCost = 25.0f;  // Cost beyond which a direction serves for two steps [m].
// Cost beyond which a direction of a group that waits to plan serves [m]
constexpr float kWaitingCost = 10.0f;
constexpr std::uint32_t kWaitingSteps = 4;  // for this number of steps.
// Number of unmatched characters whose waiting place is searched per plan.
constexpr std::int32_t kWaitingPerPlan = 32;
// Approximate number of characters from which a first plan prefetches fields.
constexpr std::size_t kPrefetchPoints = 24;
constexpr double kBottleneckExponent = 8.0;  // Exponent that approximates the bottleneck objective.
constexpr double kBottleneckShare = 0.2;     // Commit threshold share with the bottleneck objective.
constexpr std::size_t
    // Number of characters for which a round of the assignment takes one more step.
    kCharactersPerStep = 10000;
constexpr std::int32_t kMaxStepsPerRound = 6;  // Greatest number of steps of a round: ten rounds a second.
constexpr std::int32_t kSearchShare = 3;       // Inverse share of all nodes that one search may settle.
constexpr std::int32_t kMaxSearch = 4000;      // Greatest number of nodes that one search may settle.
constexpr double kMaxSettled = 40000.0;        // Nodes that all searches of a step may settle.
constexpr std::int32_t kFieldsOfGroups = 2;    // Number of fields that a step solves for all groups together.
// Number of nodes that a start takes over in a step, all groups together.
constexpr std::int32_t kStartNodes = 400;
constexpr double kStartSteps = 10.0;  // Number of steps in which a large crowd is taken over.

}  // namespace

std::unique_ptr<Plan> makeFastPlan() {
    return std::make_unique<FastPlan>();
}

void FastPlan::reserve(std::size_t characters, std::size_t places, PlanCosts& costs) {
    assignment_.reserve(assignmentDef(characters), characters, places);
    geodesics_.reserve(costs.staticGround(), places, costs.routes() != nullptr);
    costs.dynamicCost();
}

Status FastPlan::start(const PlanDef& def, const PlanInput& input) {
    if (Status status = validatePlan(def, input); !status.ok()) return status;
    if (input.costs == nullptr) return invalidArgument("plan has no costs");
    def_ = def;
    moved_.assign(input.characters.size(), Vec2{});
    for (std::size_t i = 0; i < moved_.size() && characters_.size() == moved_.size(); ++i)
        moved_[i] = input.characters[i] - characters_[i];
    copySpan(input.characters, characters_);
    copySpan(input.places, places_);
    copySpan(input.usable, usable_);
    copySpan(input.incumbent, incumbent_);
    copySpan(input.connected, connected_);
    copySpan(input.known, known_);
    copySpan(input.slowness, slowness_);
    copySpan(input.characterClass, characterClass_);
    copySpan(input.placeClass, placeClass_);
    copySpan(input.ways.way, way_);
    copySpan(input.ways.reach, reach_);
    copySpan(input.ways.onward, onward_);
    takeAmounts(input);
    ground_ = &input.costs->staticGround();
    edits_ = input.edits;
    planCosts_ = input.costs;
    pending_ = true;
    guided_ = assigned_ = false;
    return {};
}

// Takes over supplies and demands. Nobody may take a place that demands nothing. Where all other places, and
// all characters, count for one unit, it is an assignment.
void FastPlan::takeAmounts(const PlanInput& input) {
    supply_.clear();
    demand_.clear();
    for (std::size_t j = 0; def_.reassign && j < input.demand.size(); ++j) {
        if (input.demand[j] > 0.0) continue;
        if (usable_.empty()) usable_.assign(places_.size(), 1);
        usable_[j] = 0;
    }
    const auto isOne = [](double amount) { return amount == 1.0; };
    const auto isOneOrNone = [](double amount) { return amount == 1.0 || amount == 0.0; };
    if (std::all_of(input.supply.begin(), input.supply.end(), isOne) &&
        std::all_of(input.demand.begin(), input.demand.end(), isOneOrNone))
        return;
    copySpan(input.supply, supply_);
    copySpan(input.demand, demand_);
    if (supply_.empty()) supply_.assign(characters_.size(), 1.0);
    if (demand_.empty()) demand_.assign(places_.size(), 1.0);
}

// Local fields are retained here, when no query reads them.
void FastPlan::updateGeodesics(ThreadPool& pool, PlanCosts& costs, std::span<const Vec2> characters,
                               std::span<const Vec2> places) {
    geodesics_.retainFields(targets_);
    const bool many = def_.groups > kFieldsOfGroups;
    geodesics_.shareSteps(std::max(1, (def_.groups + 1) / kFieldsOfGroups), def_.groupRank,
                          many ? costs.farFields() : nullptr, costs.routes() != nullptr);
    geodesics_.update(costs.staticGround(), costs.dynamicCost(), places, pool);
    if (RouteGraph* const routes = costs.routes()) geodesics_.findRoutes(*routes, characters, targets_);
}

void FastPlan::advance(std::int32_t, std::int32_t, ThreadPool& pool) {
    if (!pending_ || guided_ || assigned_) return;
    updateGeodesics(pool, *planCosts_, characters_, places_);
    geodesicsUpdated_ = true;
    prepareFirst(pool);
    evaluateGuidance(pool);
    guided_ = true;
}

void FastPlan::assign(ThreadPool& pool) {
    if (!guided_ || assigned_) return;
    costs_.set(geodesics_, ways(), def_.geodesic, characters_, places_, guidedPlace_, incumbentCost_,
               slowness_, reluctance_);
    if (def_.reassign)
        updateAssignment(pool);
    else
        assignment_.hold(problemOf({}, {characters_, places_, usable_, connected_}), incumbentCost_);
    assigned_ = true;
}

void FastPlan::workInBackground() {
    assign(backgroundPool_);
}

DynamicAssignmentDef FastPlan::assignmentDef(std::size_t characters) const {
    DynamicAssignmentDef def;
    def.exponent = def_.bottleneck ? kBottleneckExponent : def_.exponent;
    def.threshold = def_.bottleneck ? 0.0 : def_.commitThreshold;
    def.thresholdShare = def_.bottleneck ? kBottleneckShare : def_.commitThresholdShare;
    const auto count = static_cast<double>(std::max<std::size_t>(1, characters));
    def.settledPerNode = std::min(def.settledPerNode, kMaxSettled / count);
    // Where a large formation rotates, many nodes along a long cycle pay for the gain of one.
    def.searchLimit = std::clamp(static_cast<std::int32_t>(count) / kSearchShare, def.searchLimit,
                                 kMaxSearch);
    def.startNodes = std::max(kStartNodes, static_cast<std::int32_t>(count / kStartSteps)) /
                     std::max(1, def_.starts);
    def.stepsPerRound = static_cast<std::int32_t>(
        std::min<std::size_t>(kMaxStepsPerRound, 1 + characters / kCharactersPerStep));
    return def;
}

// Evaluates costs and directions to the incumbent places, which both the assignment and guide() need.
void FastPlan::evaluateGuidance(ThreadPool& pool) {
    guidedPlace_.resize(characters_.size(), -1);
    guidance_.resize(characters_.size());
    incumbentCost_.resize(characters_.size());
    records_.resize(characters_.size());
    reluctance_.assign(characters_.size(), 0.0f);
    targets_.resize(characters_.size());
    ++guidanceRound_;
    forChunks(&pool, characters_.size(), kChunk, [&](std::size_t i) {
        const Vec2 direction = guidance_[i].direction;
        evaluateGuidanceOf(i);
        if (!slowness_.empty() && incumbent_[i] >= 0)
            incumbentCost_[i] = GeodesicCostOracle::slowed(incumbentCost_[i], slowness_[i]);
        keepRecord(i, direction);
    });
}

void FastPlan::evaluateGuidanceOf(std::size_t i) {
    const std::int32_t place = incumbent_[i];
    const bool samePlace = guidedPlace_[i] == place;
    guidedPlace_[i] = place;
    if (place < 0) return;
    const double byWay = ways().cost(static_cast<std::int32_t>(i), place, places_.size());
    if (byWay < kInfiniteCost && def_.geodesic) {
        // The passage of the character leads it; a target that it does not follow would mislead it behind.
        targets_[i] = {};
        guidance_[i] = {normalized(places_[place] - characters_[i]), static_cast<float>(byWay)};
        incumbentCost_[i] = guidance_[i].cost;
        return;
    }
    const bool reusesDirection = samePlace && guidance_[i].cost > kDistantCost &&
                                 (i + guidanceRound_) % 2 == 0;
    if (reusesDirection)
        guidance_[i].cost = geodesics_.cost(characters_[i], place);
    else
        guidance_[i] = geodesics_.guidance(characters_[i], place, targets_[i]);
    incumbentCost_[i] = def_.geodesic ? guidance_[i].cost
                                      : static_cast<float>(distance(characters_[i], places_[place]));
}

// The cost of a metre of the ground at a point.
double FastPlan::groundCost(Vec2 p) const {
    const Grid& grid = ground_->grid();
    return ground_->openCost() / ground_->travelSpeed(grid.index(grid.nearestCell(p)));
}

// The rest of the path to a place never counts as more than before, except for the movement of the place and
// of the character off its path: so an estimate that jumps to and fro does not exchange characters to and
// fro.
void FastPlan::keepRecord(std::size_t i, Vec2 direction) {
    Record& record = records_[i];
    const std::int32_t place = incumbent_[i];
    float cost = i < known_.size() && known_[i] >= 0.0f ? known_[i] : incumbentCost_[i];
    // The costs of a first plan become better with its fields; where many share a place it is no exchange; a
    // character that has chosen a passage counts with the path through it.
    const bool chosen = i < way_.size() && way_[i] >= 0;
    if (place < 0 || chosen || !def_.reassign || first_.unfinished() || !supply_.empty()) {
        record = {};
        if (place >= 0) incumbentCost_[i] = cost;
        return;
    }
    std::int32_t changes = 0;
    if (record.place == place && record.edits == edits_) {
        const double placeMoved = distance(record.at, places_[place]);
        if (cost > record.cost) {
            const Vec2 astray = moved_[i] - direction * std::max(0.0, dot(moved_[i], direction));
            const double slowness = slowness_.empty() ? 1.0 : slowness_[i];
            const double more = groundCost(places_[place]) * placeMoved +
                                groundCost(characters_[i]) * length(astray);
            cost = std::min(cost, record.cost + static_cast<float>(slowness * more));
        }
        changes = placeMoved > kRestMove ? 0 : record.changes;
    }
    record = {places_[place], cost, place, edits_, changes};
    incumbentCost_[i] = cost;
    reluctance_[i] = kReluctance * static_cast<float>(changes);
}

// A character that has been given another place counts with the cost for which it was given.
void FastPlan::recordChanges() {
    if (!def_.reassign || first_.unfinished() || !supply_.empty()) return;
    const std::span<const std::int32_t> place = assignment_.placeOf();
    const std::span<const float> cost = assignment_.cost();
    for (std::size_t i = 0; i < characters_.size() && i < place.size(); ++i)
        if (place[i] >= 0 && place[i] != incumbent_[i])
            records_[i] = {places_[place[i]], cost[i], place[i], edits_, records_[i].changes + 1};
}

bool FastPlan::incumbentsAreAssigned() const {
    const std::span<const std::int32_t> assigned = assignment_.placeOf();
    return std::equal(assigned.begin(), assigned.end(), incumbent_.begin(), incumbent_.end());
}

void FastPlan::prepareFirst(ThreadPool& pool) {
    const bool nobody = std::all_of(incumbent_.begin(), incumbent_.end(),
                                    [](std::int32_t j) { return j < 0; });
    bool whole = false;
    if (first_.begin(nobody && def_.reassign, def_.reassign && incumbentsAreAssigned())) {
        prefetchPoints_.clear();
        const std::size_t stride = std::max<std::size_t>(1, characters_.size() / kPrefetchPoints);
        for (std::size_t i = 0; i < characters_.size(); i += stride)
            prefetchPoints_.push_back(characters_[i]);
        whole = geodesics_.prefetch(prefetchPoints_, first_.looksThoroughly(def_),
                                    first_.cells(def_, characters_.size()), pool);
    }
    first_.decide(def_, whole, characters_.size());
}

MatchingProblem FastPlan::problemOf(const DynamicAssignmentDef& def, const AssignmentInput& input) const {
    return {def, input, {characterClass_, placeClass_}, incumbent_, supply_, demand_};
}

// Before the first plan nobody has a place worth keeping, so that every gain is committed.
void FastPlan::updateAssignment(ThreadPool& pool) {
    const AssignmentInput input{characters_, places_, usable_, connected_};
    DynamicAssignmentDef def = assignmentDef(characters_.size());
    if (first_.unfinished()) def.threshold = def.thresholdShare = 0.0;
    def.initialRounds = FirstPlan::roundsAtOnce(characters_.size());
    const MatchingProblem problem = problemOf(def, input);
    switch (first_.action()) {
        case FirstPlan::Action::Start:
            return assignment_.coldStart(problem, costs_, pool);
        case FirstPlan::Action::Wait:
            return;
        case FirstPlan::Action::Repair:
        case FirstPlan::Action::None:
            return assignment_.update(problem, costs_, pool);
    }
}

Status FastPlan::finish(ThreadPool& pool, PlanResult& result) {
    if (!pending()) return invalidArgument("no plan is under way");
    advance(0, 1, pool);
    assign(pool);
    pending_ = guided_ = assigned_ = false;
    everFinished_ = true;
    report(result);
    recordChanges();
    findWaitingPlaces();
    return {};
}

// The place of each character by this plan, -1 for none.
std::span<const std::int32_t> FastPlan::placeOf() const {
    return def_.reassign ? assignment_.placeOf() : std::span<const std::int32_t>(incumbent_);
}

void FastPlan::report(PlanResult& result) const {
    const std::span<const std::int32_t> place = placeOf();
    const std::span<const float> cost = def_.reassign ? assignment_.cost()
                                                      : std::span<const float>(incumbentCost_);
    result.flows.clear();
    result.cost.assign(characters_.size(), kInfiniteCost);
    result.objective = 0.0;
    result.provisional = first_.provisional();
    result.first = first_.unfinished();
    result.reassigned = 0;
    for (std::int32_t i = 0; std::cmp_less(i, characters_.size()); ++i) {
        const std::int32_t j = place[i];
        if (j != incumbent_[i]) ++result.reassigned;
        if (j < 0 || (!usable_.empty() && usable_[j] == 0)) continue;
        result.flows.push_back({i, j, 1.0});
        result.cost[i] = cost[i];
        result.objective += power(cost[i], def_.exponent);
    }
    if (const WeightedMatching* const weighted = assignment_.weighted()) {
        result.flows.assign(weighted->flows().begin(), weighted->flows().end());
        result.objective = weighted->objective(def_.exponent);
    }
    result.gapBound = def_.reassign && !def_.bottleneck ? assignment_.dualityGap() : result.objective;
}

std::int32_t FastPlan::nearestUsablePlace(Vec2 p) const {
    std::int32_t place = -1;
    double nearest = kInfiniteCost;
    for (std::size_t j = 0; j < places_.size(); ++j) {
        const double d = lengthSquared(places_[j] - p);
        if (d >= nearest || (!usable_.empty() && usable_[j] == 0)) continue;
        nearest = d;
        place = static_cast<std::int32_t>(j);
    }
    return place;
}

// Searches waiting places for some unmatched characters per plan, in turn.
void FastPlan::findWaitingPlaces() {
    const std::size_t count = characters_.size();
    waitingPlace_.resize(count, -1);
    if (count == 0) return;
    const std::span<const std::int32_t> place = placeOf();
    std::int32_t searches = 0;
    for (std::size_t k = 0; k < count && searches < kWaitingPerPlan; ++k) {
        const std::size_t i = waitingCursor_ % count;
        waitingCursor_ = static_cast<std::uint32_t>(i + 1);
        waitingPlace_[i] = -1;
        if (place[i] >= 0 || (!connected_.empty() && connected_[i] == 0)) continue;
        ++searches;
        waitingPlace_[i] = nearestUsablePlace(characters_[i]);
    }
}

std::int32_t FastPlan::waitingPlace(std::int32_t character) const {
    const bool known = character >= 0 && std::cmp_less(character, waitingPlace_.size());
    return known ? waitingPlace_[character] : -1;
}

void FastPlan::guide(const GuidanceInput& input, ThreadPool& pool, std::span<Vec2> direction,
                     std::span<double> cost) {
    MUSTER_ASSERT(input.place.size() == input.characters.size() &&
                  direction.size() == input.characters.size() && cost.size() == input.characters.size());
    if (!geodesicsUpdated_) updateGeodesics(pool, *input.costs, input.characters, input.places);
    const bool known = guidedPlace_.size() == input.characters.size();
    const bool evaluated = std::exchange(geodesicsUpdated_, false);
    if (!evaluated) ++guidanceRound_;
    targets_.resize(input.characters.size());
    forChunks(&pool, input.characters.size(), kChunk, [&](std::size_t i) {
        const std::int32_t place = input.place[i];
        direction[i] = {};
        cost[i] = kInfiniteCost;
        if (place < 0 || std::cmp_greater_equal(place, input.places.size())) return;
        const bool same = known && guidedPlace_[i] == place;
        const bool serves = evaluated ||
                            (guidance_[i].cost > kWaitingCost && (i + guidanceRound_) % kWaitingSteps != 1);
        const Guidance guidance = same && serves
                                      ? guidance_[i]
                                      : geodesics_.guidance(input.characters[i], place, targets_[i]);
        if (same) guidance_[i] = guidance;
        direction[i] = guidance.direction;
        const bool unknown = guidance.direction == Vec2{} && guidance.cost > 0.0f;
        cost[i] = unknown ? kInfiniteCost : static_cast<double>(guidance.cost);
    });
}

// Solves a field of its own: a query of the geodesics would add requests, and thus change later plans.
double FastPlan::costAt(std::int32_t place, Vec2 p) const {
    if (!everFinished_ || ground_ == nullptr || place < 0 || std::cmp_greater_equal(place, places_.size()) ||
        !isFinite(p))
        return kInfiniteCost;
    const Vec2 source = places_[place];
    if (picture_.ground != ground_->version() || !(picture_.place == source)) {
        if (!picture_.solver) picture_.solver.emplace();
        picture_.solver->solve(ground_->fineLevel().unitCost(), source, {}, picture_.field);
        picture_.place = source;
        picture_.ground = ground_->version();
    }
    return picture_.field.cost(p);
}

void FastPlan::forget() {
    for (auto* points : {&characters_, &places_}) points->clear();
    for (auto* numbers : {&incumbent_, &way_, &guidedPlace_, &waitingPlace_}) numbers->clear();
    for (auto* numbers : {&known_, &reach_, &onward_, &incumbentCost_}) numbers->clear();
    for (auto* flags : {&usable_, &connected_, &characterClass_, &placeClass_}) flags->clear();
    slowness_.clear();
    for (auto* amounts : {&supply_, &demand_}) amounts->clear();
    guidance_.clear();
    records_.clear();
    targets_.clear();
    assignment_.clear();
    waitingCursor_ = 0;
    pending_ = guided_ = assigned_ = everFinished_ = false;
}

void FastPlan::save(Writer& archive) const {
    visit(*this, archive);
    geodesics_.save(archive);
}

bool FastPlan::load(Reader& archive, ThreadPool&) {
    visit(*this, archive);
    return archive.ok() && geodesics_.load(archive) && consistent();
}

void FastPlan::keepFieldsOf(Plan& before) {
    if (auto* const other = dynamic_cast<FastPlan*>(&before)) geodesics_.keepFieldsOf(other->geodesics_);
}

void FastPlan::bind(PlanCosts& costs) {
    geodesics_.bind(costs.staticGround());
}

bool FastPlan::consistent() const {
    const std::size_t n = characters_.size();
    // Plans are never saved between start() and the end of their background work.
    const bool whole = pending_ == assigned_ &&
                       (!pending_ || (incumbentCost_.size() == n &&
                                      (!def_.reassign || assignment_.placeOf().size() == n)));
    const bool sizes = whole && incumbent_.size() == n && (connected_.empty() || connected_.size() == n) &&
                       (usable_.empty() || usable_.size() == places_.size()) &&
                       (slowness_.empty() || slowness_.size() == n) &&
                       (characterClass_.empty() || characterClass_.size() == n) &&
                       placeClass_.size() == (characterClass_.empty() ? 0 : places_.size()) &&
                       (waitingPlace_.empty() || waitingPlace_.size() == n);
    const auto inRange = [&](std::int32_t j) {
        return j >= -1 && (j < 0 || std::cmp_less(j, places_.size()));
    };
    const std::span<const std::int32_t> assigned = assignment_.placeOf();
    return sizes && std::all_of(incumbent_.begin(), incumbent_.end(), inRange) &&
           std::all_of(assigned.begin(), assigned.end(), inRange) &&
           std::none_of(incumbentCost_.begin(), incumbentCost_.end(),
                        [](float c) { return std::isnan(c); }) &&
           guidanceConsistent() && flowsConsistent() &&
           std::all_of(waitingPlace_.begin(), waitingPlace_.end(), inRange) &&
           std::all_of(characters_.begin(), characters_.end(), isFinite) &&
           std::all_of(places_.begin(), places_.end(), isFinite);
}

bool FastPlan::flowsConsistent() const {
    const WeightedMatching* const weighted = assignment_.weighted();
    return weighted == nullptr ||
           (weighted->placeOf().size() == characters_.size() &&
            std::all_of(weighted->flows().begin(), weighted->flows().end(),
                        [&](const Flow& flow) { return std::cmp_less(flow.place, places_.size()); }));
}

bool FastPlan::guidanceConsistent() const {
    const auto valid = [](const Guidance& guidance) {
        return isFinite(guidance.direction) && lengthSquared(guidance.direction) < 1.1 &&
               !std::isnan(guidance.cost);
    };
    return guidance_.size() == guidedPlace_.size() && std::all_of(guidance_.begin(), guidance_.end(), valid);
}

bool FastPlan::suits(std::size_t characters, std::size_t places, const Grid&) const {
    return (!everFinished_ && !pending()) || (characters_.size() == characters && places_.size() == places);
}

void FastPlan::hash(Hasher& archive) const {
    visit(*this, archive);
    geodesics_.hash(archive);
}

}  // namespace muster
