#include "geodesics/geodesics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geodesics/asked.h"
#include "geodesics/crowd_detour.h"
#include "geodesics/far_fields.h"
#include "geodesics/slow_way.h"
#include "geodesics/window_costs.h"

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
// Beyond this the far fields tell, whether the line is clear or not [m].
constexpr double kFarAway = 20.0;
constexpr double kUnknown = 1.3;  // Ways of unknown length, as a multiple of the straight line.
// Times the straight line's cost: a detour that may be cheaper outside a window.
constexpr double kDetour = 1.6;
constexpr double kOverSlow = 8.0;  // Ways over slow ground that are looked at directly [m]...
// ... and from which there may be one round it outside all windows.
constexpr double kShortLine = 5.0;
constexpr double kNearEnds = 3.0;           // Of a long way, from its ends [m].
constexpr double kMuchLess = 0.6;           // Far fields are off by up to a tenth there.
constexpr std::size_t kFewPlaces = 500;     // Below, one field is made in a step...
constexpr std::int64_t kManyPlaces = 2500;  // ... below, two; above, more windows.
constexpr std::int32_t kNearHalf = 16;      // Cells from the middle of a window to its rim...
constexpr std::int32_t kMiddleHalf = 18;    // ... and of one on cells twice as wide.
constexpr std::int32_t kTraceSteps = 10;    // Along a far way, to a point in sight ahead...
constexpr double kTraceStep = 1.0;          // ... each so long [m].
// Of these, to the landmark of a window that leads round a corner near by.
constexpr std::int32_t kWindowSteps = 3;
// Times as many windows are made before a first plan as in a step.
constexpr std::int32_t kSurveyed = 16;
constexpr std::int32_t kMostLost = 5;  // Points out of sight after which no more are looked at.
constexpr double kWorthAiming = 0.9;   // Points nearer than this are no aim [m].
constexpr double kTouching = 0.1;      // Room of one who walks along a wall [m].
constexpr std::uint32_t kServes = 8;   // Steps for which what was found serves, and up to as many more.
// Of these one in so many looks whether the point is in sight still.
constexpr std::int32_t kLooks = 4;
constexpr double kReached = 0.6;    // [m]
constexpr double kLookAhead = 2.0;  // Of headings tried where it is crowded [m].
constexpr double kCrowded = 0.05;   // Excess of a metre ahead from which other headings are tried.
constexpr double kKeep = 0.02;      // A turn must save more [m of open ground].
// 25, 50 and 75 degrees to either side.
constexpr Rotation kHeadings[] = {{0.90630778703664996, 0.42261826174069944},
                                  {0.64278760968653933, 0.76604444311897804},
                                  {0.25881904510252074, 0.96592582628906831}};
// 3, 6 and 12 degrees to either side.
constexpr Rotation kAside[] = {{0.99862953475457383, 0.05233595624294383},
                               {0.99452189536827329, 0.10452846326765347},
                               {0.97814760073380569, 0.20791169081775934}};
constexpr std::uint32_t kFarPeriod = 8;  // Steps between two looks for the far landmarks of a place.

}  // namespace

struct Geodesics::Impl {
    /// A cost, and by what it is known.
    struct Bent {
        double cost;
        enum { Near, Middle, Far, Line, Unknown } by;
        Vec2 aim{};  ///< Where by Line.
    };

    GeodesicsDef def;
    const StaticGround* ground = nullptr;
    const DynamicCost* excess = nullptr;
    std::vector<Vec2> places;
    WindowCosts near;                    // A few metres round places, on the ground cells.
    WindowCosts middle;                  // Some more, on cells twice as wide.
    std::vector<std::uint8_t> askedFar;  // Steps for which a place still wants far fields.
    std::vector<LandmarkStencil> farStencil;
    FarFields far;
    std::vector<std::uint8_t> farFound;  // The far stencil was looked for since the place was asked for.
    std::uint32_t step = 0;
    bool loaded = false;

    explicit Impl(const GeodesicsDef& d)
        : def(d), near({d.fineFields, kNearHalf}), middle({d.middleFields, kMiddleHalf}) {}

    template <class Archive>
    void visit(Archive& archive) {
        archive(places, askedFar, farFound, farStencil, step, near, middle, far);
        if constexpr (Archive::kReading) {
            const std::size_t n = places.size();
            if (near.places() != n || middle.places() != n || askedFar.size() != n || farFound.size() != n ||
                farStencil.size() != n)
                archive.fail();
            loaded = true;
        }
    }
    std::int32_t perStep(std::int32_t most) const {
        return std::max(
            most, static_cast<std::int32_t>(most * static_cast<std::int64_t>(places.size()) / kManyPlaces));
    }
    void askFar(std::int32_t place) const { noteAsked(askedFar, place); }
    // A number that differs from place to place and from step to step.
    std::uint32_t mixed(std::int32_t place) const {
        return ((static_cast<std::uint32_t>(place) * 977u + step) * 2654435761u) >> 16;
    }
    void tick(ThreadPool& pool);
    bool makeFields(ThreadPool& pool);
    void findFarStencils(bool anew);
    bool looksFar(std::size_t place) const;
    void askFor(Vec2 from, std::int32_t place);
    double farCost(Vec2 from, std::int32_t place, double line) const;
    Bent bent(Vec2 from, std::int32_t place, bool owner, double line) const;
    double excessAtEnds(Vec2 from, Vec2 to, double line) const;
    Bent roundOutside(Bent inside, Vec2 from, std::int32_t place) const;
    Bent overSlow(Vec2 from, std::int32_t place, double line) const;
    Bent byWindows(Vec2 from, std::int32_t place, bool owner, double line) const;
    float straightCost(Vec2 from, Vec2 to, double line) const;
    float costFrom(Vec2 from, std::int32_t place) const;
    Guidance stillWay(Vec2 from, std::int32_t place, SteeringTarget& memory) const;
    Vec2 roundTheCrowd(Vec2 from, std::int32_t place, const Guidance& way) const;
    bool farKnown(Vec2 from, std::int32_t place, double line, float& cost) const;
    Vec2 longDirection(const CostField& field, std::int32_t place, Vec2 from, SteeringTarget& memory) const;
    Vec2 alongWall(Vec2 from, Vec2 way) const;
    Vec2 towardsPlace(Vec2 from, std::int32_t place, Vec2 aim) const;
    bool findPointAhead(const CostField& field, Vec2 from, SteeringTarget& memory) const;
};

Geodesics::Geodesics(const GeodesicsDef& def) : impl_(std::make_unique<Impl>(def)) {}
Geodesics::~Geodesics() = default;
Geodesics::Geodesics(Geodesics&&) noexcept = default;
Geodesics& Geodesics::operator=(Geodesics&&) noexcept = default;

void Geodesics::reserve(const StaticGround& ground, std::size_t places) {
    if (ground.open()) return;
    impl_->near.windows().reserve(places);
    impl_->middle.windows().reserve(places);
}

void Geodesics::update(const StaticGround& ground, const DynamicCost& excess, std::span<const Vec2> places,
                       ThreadPool& pool) {
    Impl& s = *impl_;
    s.ground = &ground;
    s.excess = &excess;
    s.places.assign(places.begin(), places.end());
    s.askedFar.resize(places.size(), 0);
    s.farFound.resize(places.size(), 0);
    s.farStencil.resize(places.size());
    s.near.beginStep(ground, ground.fineLevel(), excess, s.places);
    s.middle.beginStep(ground, ground.middle(), excess, s.places);
    s.far.beginStep(ground, places.size());
    if (ground.open()) return;
    if (s.loaded) {
        s.near.rebuild(pool);
        s.middle.rebuild(pool);
        s.far.rebuild(pool);
        s.loaded = false;
    }
    s.tick(pool);
}

// True where a far one was made. A field takes a good part of a small crowd's step: few are made in one then,
// of whatever kind, in every other step from the farthest.
bool Geodesics::Impl::makeFields(ThreadPool& pool) {
    if (places.size() >= static_cast<std::size_t>(kManyPlaces)) {
        near.build(perStep(def.finePerStep), pool);
        middle.build(perStep(def.middlePerStep), pool);
        return far.build(def.farPerStep, pool) > 0;
    }
    std::int32_t left = places.size() < kFewPlaces ? 1 : def.finePerStep;
    if (step % 2 == 0) {
        left -= near.build(left, pool);
        left -= middle.build(left, pool);
        return far.build(left, pool) > 0;
    }
    const std::int32_t made = far.build(std::min(left, def.farPerStep), pool);
    left -= made;
    left -= middle.build(std::min(left, def.middlePerStep), pool);
    near.build(left, pool);
    return made > 0;
}

// Wishes of the last step are met as far as the budget goes; stencils follow from what there is.
void Geodesics::Impl::tick(ThreadPool& pool) {
    ++step;
    const bool farther = makeFields(pool);
    near.findStencils(true);
    middle.findStencils(true);
    findFarStencils(farther);
}

// Places move little from step to step, so that far landmarks are looked for in turn.
bool Geodesics::Impl::looksFar(std::size_t place) const {
    return farFound[place] == 0 || (step + place) % kFarPeriod == 0;
}

void Geodesics::Impl::findFarStencils(bool anew) {
    for (std::size_t j = 0; j < places.size(); ++j) {
        if (askedFar[j] == 0) {
            farFound[j] = 0;
            farStencil[j].count = 0;
            continue;
        }
        --askedFar[j];
        if (!anew && !looksFar(j)) continue;
        farStencil[j] = far.stencil(places[j]);
        farFound[j] = 1;
    }
}

// Notes what could tell the cost.
void Geodesics::Impl::askFor(Vec2 from, std::int32_t place) {
    const bool farAway = distance(from, places[place]) >= kFarAway;
    if (!farAway && ground->lineOfSight(from, places[place])) return;
    if (near.reaches(from, place))
        near.ask(place, false);
    else if (middle.reaches(from, place))
        middle.ask(place, false);
    else
        askFar(place);
}

void Geodesics::prefetch(std::span<const Vec2> from, ThreadPool& pool) {
    Impl& s = *impl_;
    if (s.ground->open()) return;
    const auto count = static_cast<std::int32_t>(s.places.size());
    for (std::int32_t j = 0; j < count; ++j)
        for (std::size_t k = 0; k < from.size() && s.askedFar[j] == 0; ++k) s.askFor(from[k], j);
    for (WindowCosts* windows : {&s.near, &s.middle}) {
        windows->findStencils(false);
        windows->build(s.perStep(kSurveyed * s.def.finePerStep), pool);
        windows->findStencils(false);
    }
    // Where walls keep windows from telling, or there are none yet, far fields have to.
    for (std::int32_t j = 0; j < count; ++j)
        if (s.near.asked(j) || s.middle.asked(j))
            for (const Vec2 p : from)
                if (s.middle.reaches(p, j) &&
                    s.bent(p, j, false, distance(p, s.places[j])).by == Impl::Bent::Unknown)
                    s.askFar(j);
    s.findFarStencils(true);
    s.far.build(std::numeric_limits<std::int32_t>::max(), pool);
    s.findFarStencils(true);
}

double Geodesics::Impl::farCost(Vec2 from, std::int32_t place, double line) const {
    const LandmarkStencil& stencil = farStencil[place];
    if (stencil.count == 0) return kInfinite;
    const double square = far.square(stencil, from) -
                          readingShift(ground->coarse().grid, from, ground->unitCost(from));
    if (!(square < kInfinite)) return kInfinite;
    const double least = ground->fine().lowest * line;
    return std::sqrt(std::max(square, least * least));
}

// Windows know no way that leaves them. Through slow ground there may be one that is much longer than the
// best: where far fields know a cheaper one, that.
Geodesics::Impl::Bent Geodesics::Impl::roundOutside(Bent inside, Vec2 from, std::int32_t place) const {
    const Vec2 to = places[place];
    const double line = distance(from, to);
    // Far fields say little of short ways, for which windows are made.
    if (ground->uniform() || (inside.by == Bent::Line && line < kShortLine)) return inside;
    const double straight = inside.by == Bent::Line ? ground->fine().lowest * line
                                                    : ground->lineCost(from, to);
    if (inside.cost <= kDetour * straight) return inside;
    askFar(place);
    const double cost = farCost(from, place, line);
    return cost < kMuchLess * inside.cost ? Bent{cost, Bent::Far} : inside;
}

// Straight over slow ground and out of it, or bent where it changes, where no wall is in the way; else
// unknown.
Geodesics::Impl::Bent Geodesics::Impl::overSlow(Vec2 from, std::int32_t place, double line) const {
    const Vec2 to = places[place];
    if (ground->uniform() || line > kOverSlow || !ground->collisionFree(from, to))
        return {kInfinite, Bent::Unknown};
    const SlowWay way = slowWay(*ground, from, to);
    double more = excessBetween(*ground, *excess, from, way.aim);
    if (!(way.aim == to)) more += excessBetween(*ground, *excess, way.aim, to);
    return {way.cost + more, Bent::Line, way.aim};
}

Geodesics::Impl::Bent Geodesics::Impl::bent(Vec2 from, std::int32_t place, bool owner, double line) const {
    const Bent direct = overSlow(from, place, line);
    // Into slow ground or out of it that is the way; within it another way may lead out and in again.
    if (direct.by == Bent::Line && ground->unitCost(from) != ground->unitCost(places[place]))
        return roundOutside(direct, from, place);
    const Bent found = byWindows(from, place, owner, line);
    const bool better = direct.cost < found.cost || found.by == Bent::Far || found.by == Bent::Unknown;
    return direct.by == Bent::Line && better ? roundOutside(direct, from, place) : found;
}

// Of a long way whose course is not known: what moving things add where it begins and where it ends, as if it
// led straight there.
double Geodesics::Impl::excessAtEnds(Vec2 from, Vec2 to, double line) const {
    const double part = std::min(1.0, kNearEnds / line);
    const auto standsIn = [&](Vec2 end, Vec2 onward) {
        const Vec2 until = lerp(end, onward, part);
        return excess->movingCostCentroid(end, until, distance(end, until)) >= 0.0;
    };
    double sum = 0.0;
    if (standsIn(from, to)) sum += excessBetween(*ground, *excess, from, lerp(from, to, part));
    if (part < 1.0 && standsIn(to, from)) sum += excessBetween(*ground, *excess, lerp(to, from, part), to);
    return sum;
}

// The finest windows that reach so far; coarser ones where those do not know the way.
Geodesics::Impl::Bent Geodesics::Impl::byWindows(Vec2 from, std::int32_t place, bool owner,
                                                 double line) const {
    bool missing = false;  // Windows that will tell.
    if (near.reaches(from, place)) {
        near.ask(place, owner);
        const double cost = near.cost(from, place, line);
        if (cost < kInfinite) return roundOutside({cost, Bent::Near}, from, place);
        missing = !near.known(place);
    }
    if (middle.reaches(from, place)) {
        if (!missing) middle.ask(place, owner);
        const double cost = middle.cost(from, place, line);
        if (cost < kInfinite) return roundOutside({cost, Bent::Middle}, from, place);
        missing = missing || !middle.known(place);
    }
    // On even ground the line tells enough until then.
    if (!missing || !ground->uniform()) askFar(place);
    const double cost = farCost(from, place, line);
    const double more = excessAtEnds(from, places[place], line);
    if (cost < kInfinite) return {cost + more, Bent::Far};
    return {kUnknown * ground->lineCost(from, places[place]) + more, Bent::Unknown};
}

// Over long ways far fields are cheaper to ask than whether the line is clear, and where it is they say the
// same.
bool Geodesics::Impl::farKnown(Vec2 from, std::int32_t place, double line, float& cost) const {
    if (line < kFarAway || ground->open()) return false;
    askFar(place);
    const double there = farCost(from, place, line);
    cost = static_cast<float>(there);
    return there < kInfinite;
}

bool Geodesics::lineOfSight(Vec2 from, std::int32_t place) const {
    return impl_->ground->lineOfSight(from, impl_->places[place]);
}

double Geodesics::leastUnitCost() const {
    return impl_->ground->fine().lowest;
}

// Whoever comes out of a disc of slow ground crosses its radius.
double Geodesics::lowerBound(Vec2 from, std::int32_t place) const {
    const StaticGround& ground = *impl_->ground;
    const Vec2 to = impl_->places[place];
    const double line = distance(from, to);
    const double lowest = ground.fine().lowest;
    if (ground.uniform()) return lowest * line;
    const double before = std::clamp(ground.uniformClearance(from), 0.0, line);
    const double after = std::clamp(ground.uniformClearance(to), 0.0, line - before);
    return lowest * line + (ground.unitCost(from) - lowest) * before + (ground.unitCost(to) - lowest) * after;
}

bool Geodesics::hasMovingCost(Vec2 p) const {
    return impl_->excess->hasMovingCost(p);
}

float Geodesics::cost(Vec2 from, std::int32_t place) const {
    return impl_->costFrom(from, place);
}

float Geodesics::Impl::straightCost(Vec2 from, Vec2 to, double line) const {
    return static_cast<float>(ground->unitCost(to) * line + excessBetween(*ground, *excess, from, to, line));
}

float Geodesics::Impl::costFrom(Vec2 from, std::int32_t place) const {
    const Vec2 to = places[place];
    const double line = distance(from, to);
    float known = 0.0f;
    if (farKnown(from, place, line, known)) return known;
    if (ground->lineOfSight(from, to, line)) return straightCost(from, to, line);
    return static_cast<float>(bent(from, place, false, line).cost);
}

// Goes down the field; notes the last point of the way in sight, and the landmark of a window some metres on.
bool Geodesics::Impl::findPointAhead(const CostField& field, Vec2 from, SteeringTarget& memory) const {
    Vec2 at = from;
    bool found = false;
    std::int32_t lost = 0;
    memory.landmark = -1;
    for (std::int32_t k = 0; k < kTraceSteps && lost < kMostLost; ++k) {
        const Vec2 onward = field.direction(at);
        if (onward == Vec2{}) break;
        at += onward * kTraceStep;
        if (k < kWindowSteps) memory.landmark = near.windows().landmarkNear(at, memory.landmark);
        if (ground->lineOfSight(from, at)) {
            memory.point = at;
            found = distance(from, at) > kWorthAiming;
            lost = 0;
        } else {
            ++lost;
        }
    }
    return found;
}

// Ways down a landmark's field end at the landmark: of points as far off to both sides the one from which it
// is nearest to the place itself.
Vec2 Geodesics::Impl::towardsPlace(Vec2 from, std::int32_t place, Vec2 aim) const {
    const auto lengthBy = [&](Vec2 p) { return farCost(p, place, distance(p, places[place])); };
    Vec2 best = aim;
    double least = lengthBy(aim);
    for (const Rotation& turn : kAside)
        for (const Vec2 p : {from + turn.apply(aim - from), from + turn.applyInverse(aim - from)}) {
            const double length = lengthBy(p);
            if (!(length < least) || !ground->lineOfSight(from, p)) continue;
            least = length;
            best = p;
        }
    return best;
}

// To a point in sight on the way down a field of a landmark of the place. Where there is none, the way is
// bent near by: down the window of a landmark some metres on.
Vec2 Geodesics::Impl::longDirection(const CostField& field, std::int32_t place, Vec2 from,
                                    SteeringTarget& memory) const {
    // Who walks towards a point keeps it in sight, unless pushed aside.
    const bool looks = memory.steps % kLooks == 0;
    const bool aims = memory.inSight && distance(from, memory.point) > kReached &&
                      (!looks || ground->lineOfSight(from, memory.point));
    if (memory.steps <= 0 || (memory.inSight && !aims)) {
        memory.inSight = findPointAhead(field, from, memory);
        if (memory.inSight && farStencil[place].count > 0)
            memory.point = towardsPlace(from, place, memory.point);
        // Not for all equally long, nor always, so that not all look again in one step.
        memory.steps = kServes + static_cast<std::int32_t>(mixed(place) % kServes);
    }
    --memory.steps;
    if (memory.inSight) return normalized(memory.point - from);
    const std::int32_t slot = memory.landmark >= 0 ? near.windows().slotOf(memory.landmark) : -1;
    const Vec2 way = slot >= 0 ? near.windows().field(slot).direction(from) : Vec2{};
    return way == Vec2{} ? alongWall(from, field.direction(from)) : way;
}

// The coarse field may lead into a wall: along it then.
Vec2 Geodesics::Impl::alongWall(Vec2 from, Vec2 way) const {
    if (ground->interpolatedClearance(from) > kTouching) return way;
    const double edge = ground->fine().grid.cell;
    const Vec2 rise{ground->interpolatedClearance(from + Vec2{edge, 0.0}) -
                        ground->interpolatedClearance(from - Vec2{edge, 0.0}),
                    ground->interpolatedClearance(from + Vec2{0.0, edge}) -
                        ground->interpolatedClearance(from - Vec2{0.0, edge})};
    const Vec2 out = normalized(rise);
    const double into = dot(way, out);
    return into < 0.0 ? normalized(way - out * into, perpendicular(out)) : way;
}

void Geodesics::retainFields(std::span<const SteeringTarget> walkers) {
    for (const SteeringTarget& walker : walkers)
        if (walker.place >= 0 && walker.landmark >= 0 && !walker.inSight)
            impl_->near.windows().keep(walker.landmark);
}

Guidance Geodesics::guidance(Vec2 from, std::int32_t place, SteeringTarget& memory) const {
    Guidance way = impl_->stillWay(from, place, memory);
    way.direction = impl_->roundTheCrowd(from, place, way);
    return way;
}

// Where the crowd ahead is dense, the best of a few headings: what the first metres cost in it, and the way
// on from there.
Vec2 Geodesics::Impl::roundTheCrowd(Vec2 from, std::int32_t place, const Guidance& way) const {
    if (excess->empty() || way.direction == Vec2{} || way.cost < 2.0 * kLookAhead) return way.direction;
    const double unit = ground->unitCost(from);
    const auto costBy = [&](Vec2 heading) {
        const Vec2 next = from + heading * kLookAhead;
        if (!ground->lineOfSight(from, next)) return kInfinite;
        return unit * (kLookAhead + excess->relativeAlong(from, next)) + costFrom(next, place);
    };
    if (excess->relativeAlong(from, from + way.direction * kLookAhead) < kCrowded * kLookAhead)
        return way.direction;
    Vec2 best = way.direction;
    double least = costBy(best) - kKeep;
    for (const Rotation& turn : kHeadings)
        for (const Vec2 heading : {turn.apply(way.direction), turn.applyInverse(way.direction)}) {
            const double cost = costBy(heading);
            if (!(cost < least)) continue;
            least = cost;
            best = heading;
        }
    return best;
}

Guidance Geodesics::Impl::stillWay(Vec2 from, std::int32_t place, SteeringTarget& memory) const {
    const Vec2 to = places[place];
    // Where many get other places at once not all look for a point in one step: the field itself leads them
    // until then.
    if (memory.place != place)
        memory = {from, place, static_cast<std::int32_t>(mixed(place) % kServes), -1, false};
    const double line = distance(from, to);
    const auto farField = [&]() -> const CostField& { return far.field(farStencil[place].nearest); };
    Guidance way;
    if (farKnown(from, place, line, way.cost)) {
        way.direction = longDirection(farField(), place, from, memory);
        return way;
    }
    if (ground->lineOfSight(from, to, line)) return {normalized(to - from), straightCost(from, to, line)};
    const Bent found = bent(from, place, true, line);
    way.cost = static_cast<float>(found.cost);
    if (found.by == Bent::Line) way.direction = normalized(found.aim - from);
    if (found.by == Bent::Near) way.direction = near.direction(from, place);
    if (found.by == Bent::Middle) way.direction = longDirection(middle.field(place), place, from, memory);
    if (found.by == Bent::Far) way.direction = longDirection(farField(), place, from, memory);
    if (found.by == Bent::Unknown) {
        // Somebody waits for this: what tells sooner will do.
        askFar(place);
        way.direction = alongWall(from, normalized(to - from));
    }
    return way;
}

void Geodesics::save(Writer& archive) const {
    impl_->visit(archive);
}

bool Geodesics::load(Reader& archive) {
    impl_->visit(archive);
    return archive.ok();
}

void Geodesics::hash(Hasher& archive) const {
    impl_->visit(archive);
}

}  // namespace muster
