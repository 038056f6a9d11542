#include "engine/fields/geodesics/geodesics.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/fields/cost/ground_level.h"
#include "engine/fields/geodesics/geodesics_impl.h"

namespace muster {
namespace {

constexpr std::int32_t kFineHalfWidth = 16;    // Half width of local fields on the ground cells [cells].
constexpr std::int32_t kMiddleHalfWidth = 18;  // Half width of local fields on cells twice as wide [cells].
// Steps between two searches for the far landmarks of a place.
constexpr std::uint32_t kFarStencilPeriod = 8;
// Budget of local fields before a first plan, in steps' budgets.
constexpr std::int32_t kPrefetchFactor = 16;
constexpr std::uint32_t kUnknownPeriod = 4;  // Steps of a first plan between two looks for unknown costs.
constexpr std::int64_t kLocalCells = 2000;   // Cells of a far field that cost as much as a local field.

}  // namespace

Geodesics::Impl::Impl(const GeodesicsDef& d)
    : def(d), fine({d.fineFields, kFineHalfWidth}), middle({d.middleFields, kMiddleHalfWidth}) {}

Geodesics::Geodesics(const GeodesicsDef& def) : impl_(std::make_unique<Impl>(def)) {}
Geodesics::~Geodesics() = default;
Geodesics::Geodesics(Geodesics&&) noexcept = default;
Geodesics& Geodesics::operator=(Geodesics&&) noexcept = default;

void Geodesics::reserve(const StaticGround& ground, std::size_t places, bool routes) {
    if (ground.open()) return;
    Impl& s = *impl_;
    s.fine.fields().warmUp(ground.fineLevel());
    s.middle.fields().warmUp(ground.middle());
    s.fine.fields().reserve(places);
    s.middle.fields().reserve(places);
    s.hasRoutes = routes;
    if (!s.goesByRoutes(ground, places)) s.far.reserve(ground);
    s.ways.reserve();
    s.routeSearch.reserve();
}

void Geodesics::update(const StaticGround& ground, const DynamicCost& dynamicCost,
                       std::span<const Vec2> places, ThreadPool& pool) {
    Impl& s = *impl_;
    s.ground = &ground;
    s.dynamicCost = &dynamicCost;
    s.places.assign(places.begin(), places.end());
    s.farRequests.resize(places.size());
    s.farStencilKnown.resize(places.size(), 0);
    s.farStencil.resize(places.size());
    s.fine.beginStep(ground, ground.fineLevel(), dynamicCost, s.places);
    s.middle.beginStep(ground, ground.middle(), dynamicCost, s.places);
    if (s.far.beginStep(ground, places.size())) s.dropFarStencils();
    if (ground.open()) return;
    if (s.loaded) {
        s.fine.solveMissing(pool);
        s.middle.solveMissing(pool);
        s.far.solveMissing(pool);
        s.loaded = false;
    }
    s.updateFields(pool);
}

// Returns true where a far field was solved. A field takes a good part of the step of a small crowd, so few
// are solved in one: odd steps begin with far fields, even ones with the finest.
bool Geodesics::Impl::solveRequested(ThreadPool& pool) {
    if (std::cmp_greater_equal(places.size(), kManyPlaces)) {
        fine.solveRequested(scaledBudget(def.finePerStep), pool);
        middle.solveRequested(scaledBudget(def.middlePerStep), pool);
        return solveFar(def.farPerStep, pool) > 0;
    }
    if ((step + shareRank) % sharePeriod != 0) return false;
    std::int32_t left = places.size() < kFewPlaces ? 1 : def.finePerStep;
    if ((step + shareRank) / sharePeriod % 2 == 0) {
        left -= fine.solveRequested(left, pool);
        left -= middle.solveRequested(left, pool);
        return solveFar(left, pool) > 0;
    }
    const std::int32_t solved = solveFar(std::min(left, def.farPerStep), pool);
    left -= solved;
    left -= middle.solveRequested(std::min(left, def.middlePerStep), pool);
    fine.solveRequested(left, pool);
    return solved > 0;
}

// Runs the update phase: drains the requests of the last step.
void Geodesics::Impl::updateFields(ThreadPool& pool) {
    ++step;
    const bool farSolved = solveRequested(pool);
    fine.updateLandmarks(true);
    middle.updateLandmarks(true);
    updateFarStencils(farSolved);
}

// True where the far landmarks of a place are searched; places move little, so that they take turns.
bool Geodesics::Impl::farStencilIsDue(std::size_t place) const {
    return farStencilKnown[place] == 0 || (step + place) % kFarStencilPeriod == 0;
}

// Drops the far stencils, which refer to slots of fields that are gone.
void Geodesics::Impl::dropFarStencils() {
    std::fill(farStencilKnown.begin(), farStencilKnown.end(), std::uint8_t{0});
    for (InterpolationStencil& stencil : farStencil) stencil.count = 0;
}

void Geodesics::Impl::updateFarStencils(bool all) {
    for (std::size_t j = 0; j < places.size(); ++j) {
        if (!farRequests.active(j)) {
            farStencilKnown[j] = 0;
            farStencil[j].count = 0;
            continue;
        }
        farRequests.age(j);
        if (!all && !farStencilIsDue(j)) continue;
        farStencil[j] = far.stencil(places[j]);
        farStencilKnown[j] = 1;
    }
}

// Requests the fields that can tell the cost.
void Geodesics::Impl::requestFields(Vec2 from, std::int32_t place) {
    if (ground->lineOfSight(from, places[place])) return;
    if (fine.covers(from, place))
        fine.request(place, false);
    else if (middle.covers(from, place))
        middle.request(place, false);
    else if (!goesByRoutes(*ground, places.size()))
        farRequests.add(place);
}

// Far fields have to serve where walls keep local fields from knowing the cost, or their budget was too
// small. All pairs are looked at, because queries also request further fields that they lack.
void Geodesics::Impl::requestFarWhereUnknown(std::span<const Vec2> from) {
    if (goesByRoutes(*ground, places.size())) return;
    const auto count = static_cast<std::int32_t>(places.size());
    for (std::int32_t j = 0; j < count; ++j)
        if (fine.requested(j) || middle.requested(j))
            for (const Vec2 p : from)
                if (middle.covers(p, j) && estimate(query(p, j, false)).source == CostSource::Guess)
                    farRequests.add(j);
}

void Geodesics::shareSteps(std::int32_t period, std::int32_t rank, SharedFarFields* fields, bool routes) {
    impl_->sharePeriod = static_cast<std::uint32_t>(period);
    impl_->sharedFar = fields;
    impl_->hasRoutes = routes;
    impl_->shareRank = period > 1 ? static_cast<std::uint32_t>(rank) : 0;
}

bool Geodesics::prefetch(std::span<const Vec2> from, bool thorough, std::int64_t& cells, ThreadPool& pool) {
    Impl& s = *impl_;
    if (s.ground->open()) return true;
    const auto count = static_cast<std::int32_t>(s.places.size());
    for (std::int32_t j = 0; j < count; ++j)
        for (std::size_t k = 0; k < from.size() && !s.farRequests.active(j); ++k) s.requestFields(from[k], j);
    for (LocalCosts* local : {&s.fine, &s.middle}) {
        local->updateLandmarks(false);
        const std::int64_t most = std::min<std::int64_t>(s.scaledBudget(kPrefetchFactor * s.def.finePerStep),
                                                         std::max<std::int64_t>(0, cells) / kLocalCells);
        cells -= kLocalCells * local->solveRequested(static_cast<std::int32_t>(most), pool);
        local->updateLandmarks(false);
    }
    const std::int64_t each = s.far.cellsOfField();
    const auto most = static_cast<std::int32_t>(std::clamp<std::int64_t>(cells / each, 0, 1000));
    if (thorough || s.step % kUnknownPeriod == 0) s.requestFarWhereUnknown(from);
    s.updateFarStencils(true);
    const std::int32_t solved = s.solveFar(most, pool);
    cells -= solved * each;
    const bool whole = s.goesByRoutes(*s.ground, s.places.size()) || solved < most;
    s.updateFarStencils(true);
    return whole;
}

void Geodesics::retainFields(std::span<const SteeringTarget> targets) {
    for (const SteeringTarget& target : targets)
        if (target.place >= 0 && target.landmark >= 0 && !target.inSight)
            impl_->fine.fields().retain(target.landmark);
}

void Geodesics::save(Writer& archive) const {
    impl_->visit(archive);
}

bool Geodesics::load(Reader& archive) {
    impl_->visit(archive);
    return archive.ok();
}

void Geodesics::keepFieldsOf(Geodesics& before) {
    impl_->fine.keepFieldsOf(before.impl_->fine);
    impl_->middle.keepFieldsOf(before.impl_->middle);
    impl_->far.keepFieldsOf(before.impl_->far);
}

void Geodesics::bind(const StaticGround& ground) {
    impl_->fine.fields().bind(ground.fineLevel());
    impl_->middle.fields().bind(ground.middle());
    impl_->far.bind(ground);
}

void Geodesics::hash(Hasher& archive) const {
    impl_->visit(archive);
}

}  // namespace muster
