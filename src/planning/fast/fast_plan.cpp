#include "planning/fast/fast_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/maths.h"
#include "planning/exact/plan_generation.h"

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kChunk = 128;  // Characters in one piece of parallel work.
constexpr float kFarOwn = 25.0f;     // From so far a direction serves for two steps [m].
// Unmatched characters for whom a place to wait at is sought.
constexpr std::int32_t kWaitingPerPlan = 32;
constexpr std::size_t kSurveyed = 24;         // Characters from which a first plan looks at the ground.
constexpr double kLongestWalkExponent = 8.0;  // Stands for the longest walk alone.
constexpr double kLongestWalkShare = 0.2;     // Changes must gain that share then.
// Characters from which the matching is spread over two steps, twice as many three...
constexpr std::size_t kPerTurn = 10000;
constexpr std::int32_t kMostTurns = 6;  // ... and so on up to these: ten times a second.
// Nodes that one search may settle, as a share of all seats...
constexpr std::int32_t kSeatsPerSearch = 3;
constexpr std::int32_t kLongestSearch = 4000;  // ... at most.
constexpr double kMostSettled = 40000.0;       // Nodes of all searches in a step, whatever the crowd.
constexpr std::size_t kSmallCrowd = 3000;
constexpr std::int32_t kSmallRounds = 24;  // Of repairs after a cold start.

template <class T>
void copy(std::span<const T> from, std::vector<T>& to) {
    to.assign(from.begin(), from.end());
}

}  // namespace

std::unique_ptr<Plan> makeFastPlan() {
    return std::make_unique<FastPlan>();
}

void FastPlan::reserve(std::size_t characters, std::size_t places, const StaticGround& ground) {
    assignment_.reserve(assignmentDef(characters), characters, places);
    geodesics_.reserve(ground, places);
}

Status FastPlan::start(const PlanDef& def, const PlanInput& input) {
    if (Status status = checkPlan(def, input); !status.ok()) return status;
    if (!input.supply.empty() || !input.demand.empty())
        return invalidArgument("a fast plan takes one unit of supply and demand each");
    if (input.ground == nullptr || input.dynamicCost == nullptr)
        return invalidArgument("a fast plan needs the still ground and the excess");
    def_ = def;
    copy(input.characters, characters_);
    copy(input.places, places_);
    copy(input.usable, usable_);
    copy(input.incumbent, incumbent_);
    present_.clear();
    copy(input.connected, present_);
    ground_ = input.ground;
    excess_ = input.dynamicCost;
    pending_ = true;
    measured_ = matched_ = false;
    return {};
}

// What walkers need of windows was noted while they walked; nobody reads the windows now.
void FastPlan::update(ThreadPool& pool, const StaticGround& ground, const DynamicCost& excess,
                      std::span<const Vec2> places) {
    geodesics_.retainFields(walkers_);
    geodesics_.update(ground, excess, places, pool);
}

void FastPlan::advance(std::int32_t, std::int32_t, ThreadPool& pool) {
    if (!pending_ || measured_ || matched_) return;
    update(pool, *ground_, *excess_, places_);
    updated_ = true;
    measureOwn(pool);
    measured_ = true;
}

void FastPlan::match(ThreadPool& pool) {
    if (!measured_ || matched_) return;
    costs_.set(geodesics_, def_.geodesic, characters_, places_, ownPlace_, own_);
    if (def_.reassign) assign(pool);
    matched_ = true;
}

void FastPlan::workInBackground() {
    match(alone_);
}

DynamicAssignmentDef FastPlan::assignmentDef(std::size_t characters) const {
    DynamicAssignmentDef def;
    def.exponent = def_.bottleneck ? kLongestWalkExponent : def_.exponent;
    def.threshold = def_.bottleneck ? 0.0 : def_.commitThreshold;
    def.thresholdShare = def_.bottleneck ? kLongestWalkShare : def_.commitThresholdShare;
    // A small crowd can afford a better start.
    if (characters <= kSmallCrowd) def.initialRounds = kSmallRounds;
    const auto count = static_cast<double>(std::max<std::size_t>(1, characters));
    def.settledPerNode = std::min(def.settledPerNode, kMostSettled / count);
    // Where a large formation turns, what one seat gains is paid for by many others.
    def.searchLimit = std::clamp(static_cast<std::int32_t>(count) / kSeatsPerSearch, def.searchLimit,
                                 kLongestSearch);
    def.stepsPerRound = static_cast<std::int32_t>(
        std::min<std::size_t>(kMostTurns, 1 + characters / kPerTurn));
    return def;
}

// Costs and ways of all to their own places, which the matching and the steering both need.
void FastPlan::measureOwn(ThreadPool& pool) {
    ownPlace_.resize(characters_.size(), -1);
    way_.resize(characters_.size());
    own_.resize(characters_.size());
    walkers_.resize(characters_.size());
    ++round_;
    forChunks(&pool, characters_.size(), kChunk, [&](std::size_t i) {
        const std::int32_t place = incumbent_[i];
        const bool kept = ownPlace_[i] == place;
        ownPlace_[i] = place;
        if (place < 0) return;
        // Far from the place a direction serves for two steps.
        const bool goesOn = kept && way_[i].cost > kFarOwn && (i + round_) % 2 == 0;
        if (goesOn)
            way_[i].cost = geodesics_.cost(characters_[i], place);
        else
            way_[i] = geodesics_.guidance(characters_[i], place, walkers_[i]);
        own_[i] = def_.geodesic ? way_[i].cost : static_cast<float>(distance(characters_[i], places_[place]));
    });
}

bool FastPlan::sameAsMatched() const {
    const std::span<const std::int32_t> matched = assignment_.placeOf();
    return matched.size() == incumbent_.size() &&
           std::equal(matched.begin(), matched.end(), incumbent_.begin());
}

void FastPlan::assign(ThreadPool& pool) {
    const AssignmentInput input{characters_, places_, usable_, present_};
    const bool none = std::all_of(incumbent_.begin(), incumbent_.end(), [](std::int32_t j) { return j < 0; });
    if (none) {
        // Some of them, evenly picked, tell where ways are not straight.
        std::vector<Vec2> from;
        const std::size_t stride = std::max<std::size_t>(1, characters_.size() / kSurveyed);
        for (std::size_t i = 0; i < characters_.size(); i += stride) from.push_back(characters_[i]);
        geodesics_.prefetch(from, pool);
        // Nobody holds a place that it would be a pity to change.
        DynamicAssignmentDef def = assignmentDef(characters_.size());
        def.threshold = 0.0;
        def.thresholdShare = 0.0;
        assignment_.coldStart(def, input, costs_, pool);
        return;
    }
    if (!sameAsMatched())
        assignment_.warmStart(assignmentDef(characters_.size()), input, incumbent_, costs_, pool);
    assignment_.update(assignmentDef(characters_.size()), input, costs_, pool);
}

Status FastPlan::finish(ThreadPool& pool, PlanResult& result) {
    if (!pending()) return invalidArgument("no plan is under way");
    advance(0, 1, pool);
    match(pool);
    pending_ = measured_ = matched_ = false;
    planned_ = true;
    report(result);
    seekWaitingPlaces();
    return {};
}

void FastPlan::report(PlanResult& result) const {
    const std::span<const std::int32_t> placeOf = def_.reassign ? assignment_.placeOf()
                                                                : std::span<const std::int32_t>(incumbent_);
    const std::span<const float> cost = def_.reassign ? assignment_.cost() : std::span<const float>(own_);
    result.flows.clear();
    result.cost.assign(characters_.size(), kInfinite);
    result.objective = 0.0;
    result.reassigned = 0;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(characters_.size()); ++i) {
        const std::int32_t j = placeOf[i];
        if (j != incumbent_[i]) ++result.reassigned;
        if (j < 0 || (!usable_.empty() && usable_[j] == 0)) continue;
        result.flows.push_back({i, j, 1.0});
        result.cost[i] = cost[i];
        result.objective += power(cost[i], def_.exponent);
    }
    result.gapBound = def_.reassign && !def_.bottleneck ? assignment_.dualityGap() : result.objective;
}

// The nearest place that somebody can take; the search goes round among those who have none.
void FastPlan::seekWaitingPlaces() {
    const std::size_t count = characters_.size();
    waiting_.resize(count, -1);
    if (count == 0) return;
    const std::span<const std::int32_t> placeOf = def_.reassign ? assignment_.placeOf()
                                                                : std::span<const std::int32_t>(incumbent_);
    std::int32_t sought = 0;
    for (std::size_t k = 0; k < count && sought < kWaitingPerPlan; ++k) {
        const std::size_t i = turn_ % count;
        turn_ = static_cast<std::uint32_t>(i + 1);
        waiting_[i] = -1;
        if (placeOf[i] >= 0 || (!present_.empty() && present_[i] == 0)) continue;
        ++sought;
        double nearest = kInfinite;
        for (std::size_t j = 0; j < places_.size(); ++j) {
            const double d = lengthSquared(places_[j] - characters_[i]);
            if (d >= nearest || (!usable_.empty() && usable_[j] == 0)) continue;
            nearest = d;
            waiting_[i] = static_cast<std::int32_t>(j);
        }
    }
}

std::int32_t FastPlan::waitingPlace(std::int32_t character) const {
    const bool known = character >= 0 && static_cast<std::size_t>(character) < waiting_.size();
    return known ? waiting_[character] : -1;
}

void FastPlan::guide(const GuidanceInput& input, ThreadPool& pool, std::span<Vec2> direction,
                     std::span<double> cost) {
    MUSTER_ASSERT(input.place.size() == input.characters.size() &&
                  direction.size() == input.characters.size() && cost.size() == input.characters.size());
    if (!updated_ && input.ground != nullptr) update(pool, *input.ground, *input.dynamicCost, input.places);
    const bool fresh = updated_ && ownPlace_.size() == input.characters.size();
    updated_ = false;
    walkers_.resize(input.characters.size());
    forChunks(&pool, input.characters.size(), kChunk, [&](std::size_t i) {
        const std::int32_t place = input.place[i];
        direction[i] = {};
        cost[i] = kInfinite;
        if (place < 0 || static_cast<std::size_t>(place) >= input.places.size()) return;
        const Guidance way = fresh && ownPlace_[i] == place
                                 ? way_[i]
                                 : geodesics_.guidance(input.characters[i], place, walkers_[i]);
        direction[i] = way.direction;
        cost[i] = way.direction == Vec2{} && way.cost > 0.0f ? kInfinite : static_cast<double>(way.cost);
    });
}

double FastPlan::costAt(std::int32_t place, Vec2 p) const {
    if (!planned_ || ground_ == nullptr || place < 0 || static_cast<std::size_t>(place) >= places_.size() ||
        !isFinite(p))
        return kInfinite;
    // Never by the geodesics: to look at a plan must not change it.
    const Vec2 source = places_[place];
    if (picture_.ground != ground_->version() || !(picture_.place == source)) {
        picture_.solver.solve(ground_->fine(), source, {}, picture_.field);
        picture_.place = source;
        picture_.ground = ground_->version();
    }
    return picture_.field.cost(p);
}

void FastPlan::save(Writer& archive) const {
    const_cast<FastPlan*>(this)->visit(archive);
    geodesics_.save(archive);
}

bool FastPlan::load(Reader& archive, ThreadPool&) {
    visit(archive);
    return archive.ok() && geodesics_.load(archive) && consistent();
}

bool FastPlan::consistent() const {
    const std::size_t n = characters_.size();
    // Nobody saves a plan between start() and the end of its work.
    const bool whole = pending_ == matched_ &&
                       (!pending_ ||
                        (own_.size() == n && (!def_.reassign || assignment_.placeOf().size() == n)));
    const bool sizes = whole && incumbent_.size() == n && (present_.empty() || present_.size() == n) &&
                       (usable_.empty() || usable_.size() == places_.size()) &&
                       (waiting_.empty() || waiting_.size() == n);
    const auto inRange = [&](std::int32_t j) {
        return j >= -1 && j < static_cast<std::int64_t>(places_.size());
    };
    const std::span<const std::int32_t> matched = assignment_.placeOf();
    return sizes && std::all_of(incumbent_.begin(), incumbent_.end(), inRange) &&
           std::all_of(matched.begin(), matched.end(), inRange) &&
           std::none_of(own_.begin(), own_.end(), [](float c) { return std::isnan(c); }) &&
           consistentWays() && std::all_of(waiting_.begin(), waiting_.end(), inRange) &&
           std::all_of(characters_.begin(), characters_.end(), isFinite) &&
           std::all_of(places_.begin(), places_.end(), isFinite);
}

bool FastPlan::consistentWays() const {
    const auto sane = [](const Guidance& way) {
        return isFinite(way.direction) && lengthSquared(way.direction) < 1.1 && !std::isnan(way.cost);
    };
    return way_.size() == ownPlace_.size() && std::all_of(way_.begin(), way_.end(), sane);
}

bool FastPlan::suits(std::size_t characters, std::size_t places, const Grid&) const {
    return (!planned_ && !pending()) || (characters_.size() == characters && places_.size() == places);
}

void FastPlan::hash(Hasher& archive) const {
    const_cast<FastPlan*>(this)->visit(archive);
    geodesics_.hash(archive);
}

}  // namespace muster
