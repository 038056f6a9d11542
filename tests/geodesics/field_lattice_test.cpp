// Fields of landmarks: made in the order of wishes, kept while used, moved together when room is needed.
#include <doctest.h>

#include <vector>

#include "cost/ground_scene.h"
#include "cost/static_ground.h"
#include "geodesics/field_lattice.h"

using namespace muster;
using namespace muster::test;

namespace {

// A lattice over a small plain ground; landmarks are its cells.
struct Kept {
    Environment environment = squareWorld(6.0);
    StaticGround ground;
    EikonalSolver solver;
    ThreadPool pool{1};
    FieldLattice lattice;
    std::vector<std::int32_t> made;

    explicit Kept(std::int32_t capacity) : lattice(capacity) {
        environment.setTime(0.0);
        ground.update(environment, 1.0, 0.25);
    }
    Vec2 at(std::int32_t landmark) const {
        return ground.fine().grid.centre(ground.fine().grid.at(landmark));
    }
    std::int32_t build(std::int32_t most) {
        lattice.beginStep();
        return lattice.build(most, pool, [&](std::int32_t landmark, CostField& field, std::int32_t) {
            made.push_back(landmark);
            solver.solve(ground.fine(), at(landmark), {}, field);
        });
    }
    // Every field is that of its landmark.
    bool right() const {
        for (std::int32_t slot = 0; slot < lattice.count(); ++slot)
            if (distance(lattice.field(slot).source(), at(lattice.landmark(slot))) > 1e-9) return false;
        return true;
    }
};

}  // namespace

TEST_CASE("wishes are met in their order, as many as are allowed, the others forgotten") {
    Kept kept(16);
    for (const std::int32_t landmark : {700, 20, 700, 311, 20, 55}) kept.lattice.wish(landmark);
    CHECK(kept.build(0) == 0);  // Forgets nothing.
    CHECK(kept.build(2) == 2);
    CHECK(kept.made == std::vector<std::int32_t>{700, 20});
    CHECK(kept.build(2) == 0);
    CHECK(kept.lattice.find(311) == -1);
    CHECK(kept.lattice.count() == 2);
    CHECK(kept.lattice.use(20) == kept.lattice.find(20));
    CHECK(kept.right());
    kept.lattice.wish(20);  // Is there.
    CHECK(kept.build(4) == 0);
}

TEST_CASE("where room is needed those go that nobody used for long, and the rest stay right") {
    Kept kept(8);
    for (std::int32_t landmark = 100; landmark < 108; ++landmark) kept.lattice.wish(landmark);
    kept.build(100);
    CHECK(kept.lattice.count() == 8);
    const std::uint32_t before = kept.lattice.generation();
    // All in use: no room for others.
    kept.lattice.wish(300);
    CHECK(kept.build(1) == 0);
    for (int step = 0; step < 300; ++step) {
        kept.lattice.beginStep();
        for (const std::int32_t landmark : {101, 104, 107}) CHECK(kept.lattice.use(landmark) >= 0);
    }
    for (const std::int32_t landmark : {300, 301}) kept.lattice.wish(landmark);
    CHECK(kept.build(5) == 2);
    CHECK(kept.lattice.count() == 5);
    CHECK(kept.lattice.generation() > before);
    CHECK(kept.lattice.find(100) == -1);
    for (const std::int32_t landmark : {101, 104, 107, 300, 301}) CHECK(kept.lattice.find(landmark) >= 0);
    CHECK(kept.right());
    kept.lattice.clear();
    CHECK(kept.lattice.count() == 0);
    CHECK(kept.lattice.find(101) == -1);
}

TEST_CASE("an archive brings back which fields there are, a torn one nothing") {
    Kept kept(32);
    for (std::int32_t landmark = 0; landmark < 900; landmark += 61) kept.lattice.wish(landmark);
    kept.build(9);
    Writer writer;
    kept.lattice.visit(writer);
    Kept copy(32);
    Reader reader(writer.bytes());
    copy.lattice.visit(reader);
    REQUIRE(reader.ok());
    copy.lattice.rebuild(copy.pool, [&](std::int32_t landmark, CostField& field, std::int32_t) {
        copy.solver.solve(copy.ground.fine(), copy.at(landmark), {}, field);
    });
    CHECK(copy.lattice.count() == 9);
    CHECK(copy.right());
    for (std::int32_t landmark = 0; landmark < 900; landmark += 61)
        CHECK(copy.lattice.find(landmark) == kept.lattice.find(landmark));
    Kept small(4);  // Holds fewer than were saved.
    Reader again(writer.bytes());
    small.lattice.visit(again);
    CHECK_FALSE(again.ok());
}
