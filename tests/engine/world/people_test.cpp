// Sorts of persons: distributions against known values and by integration, and who is drawn for a group.
#include "muster/people.h"

#include <doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <vector>

#include "engine/state/draw_person.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr double kEverywhere = 1e9;

double relativeError(double found, double expected) {
    return std::fabs(found - expected) / std::max(std::fabs(expected), 1e-300);
}

// The density of a distribution but for its scale, by libm.
double density(const Distribution& d, double x) {
    const auto bell = [&](double y) { return std::exp(-0.5 * (y - d.a) * (y - d.a) / (d.b * d.b)); };
    switch (d.spread) {
        case Spread::Uniform:
            return x >= d.a && x <= d.b ? 1.0 : 0.0;
        case Spread::Normal:
            return bell(x);
        case Spread::LogNormal:
            return x > 0.0 ? bell(std::log(x)) / x : 0.0;
        case Spread::Gamma:
            return x > 0.0 ? std::pow(x / d.b, d.a - 1.0) * std::exp(-x / d.b) : 0.0;
        case Spread::Weibull:
            return x > 0.0 ? std::pow(x / d.a, d.b - 1.0) * std::exp(-std::pow(x / d.a, d.b)) : 0.0;
        default:
            return 0.0;
    }
}

// The integral of the density over an interval (Simpson).
double mass(const Distribution& d, double from, double to) {
    constexpr int kParts = 20000;
    const double h = (to - from) / kParts;
    double sum = density(d, from) + density(d, to);
    for (int k = 1; k < kParts; ++k) sum += density(d, from + k * h) * (k % 2 == 0 ? 2.0 : 4.0);
    return sum * h / 3.0;
}

// The value at which a sample's share differs most from the distribution's (Kolmogorov and Smirnov), times
// the root of their number: above 1.63 in one of 100 samples.
double misfit(std::vector<double> sample, const Distribution& d) {
    std::sort(sample.begin(), sample.end());
    const auto n = static_cast<double>(sample.size());
    double worst = 0.0;
    for (std::size_t k = 0; k < sample.size(); ++k) {
        double low = 0.0, high = 1.0;  // The share below it, by bisection of the quantile.
        for (int step = 0; step < 50; ++step) {
            const double middle = 0.5 * (low + high);
            (d.quantile(middle) < sample[k] ? low : high) = middle;
        }
        worst = std::max({worst, std::fabs(low - static_cast<double>(k) / n),
                          std::fabs(low - static_cast<double>(k + 1) / n)});
    }
    return worst * std::sqrt(n);
}

// A group in which sorts are told by their class, on an open floor.
WorldDef crowdOf(std::int32_t count, std::vector<PeopleDef> people, std::uint64_t seed = 1) {
    WorldDef def;
    const double half = 2.0 * std::sqrt(static_cast<double>(count)) + 10.0;
    def.box = {{-half, -half}, {half, half}};
    def.seed = seed;
    def.groups.push_back({.count = count, .people = std::move(people)});
    return def;
}

PeopleDef sortOf(std::uint8_t unitClass, double share) {
    return {.share = share, .unitClass = unitClass};
}

std::vector<Body> bodiesOf(const World& world) {
    return copyOf(world.characters().body);
}

std::array<int, 8> classesOf(std::span<const Body> bodies) {
    std::array<int, 8> counts{};
    for (const Body& body : bodies) ++counts[body.unitClass];
    return counts;
}

std::vector<double> valuesOf(const std::vector<Body>& bodies, double Body::*number) {
    std::vector<double> values;
    for (const Body& body : bodies) values.push_back(body.*number);
    return values;
}

}  // namespace

TEST_CASE("quantiles are those of 30 digits of arithmetic") {
    struct Known {
        Distribution drawn;
        double share, value;
    };
    const Distribution normal = {Spread::Normal, 0.0, 1.0, -kEverywhere, kEverywhere};
    const Distribution logNormal = {Spread::LogNormal, 4.586, 0.967, 0.0, kEverywhere};
    const Distribution weibull = {Spread::Weibull, 139.285, 1.195, 0.0, kEverywhere};
    const Distribution gamma = {Spread::Gamma, 1.291, 103.901, 0.0, kEverywhere};
    const Distribution steep = {Spread::Gamma, 0.3, 1.0, 0.0, kEverywhere};
    const Distribution narrow = {Spread::Gamma, 2500.0, 1.0, 0.0, kEverywhere};
    const Distribution cut = Distribution::normal(1.34, 0.26, 0.5, 2.2);
    for (const Known& known : {Known{normal, 1e-9, -5.99780701500769}, {normal, 0.001, -3.09023230616781},
                               {normal, 0.1, -1.2815515655446},        {normal, 0.975, 1.95996398454005},
                               {normal, 0.999, 3.09023230616781},      {logNormal, 1e-9, 0.297042698799145},
                               {logNormal, 0.1, 28.4099556876017},     {logNormal, 0.5, 98.1012393471823},
                               {logNormal, 0.999, 1947.40820153058},   {weibull, 0.001, 0.430155902348194},
                               {weibull, 0.5, 102.495287391434},       {weibull, 0.999, 701.90503822197},
                               {gamma, 0.001, 0.554512508275062},      {gamma, 0.1, 21.4098034714305},
                               {gamma, 0.5, 101.527854836748},         {gamma, 0.999, 793.871135191029},
                               {steep, 0.001, 6.97269909678335e-11},   {steep, 0.5, 0.0731311358669519},
                               {steep, 0.999, 4.61893604279133},       {narrow, 0.001, 2348.3336908679},
                               {narrow, 0.5, 2499.66667456906},        {narrow, 0.999, 2657.3656791506},
                               {cut, 0.01, 0.740914505466736},         {cut, 0.5, 1.34004788451203},
                               {cut, 0.99, 1.94045556830757}}) {
        CAPTURE(static_cast<int>(known.drawn.spread));
        CAPTURE(known.share);
        CHECK(relativeError(known.drawn.quantile(known.share), known.value) < 1e-10);
    }
    CHECK(Distribution::constant(1.33).quantile(0.2) == 1.33);
    CHECK(Distribution::uniform(10.0, 100.0).quantile(0.25) == doctest::Approx(32.5));
}

TEST_CASE("the share of a density below a quantile is that share, cut off or not") {
    struct Case {
        Distribution drawn;
        double least, most;  // Between which the density is integrated.
    };
    for (const Case& c : {Case{{Spread::Normal, 1.34, 0.26, 0.0, kEverywhere}, 0.0, 4.0},
                          {Distribution::normal(1.34, 0.26, 1.2, 1.5), 1.2, 1.5},
                          {{Spread::LogNormal, 0.2, 0.4, 0.5, 2.0}, 0.5, 2.0},
                          {{Spread::Gamma, 3.5, 0.4, 0.0, kEverywhere}, 0.0, 30.0},
                          {{Spread::Gamma, 12.0, 0.1, 1.0, 1.3}, 1.0, 1.3},
                          {{Spread::Weibull, 1.4, 5.0, 0.5, 1.6}, 0.5, 1.6},
                          {{Spread::Uniform, 10.0, 100.0, 20.0, 50.0}, 20.0, 50.0}}) {
        const double whole = mass(c.drawn, c.least, c.most);
        for (const double share : {0.02, 0.3, 0.5, 0.8, 0.99}) {
            const double value = c.drawn.quantile(share);
            CAPTURE(static_cast<int>(c.drawn.spread));
            CAPTURE(share);
            CHECK(value >= c.least);
            CHECK(value <= c.most);
            CHECK(mass(c.drawn, c.least, value) / whole == doctest::Approx(share).epsilon(1e-6));
        }
    }
}

TEST_CASE("speeds by age are those of the RiMEA guideline") {
    struct Range {
        double age, low, high;
    };
    for (const Range& range : {Range{20, 1.60, 1.64},
                               {30, 1.52, 1.56},
                               {40, 1.46, 1.50},
                               {50, 1.39, 1.43},
                               {60, 1.27, 1.27},
                               {70, 1.07, 1.07}}) {
        CHECK(walkingSpeedAtAge(range.age) >= range.low);
        CHECK(walkingSpeedAtAge(range.age) <= range.high);
    }
    CHECK(walkingSpeedAtAge(25) == doctest::Approx(1.58));
    CHECK(walkingSpeedAtAge(1) == walkingSpeedAtAge(5));
    CHECK(walkingSpeedAtAge(99) == walkingSpeedAtAge(90));
}

TEST_CASE("random shares are uniform, and those of one person, of neighbours and of seeds independent") {
    constexpr std::uint32_t kCount = 20000;
    const Distribution uniform = Distribution::uniform(0.0, 1.0);
    const auto sample = [&](std::uint64_t seed, Drawn what, std::uint32_t first) {
        std::vector<double> shares;
        for (std::uint32_t id = first; id < first + kCount; ++id)
            shares.push_back(randomShare(seed, id, what));
        return shares;
    };
    const auto correlation = [&](const std::vector<double>& a, const std::vector<double>& b) {
        double sum = 0.0;
        for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - 0.5) * (b[k] - 0.5);
        return sum / static_cast<double>(a.size()) * 12.0;
    };
    const double bound = 4.0 / std::sqrt(static_cast<double>(kCount));
    for (const std::uint64_t seed : {0ull, 1ull, 77ull, ~0ull}) {
        const std::vector<double> speeds = sample(seed, Drawn::Speed, 1);
        CHECK(misfit(speeds, uniform) < 1.9);
        CHECK(misfit(sample(seed, Drawn::Age, 1), uniform) < 1.9);
        CHECK(std::fabs(correlation(speeds, sample(seed, Drawn::Radius, 1))) < bound);
        CHECK(std::fabs(correlation(speeds, sample(seed, Drawn::Speed, 2))) < bound);
        CHECK(std::fabs(correlation(speeds, sample(seed + 1, Drawn::Speed, 1))) < bound);
    }
}

TEST_CASE("of each sort there are as many as its share says, at random ranks") {
    struct Case {
        int count;
        std::vector<double> shares;
        std::vector<int> wanted;
    };
    for (const Case& c : {Case{10, {0.1, 0.2, 0.7}, {1, 2, 7}},
                          {10, {1, 1, 1}, {4, 3, 3}},
                          {7, {0.5, 0.3, 0.2}, {4, 2, 1}},  // 3.5, 2.1, 1.4.
                          {1, {0.4, 0.6}, {0, 1}},
                          {100, {5, 10, 60, 25}, {5, 10, 60, 25}}}) {
        std::vector<PeopleDef> people;
        for (std::size_t k = 0; k < c.shares.size(); ++k)
            people.push_back(sortOf(static_cast<std::uint8_t>(k + 1), c.shares[k]));
        const std::vector<Body> bodies = bodiesOf(World::create(crowdOf(c.count, people)).value());
        const std::array<int, 8> counts = classesOf(bodies);
        for (std::size_t k = 0; k < c.wanted.size(); ++k) CHECK(counts[k + 1] == c.wanted[k]);
    }
    // The mean rank of a sort lies in the middle, and other seeds mix otherwise.
    std::set<std::vector<int>> orders;
    double sum = 0.0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const std::vector<Body> bodies = bodiesOf(
            World::create(crowdOf(100, {sortOf(1, 0.3), sortOf(2, 0.7)}, seed)).value());
        std::vector<int> order;
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            order.push_back(bodies[k].unitClass);
            if (bodies[k].unitClass == 1) sum += static_cast<double>(k) - 49.5;
        }
        orders.insert(order);
    }
    CHECK(orders.size() == 40);
    CHECK(std::fabs(sum / (40 * 30)) < 4.0 * 28.9 / std::sqrt(40.0 * 30.0));
}

TEST_CASE("the numbers of the persons of a group are spread as their distributions say") {
    PeopleDef sort{.speed = Distribution::normal(1.34, 0.26, 0.5, 2.2),
                   .radius = Distribution::uniform(0.15, 0.25),
                   .headway = {Spread::Gamma, 20.0, 0.05, 0.1, 3.0},
                   .premovement = {Spread::LogNormal, 4.586, 0.967, 0.0, 3600.0}};
    const std::vector<Body> bodies = bodiesOf(World::create(crowdOf(2000, {sort})).value());
    CHECK(misfit(valuesOf(bodies, &Body::maxSpeed), sort.speed) < 1.63);
    CHECK(misfit(valuesOf(bodies, &Body::radius), sort.radius) < 1.63);
    CHECK(misfit(valuesOf(bodies, &Body::headway), sort.headway) < 1.63);
    CHECK(misfit(valuesOf(bodies, &Body::premovement), sort.premovement) < 1.63);
    // Who comes later is drawn alike.
    World world = World::create(crowdOf(4, {sort})).value();
    REQUIRE(give(world, ChangeGroup{.group = world.group(0).id, .count = 2000}).ok());
    world.step();
    REQUIRE(world.characters().size() == 2000);
    CHECK(misfit(valuesOf(bodiesOf(world), &Body::maxSpeed), sort.speed) < 1.63);
}

TEST_CASE("an age gives the speed, and what a sort does not draw is that of the bodies") {
    PeopleDef old{.share = 1.0,
                  .speed = Distribution::constant(3.0),
                  .age = Distribution::uniform(60.0, 80.0),
                  .upstairs = 0.4};
    PeopleDef plain;
    WorldDef def = crowdOf(50, {old, plain});
    Body given{.radius = 0.31,
               .maxSpeed = 2.5,
               .acceleration = 7.0,
               .mass = 2.0,
               .unitClass = 5,
               .premovement = 3.0,
               .downstairs = 0.9};
    def.groups[0].bodies = {given};
    int aged = 0;
    for (const Body& body : bodiesOf(World::create(def).value())) {
        CHECK(body.mass == 2.0);
        CHECK(body.acceleration == 7.0);
        CHECK(body.radius == 0.31);
        CHECK(body.unitClass == 5);
        CHECK(body.downstairs == 0.9);
        CHECK(body.premovement == 3.0);
        if (body.upstairs == 0.4) {
            ++aged;
            CHECK(body.maxSpeed >= walkingSpeedAtAge(80.0));
            CHECK(body.maxSpeed <= walkingSpeedAtAge(60.0));
        } else {
            CHECK(body == given);
        }
    }
    CHECK(aged == 25);
}

TEST_CASE("the same seed gives the same persons, whatever else is drawn or comes") {
    PeopleDef sort = adults();
    const std::vector<Body> plain = bodiesOf(World::create(crowdOf(60, {sort}, 9)).value());
    CHECK(plain == bodiesOf(World::create(crowdOf(60, {sort}, 9)).value()));
    CHECK(plain != bodiesOf(World::create(crowdOf(60, {sort}, 10)).value()));
    // Another number is drawn: speeds and starts stay.
    sort.premovement = Distribution::uniform(10.0, 100.0);
    sort.radius = Distribution::uniform(0.2, 0.25);
    WorldDef more = crowdOf(60, {sort}, 9), jittered = crowdOf(60, {adults()}, 9);
    more.groups[0].jitter = jittered.groups[0].jitter = 0.05;
    const World a = World::create(more).value(), b = World::create(jittered).value();
    CHECK(valuesOf(bodiesOf(a), &Body::maxSpeed) == valuesOf(plain, &Body::maxSpeed));
    CHECK(valuesOf(bodiesOf(b), &Body::maxSpeed) == valuesOf(plain, &Body::maxSpeed));
    CHECK(copyOf(a.characters().position) == copyOf(b.characters().position));
    // So they do where another group comes after it.
    WorldDef two = crowdOf(60, {adults()}, 9);
    two.groups.push_back(two.groups[0]);
    two.groups[1].position = {15.0, 0.0};
    std::vector<Body> both = bodiesOf(World::create(two).value());
    CHECK(std::equal(plain.begin(), plain.end(), both.begin()));
    CHECK_FALSE(std::equal(plain.begin(), plain.end(), both.begin() + 60));
}

TEST_CASE("who joins is drawn, by sort and numbers; bodies that are given stay as they are") {
    PeopleDef women = sortOf(1, 0.25), men = sortOf(2, 0.75);
    women.speed = Distribution::normal(1.27, 0.2, 0.5, 2.2);
    World world = World::create(crowdOf(8, {women, men}, 3)).value();
    AddCharacters join{world.group(0).id, {}, {}};
    for (int k = 0; k < 400; ++k) join.positions.push_back({-8.0 + 0.04 * k, 9.0});
    REQUIRE(give(world, join).ok());
    Body own{.maxSpeed = 0.7};
    REQUIRE(give(world, AddCharacters{world.group(0).id, {{0.0, -9.0}}, {own}}).ok());
    world.step();
    REQUIRE(world.characters().size() == 409);
    const std::vector<Body> bodies = bodiesOf(world);
    CHECK(bodies.back() == own);
    const std::array<int, 8> counts = classesOf(std::span(bodies).subspan(8, 400));
    CHECK(counts[1] + counts[2] == 400);
    CHECK(std::abs(counts[1] - 100) < 35);  // Four deviations.
    // A world that was restored before they came draws the same.
    World first = World::create(crowdOf(8, {women, men}, 3)).value();
    first.step();
    World restored = World::restore(first.snapshot()).value();
    for (World* one : {&first, &restored}) {
        REQUIRE(give(*one, join).ok());
        one->step();
    }
    CHECK(bodiesOf(first) == bodiesOf(restored));
    CHECK(first.hash() == restored.hash());
}

TEST_CASE(
    "sorts that are given later draw the same persons as from the beginning, and what none draws stays") {
    PeopleDef women = sortOf(1, 0.25), men = sortOf(2, 0.75);
    women.speed = Distribution::normal(1.27, 0.2, 0.5, 2.2);
    men.radius = Distribution::uniform(0.2, 0.25);
    const std::vector<Body> drawn = bodiesOf(World::create(crowdOf(40, {women, men}, 3)).value());
    World world = World::create(crowdOf(40, {adults()}, 3)).value();
    const std::vector<Body> before = bodiesOf(world);
    const auto carryOut = [&](const CommandBody& body) {
        REQUIRE(give(world, body).ok());
        world.step();
    };
    carryOut(ChangeGroup{.group = GroupId{1}, .people = std::vector<PeopleDef>{women, men}});
    CHECK(bodiesOf(world) == drawn);
    CHECK(world.groupDef(0).people == std::vector<PeopleDef>{women, men});
    World restored = World::restore(world.snapshot()).value();
    CHECK(restored.hash() == world.hash());
    carryOut(ChangeGroup{.group = GroupId{1}, .people = std::vector<PeopleDef>{adults()}});
    CHECK(bodiesOf(world) == before);
    // Numbers by hand stay where no sort draws them.
    Body heavy = bodiesOf(world)[4];
    heavy.mass = 3.0;
    heavy.radius = 0.4;
    carryOut(ChangeCharacters{{5}, std::vector<Body>{heavy}, {}});
    carryOut(ChangeGroup{.group = GroupId{1}, .people = std::vector<PeopleDef>{}});
    CHECK(bodiesOf(world)[4].mass == 3.0);
    CHECK(bodiesOf(world)[4].radius == 0.4);
    CHECK(bodiesOf(world)[4].maxSpeed == 0.0);
    CHECK(give(world, ChangeGroup{.group = GroupId{1}, .people = std::vector<PeopleDef>{sortOf(1, -1.0)}})
              .code() == StatusCode::InvalidArgument);
}
