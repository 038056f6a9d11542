// Unit costs.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/maths.h"
#include "base/random.h"
#include "engine/fields/cost/dynamic_cost.h"
#include "engine/fields/cost/unit_cost_builder.h"

using namespace muster;

namespace {

Environment makeEnvironment(double half = 8.0) {
    auto environment = Environment::create({.box = {{-half, -half}, {half, half}}});
    REQUIRE(environment.ok());
    return std::move(environment).value();
}

ObstacleDef block(double x0, double y0, double x1, double y1) {
    return {.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

bool same(const UnitCost& a, const UnitCost& b) {
    return a.grid == b.grid && a.radius == b.radius && a.lowest == b.lowest &&
           a.cells.size() == b.cells.size() &&
           std::memcmp(a.cells.data(), b.cells.data(), a.cells.size() * sizeof(CellCost)) == 0 &&
           a.nodes.size() == b.nodes.size() &&
           (a.nodes.empty() ||
            std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(WallNode)) == 0);
}

bool same(const CellCost& a, const CellCost& b) {
    return std::memcmp(&a, &b, sizeof(CellCost)) == 0;
}

// Checks the ground cost of a builder, its dynamic cells and its changes since `before`.
void checkGround(const UnitCostBuilder& used, const UnitCostBuilder& bare,
                 const std::vector<CellCost>& before) {
    REQUIRE(used.groundCost().size() == bare.groundCost().size());
    std::vector<std::uint8_t> dynamic(used.groundCost().size(), 0), changed(used.groundCost().size(), 0);
    for (const std::int32_t cell : used.dynamicCells()) ++dynamic[cell];
    for (const std::int32_t cell : used.groundChanges()) ++changed[cell];
    bool all = true, any = false;
    for (std::size_t k = 0; k < dynamic.size(); ++k) {
        all = all && same(used.groundCost()[k], bare.groundCost()[k]) && dynamic[k] <= 1 && changed[k] <= 1;
        all = all && (dynamic[k] == 1) == !same(used.cost().cells[k], used.groundCost()[k]);
        const bool differs = before.size() != dynamic.size() || !same(before[k], used.groundCost()[k]);
        all = all && (changed[k] == 1 || !differs);
        any = any || differs;
    }
    CHECK(all);
    CHECK((!used.groundChanges().empty() || !any));
    CHECK(std::is_sorted(used.groundChanges().begin(), used.groundChanges().end()));
}

const CellCost& at(const UnitCost& cost, Vec2 p) {
    return cost.cells[cost.grid.index(cost.grid.cellOf(p))];
}

}  // namespace

TEST_CASE("open ground costs alpha + beta, walls and the edge of the world are infinite") {
    Environment environment = makeEnvironment();
    REQUIRE(environment.addObstacle(block(-2, -2, 2, 2)).ok());
    environment.setTime(0.0);
    UnitCost cost;
    UnitCostBuilder builder;
    builder.build({}, environment, DensityField(environment.def().box, {}), 0.25, cost);
    const CellCost& open = at(cost, {5.1, 5.1});
    CHECK(open.east == 1.0f);
    CHECK(open.south == 1.0f);
    CHECK(cost.wall(cost.grid.index(cost.grid.cellOf({0, 0}))));
    // Cells inside the block grown by the radius are walls, except those whose node is drawn out of it.
    for (std::int32_t k = 0; k < cost.grid.count(); ++k) {
        const double clearance = environment.clearance()[k];
        if (clearance < 0.25 - 0.708 * 0.25) CHECK(cost.wall(k));
        if (clearance >= 0.25) CHECK(!cost.wall(k));
    }
    const CellCost& rim = at(cost, {-7.9, 3.1});
    CHECK(std::isinf(rim.west));
    CHECK(std::isfinite(rim.north));
}

TEST_CASE("slow ground costs in proportion") {
    Environment environment = makeEnvironment();
    REQUIRE(environment.addPatch({.polygon = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, .speed = 0.4}).ok());
    environment.setTime(0.0);
    UnitCost cost;
    UnitCostBuilder builder;
    builder.build({}, environment, DensityField(), 0.25, cost);
    CHECK(at(cost, {0, 0}).east == doctest::Approx(2.5));
    CHECK(at(cost, {5, 5}).east == 1.0f);
    CHECK(cost.lowest == 1.0f);
}

TEST_CASE("a crowd raises the cost of walking against it, not with it") {
    Environment environment = makeEnvironment();
    environment.setTime(0.0);
    Parameters parameters{.density = {.lookAhead = 0.5}};
    DensityField density(environment.def().box, {.cell = 1.0, .lambda = 1.0});
    std::vector<Vec2> positions;
    // 16 per m^2 round the middle, all walking east at full speed.
    for (int x = -12; x < 12; ++x) {
        for (int y = -12; y < 12; ++y) positions.push_back({0.125 + 0.25 * x, 0.125 + 0.25 * y});
    }
    density.splat(positions, std::vector<Vec2>(positions.size(), Vec2{2.0, 0.0}));
    UnitCost cost;
    UnitCostBuilder builder;
    builder.build(parameters, environment, density, 0.25, cost);
    const CellCost& c = at(cost, {0.1, 0.1});
    CHECK(c.east == doctest::Approx(1.0));
    // f = minSpeed: (0.5 f + 0.5) / f.
    CHECK(c.west == doctest::Approx((0.5 * 0.05 + 0.5) / 0.05));
    CHECK(c.north == doctest::Approx(10.5));
    CHECK(at(cost, {6.5, 6.5}).west == 1.0f);
    // Between the thresholds the speed is linear in the density.
    const Vec2 p = cost.grid.centre(cost.grid.cellOf({3.4, 0.1}));
    const double crowd = density.densityAt(p - Vec2{0.5, 0.0});
    parameters.density.min = crowd - 0.3;
    parameters.density.max = crowd + 0.7;
    builder.build(parameters, environment, density, 0.25, cost);
    const double f = 1.0 - 0.3;
    CHECK(at(cost, p).west == doctest::Approx((0.5 * f + 0.5) / f).epsilon(1e-5));
    parameters.density.enabled = false;
    builder.build(parameters, environment, density, 0.25, cost);
    CHECK(at(cost, {0.1, 0.1}).west == 1.0f);
}

TEST_CASE("discomfort falls linearly with time and distance, against brute force") {
    Parameters::Discomfort def;
    ObstaclePiece disc{.centre = {0, 0}, .radius = 0.5, .velocity = {2.0, 0.0}, .moving = true};
    // On the track, reached after (x - r) / v.
    CHECK(discomfortAt(def, disc, {2.5, 0}) == doctest::Approx(8.0 * (1.0 - 1.0 / 1.5)).epsilon(0.02));
    CHECK(discomfortAt(def, disc, {0, 0}) == doctest::Approx(8.0));
    CHECK(discomfortAt(def, disc, {0, 1.0}) == doctest::Approx(8.0 * 0.5));
    CHECK(discomfortAt(def, disc, {0, 1.6}) == 0.0);
    CHECK(discomfortAt(def, disc, {-1.6, 0}) == 0.0);
    ObstaclePiece box{.corners = {{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}},
                      .radius = std::sqrt(1.25),
                      .velocity = {1.5, 1.0},
                      .moving = true};
    Random random(5);
    for (const ObstaclePiece& piece : {disc, box}) {
        for (int k = 0; k < 300; ++k) {
            const Vec2 p{random.uniform(-3, 6), random.uniform(-3, 4)};
            double best = 0.0;
            for (int t = 0; t <= 3000; ++t) {
                const double time = def.time * t / 3000;
                const double away = std::max(0.0, piece.signedDistance(p - piece.velocity * time));
                const double g = 8.0 * (1 - time / def.time) * std::max(0.0, 1.0 - away);
                best = std::max(best, g);
            }
            CHECK(discomfortAt(def, piece, p) == doctest::Approx(best).epsilon(0.03));
        }
    }
}

TEST_CASE("the peak of discomfort is found to a millionth, for all shapes and speeds") {
    Random random(11);
    double worst = 0.0;
    int felt = 0;
    for (int round = 0; round < 400; ++round) {
        Parameters::Discomfort def{.time = random.uniform(0.5, 3.0), .range = random.uniform(0.3, 2.0)};
        ObstaclePiece piece;
        piece.moving = true;
        piece.velocity = Vec2{random.uniform(-1, 1), random.uniform(-1, 1)} * random.uniform(0.02, 6.0);
        piece.radius = random.uniform(0.2, 1.5);
        // Corners on a circle: convex.
        const int corners = round % 4 == 0 ? 0 : 2 + round % 4;
        for (int k = 0; k < corners; ++k) {
            const double angle = 2.0 * kPi * (k + random.uniform(0.0, 0.8)) / corners;
            piece.corners.push_back(Vec2{std::cos(angle), std::sin(angle)} * piece.radius);
        }
        for (int k = 0; k < 10; ++k) {
            const Vec2 p{random.uniform(-3, 3) + piece.velocity.x, random.uniform(-3, 3) + piece.velocity.y};
            const auto at = [&](double time) {
                const double away = std::max(0.0, piece.signedDistance(p - piece.velocity * time));
                return def.gain * (1 - time / def.time) * std::max(0.0, 1.0 - away / def.range);
            };
            // Coarsely, then finely round the best.
            double best = 0.0;
            double when = 0.0;
            for (int t = 0; t <= 1000; ++t) {
                const double time = def.time * t / 1000;
                if (at(time) > best) when = time;
                best = std::max(best, at(time));
            }
            for (int t = -1000; t <= 1000; ++t) {
                const double time = when + def.time * t * 1e-6;
                if (time >= 0.0 && time <= def.time) best = std::max(best, at(time));
            }
            felt += best > 0.0 ? 1 : 0;
            // Sampling may miss the peak by as much as it moves within a sample.
            const double missed = def.gain * 1e-6 * (1.0 + def.time * length(piece.velocity) / def.range);
            const double found = discomfortAt(def, piece, p);
            CHECK(found <= best + missed);
            worst = std::max(worst, best - found);
        }
    }
    CHECK(felt > 1000);
    CHECK(worst < 1e-6);
}

TEST_CASE("a builder with a history gives the same bits as a new one") {
    Random random(17);
    Environment environment = makeEnvironment();
    REQUIRE(environment.addObstacle(block(-3, -1, -1, 2)).ok());
    ObstacleDef car = block(-0.5, -0.5, 0.5, 0.5);
    car.path.waypoints = {{0.0, {-5, -4}, 0.0}, {6.0, {5, -4}, 0.0}};
    REQUIRE(environment.addObstacle(car).ok());
    PatchDef patch{.polygon = {{2, 2}, {5, 2}, {5, 5}, {2, 5}}, .speed = 0.5};
    const auto patchId = environment.addPatch(patch);
    REQUIRE(patchId.ok());
    UnitCostBuilder used;
    UnitCost one;
    DensityField density(environment.def().box, {.cell = 1.0, .lambda = 1.0});
    for (int round = 0; round < 60; ++round) {
        environment.setTime(0.1 * round);
        if (random.below(5) == 0) {
            patch.speed = random.uniform(0.2, 1.6);
            REQUIRE(environment.changePatch(patchId.value(), patch).ok());
            environment.setTime(0.1 * round);
        }
        std::vector<Vec2> positions(random.below(150));
        std::vector<Vec2> velocities;
        const Vec2 middle{random.uniform(-6, 6), random.uniform(-6, 6)};
        for (Vec2& p : positions) {
            p = middle + Vec2{random.uniform(-2, 2), random.uniform(-2, 2)};
            velocities.push_back({random.uniform(-2, 2), random.uniform(-2, 2)});
        }
        density.splat(positions, velocities);
        Parameters parameters;
        parameters.density.enabled = random.below(6) != 0;
        parameters.discomfort.enabled = random.below(6) != 0;
        parameters.cost.alpha = random.below(8) == 0 ? 0.2 : 0.5;
        const double radius = random.below(5) == 0 ? 0.4 : 0.25;
        const std::vector<CellCost> groundBefore = used.groundCost();
        used.build(parameters, environment, density, radius, one);
        Parameters empty = parameters;
        empty.density.enabled = empty.discomfort.enabled = false;
        UnitCostBuilder bare;
        bare.update(empty, environment, DensityField(), radius);
        checkGround(used, bare, groundBefore);
        UnitCostBuilder fresh;
        UnitCost other;
        fresh.build(parameters, environment, density, radius, other);
        CHECK(same(one, other));
        CHECK(used.discomfort() == fresh.discomfort());
        for (const CellCost& c : one.cells) {
            const float least = 0.09f * one.lowest;  // Edges at walls are shorter, down to a tenth.
            CHECK_FALSE((c.east < least || c.north < least || c.west < least || c.south < least));
            CHECK_FALSE(
                (std::isnan(c.east) || std::isnan(c.north) || std::isnan(c.west) || std::isnan(c.south)));
        }
    }
}

TEST_CASE("incremental updates under moving things give the same cost as a new builder") {
    Environment environment = makeEnvironment();
    REQUIRE(environment.addObstacle(block(-1, 2, 3, 3)).ok());
    ObstacleDef cart = block(-0.6, -0.4, 0.6, 0.4);
    cart.path.waypoints = {{0.0, {-6, 1.5}, 0.0}, {4.0, {6, 2.5}, 2.0}};
    REQUIRE(environment.addObstacle(cart).ok());
    PatchDef raft{.polygon = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}},
                  .path = {.waypoints = {{0.0, {0, -6}, 0.0}, {4.0, {3, 6}, 0.0}}},
                  .speed = 0.3};
    REQUIRE(environment.addPatch(raft).ok());
    UnitCostBuilder used;
    std::size_t most = 0;
    for (int step = 0; step < 120; ++step) {
        environment.setTime(step / 30.0);
        if (step == 70) REQUIRE(environment.addObstacle(block(-4, -4, -3, -3)).ok());
        if (step == 90) REQUIRE(environment.removeObstacle(environment.obstacleIds()[0]).ok());
        const std::vector<CellCost> groundBefore = used.groundCost();
        used.update({}, environment, DensityField(), 0.25);
        if (step % 7 == 3) used.update({}, environment, DensityField(), 0.25);
        UnitCostBuilder fresh, bare;
        fresh.update({}, environment, DensityField(), 0.25);
        Parameters empty{.discomfort = {.enabled = false}};
        bare.update(empty, environment, DensityField(), 0.25);
        CHECK(same(used.cost(), fresh.cost()));
        if (step % 7 != 3) checkGround(used, bare, groundBefore);
        if (step > 0) most = std::max(most, used.groundChanges().size());
    }
    CHECK(most > 0);
    CHECK(most < used.groundCost().size() / 4);  // Only what lies round the moving things.
}

TEST_CASE("a gap narrower than a character is closed, one wider by a cell is open") {
    for (const double width : {0.30, 0.40, 0.47, 0.495, 0.76, 0.80}) {
        for (double shift = 0.0; shift < 0.25; shift += 0.03) {
            Environment environment = makeEnvironment(4.0);
            const double low = shift - 0.5 * width;
            const double high = shift + 0.5 * width;
            REQUIRE(environment.addObstacle(block(-0.6, -20, 0.6, low)).ok());
            REQUIRE(environment.addObstacle(block(-0.6, high, 0.6, 20)).ok());
            environment.setTime(0.0);
            UnitCost cost;
            UnitCostBuilder builder;
            builder.build({}, environment, DensityField(), 0.25, cost);
            // Open where some chain of cells leads through; a straight row will do here.
            bool open = false;
            for (std::int32_t y = 0; y < cost.grid.height; ++y) {
                bool row = true;
                for (double x = -1.1; x < 1.1; x += 0.25) {
                    const std::int32_t index = cost.grid.index({cost.grid.cellOf({x, 0}).x, y});
                    row = row && cost.cells[index].east < 1e30f;
                }
                open = open || row;
            }
            CAPTURE(width);
            CAPTURE(shift);
            CHECK(open == (width > 0.5));
        }
    }
}
