#include "muster/fields/geodesics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/between_centres.h"
#include "fields/far_fields.h"
#include "fields/near_windows.h"

namespace muster {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kFarAway = 20.0;           // Beyond this the far fields tell, whether the line is clear or not [m].
constexpr double kUnknown = 1.3;            // Ways of unknown length, as a multiple of the straight line.
constexpr std::uint8_t kRemembered = 60;    // Steps for which a place that was asked for keeps its stencils.
constexpr std::int32_t kMostCorners = 8;    // Of a way through a window.
constexpr std::int32_t kTraceSteps = 14;    // Along a far way, to a point in sight ahead...
constexpr double kTraceStep = 1.0;          // ... each so long [m].
constexpr std::int32_t kWindowSteps = 4;    // Of these, to the landmark of a window that leads round a corner near by.
constexpr std::int32_t kMostLost = 5;       // Points out of sight after which no more are looked at.
constexpr double kWorthAiming = 1.5;        // Points nearer than this are no aim [m].
constexpr double kTouching = 0.1;           // Room of one who walks along a wall [m].
constexpr std::int32_t kServes = 8;         // Steps for which what was found serves, and up to as many more.
constexpr double kReached = 0.6;            // [m]
constexpr double kLookAhead = 2.0;          // Of headings tried where it is crowded [m].
constexpr double kCrowded = 0.15;           // Excess of a metre ahead from which other headings are tried.
constexpr double kKeep = 0.05;              // A turn must save more [m of open ground].
// 25 and 50 degrees to either side.
constexpr Rotation kHeadings[] = {{0.90630778703664996, 0.42261826174069944}, {0.64278760968653933, 0.76604444311897804}};
constexpr std::uint32_t kFarPeriod = 8;     // Steps between two looks for the far landmarks of a place.

}  // namespace

struct Geodesics::Impl {
    GeodesicsDef def;
    const StaticGround* ground = nullptr;
    const CrowdExcess* excess = nullptr;
    std::vector<Vec2> places;
    std::vector<std::uint8_t> askedNear;  // Steps for which a place still wants windows.
    std::vector<std::uint8_t> askedFar;
    std::vector<LandmarkStencil> nearStencil;
    std::vector<LandmarkStencil> farStencil;
    NearWindows near;
    FarFields far;
    std::vector<std::uint8_t> farFound;   // The far stencil was looked for since the place was asked for.
    std::uint32_t step = 0;
    bool loaded = false;

    explicit Impl(const GeodesicsDef& d) : def(d), near(d.nearFields) {}

    template <class Archive>
    void visit(Archive& archive) {
        archive(places, askedNear, askedFar, farFound, farStencil, step, near, far);
        if constexpr (Archive::kReading) {
            const std::size_t n = places.size();
            if (askedNear.size() != n || askedFar.size() != n || farFound.size() != n || farStencil.size() != n) archive.fail();
            loaded = true;
        }
    }
    std::int32_t perStep(std::int32_t most) const {
        return std::max(most, static_cast<std::int32_t>(static_cast<std::int64_t>(most) * static_cast<std::int64_t>(places.size()) / 1000));
    }
    void ask(const std::vector<std::uint8_t>& asked, std::int32_t place) const {
        auto* flag = const_cast<std::uint8_t*>(&asked[static_cast<std::size_t>(place)]);
        __atomic_store_n(flag, kRemembered, __ATOMIC_RELAXED);
    }
    void tick(ThreadPool& pool);
    void findStencils(bool anew);
    bool looksFar(std::size_t place) const;
    double readingShift(Vec2 from, const Grid& grid) const;
    double nearCost(Vec2 from, std::int32_t place, double line) const;
    double nearCostFromMouth(const LandmarkStencil& stencil, Vec2 from) const;
    Vec2 nearDirection(const CostField& field, Vec2 from) const;
    double farCost(Vec2 from, std::int32_t place, double line) const;
    double excessAlong(const CostField& field, Vec2 from, Vec2 to) const;
    bool withinWindows(Vec2 from, Vec2 to) const;
    double bent(Vec2 from, std::int32_t place) const;
    double bent(Vec2 from, std::int32_t place, double nearBy) const;
    float costFrom(Vec2 from, std::int32_t place) const;
    WayAhead stillWay(Vec2 from, std::int32_t place, WayPoint& memory) const;
    Vec2 roundTheCrowd(Vec2 from, std::int32_t place, const WayAhead& way) const;
    bool farKnown(Vec2 from, std::int32_t place, float& cost) const;
    Vec2 farDirection(std::int32_t place, Vec2 from, WayPoint& memory) const;
    Vec2 alongWall(Vec2 from, Vec2 way) const;
    bool findPointAhead(const CostField& field, Vec2 from, WayPoint& memory) const;
};

Geodesics::Geodesics(const GeodesicsDef& def) : impl_(std::make_unique<Impl>(def)) {}
Geodesics::~Geodesics() = default;
Geodesics::Geodesics(Geodesics&&) noexcept = default;
Geodesics& Geodesics::operator=(Geodesics&&) noexcept = default;

void Geodesics::update(const StaticGround& ground, const CrowdExcess& excess, std::span<const Vec2> places,
                       ThreadPool& pool) {
    Impl& s = *impl_;
    s.ground = &ground;
    s.excess = &excess;
    s.places.assign(places.begin(), places.end());
    s.askedNear.resize(places.size(), 0);
    s.askedFar.resize(places.size(), 0);
    s.farFound.resize(places.size(), 0);
    s.nearStencil.resize(places.size());
    s.farStencil.resize(places.size());
    s.near.beginStep(ground);
    s.far.beginStep(ground, places.size());
    if (ground.plain()) return;
    if (s.loaded) {
        s.near.rebuild(pool);
        s.far.rebuild(pool);
        s.loaded = false;
    }
    s.tick(pool);
}

// Wishes of the last step are met as far as the budget goes; stencils follow from what there is.
void Geodesics::Impl::tick(ThreadPool& pool) {
    ++step;
    near.build(perStep(def.nearPerStep), pool);
    findStencils(far.build(def.farPerStep, pool));
}

// Places move little from step to step, so that far landmarks are looked for in turn.
bool Geodesics::Impl::looksFar(std::size_t place) const {
    return farFound[place] == 0 || (step + place) % kFarPeriod == 0;
}

void Geodesics::Impl::findStencils(bool anew) {
    for (std::size_t j = 0; j < places.size(); ++j) {
        nearStencil[j].count = 0;
        if (askedNear[j] > 0) {
            --askedNear[j];
            nearStencil[j] = near.stencil(places[j]);
        }
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

void Geodesics::survey(std::span<const Vec2> from, ThreadPool& pool) {
    Impl& s = *impl_;
    if (s.ground->plain()) return;
    for (std::size_t j = 0; j < s.places.size(); ++j)
        for (const Vec2 p : from) {
            const bool farAway = distance(p, s.places[j]) >= kFarAway;
            if (!farAway && s.ground->straight(p, s.places[j])) continue;
            (s.withinWindows(p, s.places[j]) ? s.askedNear[j] : s.askedFar[j]) = kRemembered;
            if (s.askedFar[j] > 0) break;
        }
    s.findStencils(true);
    s.near.build(s.perStep(4 * s.def.nearPerStep), pool);
    s.findStencils(true);
    // Where walls keep windows from telling, far fields have to.
    for (std::size_t j = 0; j < s.places.size(); ++j)
        if (s.askedNear[j] > 0)
            for (const Vec2 p : from)
                if (s.withinWindows(p, s.places[j])) s.bent(p, static_cast<std::int32_t>(j));
    s.findStencils(true);
    s.far.build(std::numeric_limits<std::int32_t>::max(), pool);
    s.findStencils(true);
}

bool Geodesics::Impl::withinWindows(Vec2 from, Vec2 to) const {
    const double reach = (NearWindows::kHalf - 4.5) * ground->fine().grid.cell;
    return std::fabs(from.x - to.x) < reach && std::fabs(from.y - to.y) < reach;
}

// Bilinear interpolation overrates squares by this much on uniform ground.
double Geodesics::Impl::readingShift(Vec2 from, const Grid& grid) const {
    const BetweenCentres at = betweenCentres(grid, from);
    const double unit = ground->unit(from) * grid.cell;
    return unit * unit * (at.fx * (1.0 - at.fx) + at.fy * (1.0 - at.fy));
}

// The excess along the corners of a way through the field, and on to the place.
double Geodesics::Impl::excessAlong(const CostField& field, Vec2 from, Vec2 to) const {
    if (excess->none()) return 0.0;
    Vec2 corners[kMostCorners];
    const std::int32_t count = field.corners(from, corners);
    double sum = 0.0;
    Vec2 at = from;
    for (std::int32_t k = 0; k < count; ++k) {
        sum += excess->along(at, corners[k]);
        at = corners[k];
    }
    return sum + excess->along(at, to);
}

double Geodesics::Impl::nearCost(Vec2 from, std::int32_t place, double line) const {
    const LandmarkStencil& stencil = nearStencil[place];
    if (stencil.count == 0) return kInfinite;
    const double square = near.square(stencil, from) - readingShift(from, ground->fine().grid);
    const double least = ground->fine().lowest * line;
    const double still = square < kInfinite ? std::sqrt(std::max(square, least * least)) : nearCostFromMouth(stencil, from);
    if (!(still < kInfinite)) return kInfinite;
    return still + ground->unit(from) * excessAlong(near.field(stencil.nearest), from, places[place]);
}

// Whoever stands in a door too narrow for the cells to show it goes by the free cell beside it.
double Geodesics::Impl::nearCostFromMouth(const LandmarkStencil& stencil, Vec2 from) const {
    const Grid& grid = ground->fine().grid;
    const std::int32_t cell = ground->blocked(grid.index(grid.nearestCell(from))) ? ground->freeCellNear(from) : -1;
    if (cell < 0) return kInfinite;
    const Vec2 out = grid.centre(grid.at(cell));
    const double square = near.square(stencil, out);
    return square < kInfinite ? std::sqrt(std::max(0.0, square)) + ground->unit(out) * distance(from, out) : kInfinite;
}

Vec2 Geodesics::Impl::nearDirection(const CostField& field, Vec2 from) const {
    const Grid& grid = ground->fine().grid;
    const std::int32_t cell = field.squareBetween(from) < kInfinite ? -1 : ground->freeCellNear(from);
    return cell >= 0 ? normalized(grid.centre(grid.at(cell)) - from) : field.direction(from);
}

double Geodesics::Impl::farCost(Vec2 from, std::int32_t place, double line) const {
    const LandmarkStencil& stencil = farStencil[place];
    if (stencil.count == 0) return kInfinite;
    const double square = far.square(stencil, from) - readingShift(from, ground->coarse().grid);
    if (!(square < kInfinite)) return kInfinite;
    const double least = ground->fine().lowest * line;
    return std::sqrt(std::max(square, least * least));
}

double Geodesics::Impl::bent(Vec2 from, std::int32_t place) const {
    const Vec2 to = places[place];
    return bent(from, place, withinWindows(from, to) ? nearCost(from, place, distance(from, to)) : kInfinite);
}

// `nearBy` is the cost by the windows, infinite where they tell none.
double Geodesics::Impl::bent(Vec2 from, std::int32_t place, double nearBy) const {
    const Vec2 to = places[place];
    const double line = distance(from, to);
    if (withinWindows(from, to)) ask(askedNear, place);
    if (nearBy < kInfinite) return nearBy;
    ask(askedFar, place);
    const double cost = farCost(from, place, line);
    return cost < kInfinite ? cost : kUnknown * ground->unit(from) * line;
}

// Over long ways far fields are cheaper to ask than whether the line is clear, and where it is they say the same.
bool Geodesics::Impl::farKnown(Vec2 from, std::int32_t place, float& cost) const {
    if (ground->plain()) return false;
    const double line = distance(from, places[place]);
    if (line < kFarAway) return false;
    ask(askedFar, place);
    const double there = farCost(from, place, line);
    cost = static_cast<float>(there);
    return there < kInfinite;
}

bool Geodesics::straight(Vec2 from, std::int32_t place) const { return impl_->ground->straight(from, impl_->places[place]); }

float Geodesics::cost(Vec2 from, std::int32_t place) const { return impl_->costFrom(from, place); }

float Geodesics::Impl::costFrom(Vec2 from, std::int32_t place) const {
    const Vec2 to = places[place];
    float known = 0.0f;
    if (farKnown(from, place, known)) return known;
    if (ground->straight(from, to))
        return static_cast<float>(ground->unit(to) * (distance(from, to) + excess->along(from, to)));
    return static_cast<float>(bent(from, place));
}

// Goes down the field; notes the last point of the way in sight, and the landmark of a window some metres on.
bool Geodesics::Impl::findPointAhead(const CostField& field, Vec2 from, WayPoint& memory) const {
    Vec2 at = from;
    bool found = false;
    std::int32_t lost = 0;
    memory.window = -1;
    for (std::int32_t k = 0; k < kTraceSteps && lost < kMostLost; ++k) {
        const Vec2 onward = field.direction(at);
        if (onward == Vec2{}) break;
        at += onward * kTraceStep;
        if (k < kWindowSteps) memory.window = near.landmarkNear(at, memory.window);
        if (ground->straight(from, at)) {
            memory.point = at;
            found = distance(from, at) > kWorthAiming;
            lost = 0;
        } else {
            ++lost;
        }
    }
    return found;
}

// To a point in sight on the way down the field of the nearest landmark. Where there is none, the way is bent near by:
// down the window of a landmark some metres on.
Vec2 Geodesics::Impl::farDirection(std::int32_t place, Vec2 from, WayPoint& memory) const {
    const CostField& field = far.field(farStencil[place].nearest);
    const bool aims = memory.inSight && distance(from, memory.point) > kReached && ground->straight(from, memory.point);
    if (memory.steps <= 0 || (memory.inSight && !aims)) {
        memory.inSight = findPointAhead(field, from, memory);
        // Not for all equally long, so that not all look again in one step.
        memory.steps = kServes + place % kServes;
    }
    --memory.steps;
    if (memory.inSight) return normalized(memory.point - from);
    const std::int32_t slot = memory.window >= 0 ? near.slotOf(memory.window) : -1;
    const Vec2 way = slot >= 0 ? near.field(slot).direction(from) : Vec2{};
    return way == Vec2{} ? alongWall(from, field.direction(from)) : way;
}

// The coarse field may lead into a wall: along it then.
Vec2 Geodesics::Impl::alongWall(Vec2 from, Vec2 way) const {
    if (ground->roomBetween(from) > kTouching) return way;
    const double edge = ground->fine().grid.cell;
    const Vec2 rise{ground->roomBetween(from + Vec2{edge, 0.0}) - ground->roomBetween(from - Vec2{edge, 0.0}),
                    ground->roomBetween(from + Vec2{0.0, edge}) - ground->roomBetween(from - Vec2{0.0, edge})};
    const Vec2 out = normalized(rise);
    const double into = dot(way, out);
    return into < 0.0 ? normalized(way - out * into, way) : way;
}

void Geodesics::remember(std::span<const WayPoint> walkers) {
    for (const WayPoint& walker : walkers)
        if (walker.place >= 0 && walker.window >= 0 && !walker.inSight) impl_->near.keep(walker.window);
}

WayAhead Geodesics::ahead(Vec2 from, std::int32_t place, WayPoint& memory) const {
    WayAhead way = impl_->stillWay(from, place, memory);
    way.direction = impl_->roundTheCrowd(from, place, way);
    return way;
}

// Where the crowd ahead is dense, the best of a few headings: what the first metres cost in it, and the way on from there.
Vec2 Geodesics::Impl::roundTheCrowd(Vec2 from, std::int32_t place, const WayAhead& way) const {
    if (excess->none() || way.direction == Vec2{} || way.cost < 2.0 * kLookAhead) return way.direction;
    const double unit = ground->unit(from);
    const auto costBy = [&](Vec2 heading) {
        const Vec2 next = from + heading * kLookAhead;
        if (!ground->straight(from, next)) return kInfinite;
        return unit * (kLookAhead + excess->along(from, next)) + costFrom(next, place);
    };
    if (excess->along(from, from + way.direction * kLookAhead) < kCrowded * kLookAhead) return way.direction;
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

WayAhead Geodesics::Impl::stillWay(Vec2 from, std::int32_t place, WayPoint& memory) const {
    const Impl& s = *this;
    const Vec2 to = s.places[place];
    const double line = distance(from, to);
    if (memory.place != place) memory = {from, place, 0, -1, false};
    WayAhead way;
    if (s.farKnown(from, place, way.cost)) {
        way.direction = s.farDirection(place, from, memory);
        return way;
    }
    if (s.ground->straight(from, to))
        return {normalized(to - from), static_cast<float>(s.ground->unit(to) * (line + s.excess->along(from, to)))};
    const double nearBy = s.withinWindows(from, to) ? s.nearCost(from, place, line) : kInfinite;
    way.cost = static_cast<float>(s.bent(from, place, nearBy));
    if (nearBy < kInfinite) {
        const CostField& field = s.near.field(s.nearStencil[place].nearest);
        // Beside the landmark the way to it says nothing of the way to the place.
        const bool beside = distance(from, field.source()) < 1.5 * distance(field.source(), to);
        way.direction = beside ? normalized(to - from) : nearDirection(field, from);
    } else if (s.farStencil[place].count > 0) {
        way.direction = s.farDirection(place, from, memory);
    }
    return way;
}

void Geodesics::save(Writer& archive) const { impl_->visit(archive); }

bool Geodesics::load(Reader& archive) {
    impl_->visit(archive);
    return archive.ok();
}

void Geodesics::hash(Hasher& archive) const { impl_->visit(archive); }

}  // namespace muster
