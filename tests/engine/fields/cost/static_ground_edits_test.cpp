// The static ground after edits is that made from scratch, bit for bit; crops are parts of the whole.
#include <doctest.h>

#include <cstring>

#include "base/maths.h"
#include "engine/fields/cost/cost_scene.h"
#include "engine/fields/cost/distant_clearance.h"
#include "engine/fields/cost/ground_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

bool same(const WallNode& a, const WallNode& b, std::int32_t cell) {
    return b.cell == cell && a.x == b.x && a.y == b.y && a.normalX == b.normalX && a.normalY == b.normalY &&
           a.unit == b.unit;
}

void checkSame(const UnitCost& a, const UnitCost& b) {
    REQUIRE(a.grid == b.grid);
    REQUIRE(a.lowest == b.lowest);
    REQUIRE(a.cells.size() == b.cells.size());
    REQUIRE(a.nodes.size() == b.nodes.size());
    int wrong = 0;
    for (std::size_t k = 0; k < a.cells.size(); ++k) wrong += sameCost(a.cells[k], b.cells[k]) ? 0 : 1;
    for (std::size_t k = 0; k < a.nodes.size(); ++k)
        wrong += same(a.nodes[k], b.nodes[k], a.nodes[k].cell) ? 0 : 1;
    REQUIRE(wrong == 0);
}

// Cells alone know nothing of narrow ways: their cells and those beside them are left out.
void checkSameBut(const NarrowWays& narrow, const UnitCost& a, const UnitCost& b) {
    const auto isFar = [&](std::int32_t cell) {
        const Cell c = a.grid.at(cell);
        bool far = narrow.find(cell) == nullptr;
        for (const Cell step : kNarrowSteps) {
            const Cell beside{c.x + step.x, c.y + step.y};
            far = far && (!a.grid.contains(beside) || narrow.find(a.grid.index(beside)) == nullptr);
        }
        return far;
    };
    int wrong = 0, looked = 0;
    for (std::int32_t k = 0; k < a.grid.count(); ++k) {
        if (!isFar(k)) continue;
        ++looked;
        wrong += sameCost(a.cells[k], b.cells[k]) ? 0 : 1;
    }
    CHECK(wrong == 0);
    CHECK(looked > a.grid.count() - a.grid.count() / 20);
    std::vector<WallNode> nodes[2];
    for (int k = 0; k < 2; ++k)
        for (const WallNode& node : (k == 0 ? a : b).nodes)
            if (isFar(node.cell)) nodes[k].push_back(node);
    CHECK(std::equal(nodes[0].begin(), nodes[0].end(), nodes[1].begin(), nodes[1].end(),
                     [](const WallNode& x, const WallNode& y) { return same(x, y, x.cell); }));
}

void checkSame(const StaticGround& a, const StaticGround& b, Random& random) {
    checkSame(a.fineLevel().unitCost(), b.fineLevel().unitCost());
    checkSame(a.middle().unitCost(), b.middle().unitCost());
    checkSame(a.coarse(), b.coarse());
    REQUIRE(a.uniform() == b.uniform());
    const auto one = a.partiallyBlockedCells(), other = b.partiallyBlockedCells();
    REQUIRE(one.size() == other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        REQUIRE(one[k].cell == other[k].cell);
        REQUIRE(one[k].neighbour == other[k].neighbour);
        REQUIRE(one[k].cost == other[k].cost);
    }
    int wrong = 0;
    for (std::int32_t k = 0; k < a.grid().count(); ++k) {
        const Cell c = a.grid().at(k);
        wrong += a.uniformClearanceOf(c) == b.uniformClearanceOf(c) ? 0 : 1;
    }
    REQUIRE(wrong == 0);
    for (int k = 0; k < 50; ++k) {
        const Vec2 p{random.uniform(-36, 36), random.uniform(-36, 36)};
        const Vec2 q{random.uniform(-36, 36), random.uniform(-36, 36)};
        REQUIRE(a.lineOfSight(p, q) == b.lineOfSight(p, q));
        REQUIRE(a.lineCost(p, q) == b.lineCost(p, q));
    }
}

ObstacleDef randomBuilding(Random& random) {
    ObstacleDef building;
    const Vec2 centre{random.uniform(-34, 34), random.uniform(-34, 34)};
    const double angle = random.uniform(0, kPi);
    const Rotation turn{cosine(angle), sine(angle)};
    const Vec2 half{random.uniform(0.05, 5), random.uniform(0.3, 5)};
    for (const Vec2 corner : {Vec2{-half.x, -half.y}, Vec2{half.x, -half.y}, half, Vec2{-half.x, half.y}})
        building.polygon.push_back(centre + turn.apply(corner));
    return building;
}

PatchDef randomPatch(Random& random) {
    const double x = random.uniform(-34, 30), y = random.uniform(-34, 30);
    return slowBox(x, y, x + random.uniform(1, 8), y + random.uniform(1, 8), random.uniform(0.2, 1.5));
}

// Adds, changes or removes something; patches only where `patches`.
void edit(Environment& environment, Random& random, bool patches) {
    const auto obstacles = environment.obstacleIds();
    const auto any = [&](auto ids) { return ids[random.below(static_cast<std::uint32_t>(ids.size()))]; };
    if (patches && random.below(3) == 0) {
        if (environment.patchIds().size() < 3)
            REQUIRE(environment.addPatch(randomPatch(random)).ok());
        else
            REQUIRE(environment.removePatch(any(environment.patchIds())).ok());
    } else if (obstacles.size() < 8 || random.below(3) == 0) {
        REQUIRE(environment.addObstacle(randomBuilding(random)).ok());
    } else if (random.below(2) == 0) {
        REQUIRE(environment.changeObstacle(any(obstacles), randomBuilding(random)).ok());
    } else {
        REQUIRE(environment.removeObstacle(any(obstacles)).ok());
    }
}

}  // namespace

TEST_CASE("after random edits the static ground is that made from scratch, and knows where it changed") {
    for (const bool patches : {false, true}) {
        Random random(patches ? 31 : 30);
        Environment environment = squareWorld(36.0);
        StaticGround ground = groundOf(environment);
        for (int step = 0; step < 30; ++step) {
            const std::uint32_t version = ground.version();
            const UnitCost before = ground.middle().unitCost();
            for (auto edits = 1 + random.below(3); edits > 0; --edits) edit(environment, random, patches);
            ground.update(environment, 1.0, 0.25);
            CAPTURE(patches);
            CAPTURE(step);
            checkSame(ground, groundOf(environment), random);
            std::vector<CellRect> areas;
            const GroundLevel level = ground.middle();
            if (!level.changesSince(version, areas)) continue;
            const UnitCost after = level.unitCost();
            for (std::int32_t k = 0; k < level.grid().count(); ++k) {
                if (sameCost(before.cells[k], after.cells[k])) continue;
                const Cell c = level.grid().at(k);
                bool named = false;
                for (const CellRect& area : areas) named = named || !area.common({c, c}).empty();
                REQUIRE(named);
            }
        }
    }
}

TEST_CASE("the unit cost of a crop is that part of the whole, and walls off the ground") {
    Random random(9);
    Environment environment = squareWorld(20.0);
    for (int k = 0; k < 25; ++k) REQUIRE(environment.addObstacle(randomBuilding(random)).ok());
    REQUIRE(environment.addPatch(slowBox(-5, -5, 8, 3, 0.4)).ok());
    const StaticGround ground = groundOf(environment);
    for (const GroundLevel& level : {ground.fineLevel(), ground.middle()}) {
        // The other way to compute it visits single cells.
        const Grid& grid = level.grid();
        const UnitCost whole = level.unitCost();
        if (grid.cell == environment.grid().cell) {
            UnitCost expected = whole;
            std::vector<float> unit(grid.count());
            expected.nodes.clear();
            const GroundRasters rasters{grid, environment.staticClearance(), environment.travelSpeed()};
            computeGroundCost(rasters, 0.25, 1.0, 0, grid.count(), {expected.cells, unit, expected.nodes});
            checkSameBut(ground.narrowWays(), whole, expected);
        }
        GroundLevel::Scratch scratch;
        UnitCost crop;
        for (int round = 0; round < 40; ++round) {
            const Cell low{static_cast<std::int32_t>(random.below(grid.width + 20)) - 15,
                           static_cast<std::int32_t>(random.below(grid.height + 20)) - 15};
            const Cell size{static_cast<std::int32_t>(random.below(40)),
                            static_cast<std::int32_t>(random.below(40))};
            level.unitCost({low, {low.x + size.x, low.y + size.y}}, scratch, crop);
            std::size_t node = 0;
            for (std::int32_t k = 0; k < crop.grid.count(); ++k) {
                const Cell c{crop.grid.at(k).x + low.x, crop.grid.at(k).y + low.y};
                if (!grid.contains(c)) {
                    REQUIRE(crop.wall(k));
                    continue;
                }
                const std::int32_t at = grid.index(c);
                REQUIRE(sameCost(crop.cells[k], whole.cells[at]));
                const auto found = std::lower_bound(
                    whole.nodes.begin(), whole.nodes.end(), at,
                    [](const WallNode& n, std::int32_t cell) { return n.cell < cell; });
                if (found == whole.nodes.end() || found->cell != at) continue;
                REQUIRE(node < crop.nodes.size());
                REQUIRE(same(*found, crop.nodes[node++], k));
            }
            REQUIRE(node == crop.nodes.size());
        }
    }
}

TEST_CASE("beyond the cap the clearance is extended by a lower bound that grows with the distance") {
    Random random(4);
    const Grid grid{{0, 0}, 0.25, 230, 190};
    std::vector<Vec2> walls;
    for (int k = 0; k < 6; ++k) walls.push_back({random.uniform(0, 57), random.uniform(0, 47)});
    const auto distanceTo = [&](Vec2 p) {
        double least = 1e9;
        for (const Vec2 wall : walls) least = std::min(least, distance(wall, p));
        return least;
    };
    std::vector<float> clearance(grid.count());
    const auto fill = [&] {
        for (std::int32_t k = 0; k < grid.count(); ++k)
            clearance[k] = static_cast<float>(std::min(3.0, distanceTo(grid.centre(grid.at(k)))));
    };
    fill();
    const CellRect whole{{0, 0}, {grid.width - 1, grid.height - 1}};
    DistantClearance distant;
    distant.reset(grid);
    distant.update(clearance, whole);
    for (int round = 0; round < 8; ++round) {
        double most = 0.0;
        for (std::int32_t k = 0; k < grid.count(); ++k) {
            if (clearance[k] < 3.0f) continue;
            const double known = 3.0 + distant.beyond(grid.at(k));
            const double exact = distanceTo(grid.centre(grid.at(k)));
            REQUIRE(known <= exact + 1e-4);
            REQUIRE(known > std::min(exact, 17.0) - 3.6);
            most = std::max(most, known);
        }
        CHECK(most > 8.0);
        // One wall moves; only what is near its old and new place is told.
        const Vec2 before = walls[round % walls.size()];
        walls[round % walls.size()] = {random.uniform(0, 57), random.uniform(0, 47)};
        fill();
        for (const Vec2 p : {before, walls[round % walls.size()]})
            distant.update(clearance, CellRect::touching(grid, Box{p, p}.grown(3.0)));
        DistantClearance fresh;
        fresh.reset(grid);
        fresh.update(clearance, whole);
        for (std::int32_t k = 0; k < grid.count(); ++k)
            REQUIRE(distant.beyond(grid.at(k)) == fresh.beyond(grid.at(k)));
    }
}
