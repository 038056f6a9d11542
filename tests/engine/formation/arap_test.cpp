#include "engine/formation/mesh/arap.h"
#include "engine/formation/mesh_fixture.h"

#include <doctest.h>

#include <Eigen/Dense>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <new>

#include "base/maths.h"
#include "base/random.h"
#include "engine/formation/arap_oracle.h"

using namespace muster;
using namespace muster::test;

namespace {

TriangleMesh grid(int columns, int rows, double cell = 1.0) {
    TriangleMesh mesh;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) mesh.vertices.push_back({i * cell, j * cell});
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const int a = j * (columns + 1) + i;
            const int c = a + columns + 2;
            mesh.triangles.push_back({a, a + 1, c});
            mesh.triangles.push_back({a, c, c - 1});
        }
    }
    return mesh;
}

// The second algorithm: alternating local rotations and a global solve (after Sorkine and Alexa 2007,
// per triangle), dense, run to convergence.
std::vector<Vec2> localGlobal(const TriangleMesh& rest, const std::vector<std::int32_t>& hard,
                              const std::vector<Vec2>& targets, std::vector<Vec2> v) {
    const auto n = static_cast<Eigen::Index>(rest.vertices.size());
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
    for (const Triangle& t : rest.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const int i = t[k], j = t[(k + 1) % 3];
            a(i, i) += 1, a(j, j) += 1, a(i, j) -= 1, a(j, i) -= 1;
        }
    }
    for (const std::int32_t h : hard) a.row(h).setZero(), a(h, h) = 1;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu(a);
    double energy = 1e300;
    for (int round = 0; round < 20000; ++round) {
        Eigen::MatrixXd b = Eigen::MatrixXd::Zero(n, 2);
        for (const Triangle& t : rest.triangles) {
            double c = 0, s = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec2 from = rest.vertices[t[(k + 1) % 3]] - rest.vertices[t[k]];
                const Vec2 to = v[t[(k + 1) % 3]] - v[t[k]];
                c += dot(from, to), s += cross(from, to);
            }
            const double l = std::hypot(c, s);
            const Rotation turn{c / l, s / l};
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec2 e = turn.apply(rest.vertices[t[(k + 1) % 3]] - rest.vertices[t[k]]);
                b(t[(k + 1) % 3], 0) += e.x, b(t[(k + 1) % 3], 1) += e.y;
                b(t[k], 0) -= e.x, b(t[k], 1) -= e.y;
            }
        }
        for (std::size_t k = 0; k < hard.size(); ++k)
            b(hard[k], 0) = targets[k].x, b(hard[k], 1) = targets[k].y;
        const Eigen::MatrixXd x = lu.solve(b);
        for (Eigen::Index i = 0; i < n; ++i) v[i] = {x(i, 0), x(i, 1)};
        const double now = arapEnergy(rest, v);
        if (energy - now < 1e-12 * (now + 1e-12)) break;
        energy = now;
    }
    return v;
}

double size(const TriangleMesh& mesh) {
    const Box box = boundsOf(mesh.vertices);
    return std::hypot(box.width(), box.height());
}

}  // namespace

TEST_CASE("rigid motions are reproduced") {
    Random random(11);
    double worst = 0.0;
    for (int k = 0; k < 200; ++k) {
        const TriangleMesh rest = grid(2 + static_cast<int>(random.below(8)),
                                       1 + static_cast<int>(random.below(8)));
        const auto n = static_cast<std::uint32_t>(rest.vertices.size());
        std::vector<std::int32_t> hard{static_cast<std::int32_t>(random.below(n))};
        while (hard.size() < 2 + k % 4) {
            const auto v = static_cast<std::int32_t>(random.below(n));
            if (std::find(hard.begin(), hard.end(), v) == hard.end()) hard.push_back(v);
        }
        std::vector<SoftConstraint> soft;
        for (int s = 0; s < k % 5; ++s)
            soft.push_back(
                {{static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(rest.triangles.size()))),
                  {0.2, 0.3, 0.5}},
                 random.uniform(0.1, 10.0)});
        const Pose pose = poseOf(random.uniform(-3.1, 3.1),
                                 {random.uniform(-1000, 1000), random.uniform(-1000, 1000)});
        std::vector<Vec2> hardTargets, softTargets, out;
        for (const std::int32_t v : hard) hardTargets.push_back(pose.apply(rest.vertices[v]));
        for (const SoftConstraint& s : soft)
            softTargets.push_back(pose.apply(s.point.position(rest.triangles, rest.vertices)));
        ArapSolver solver;
        REQUIRE(solver.setMesh(rest).ok());
        REQUIRE(solver.setConstraints(hard, soft).ok());
        REQUIRE(solver.solve(hardTargets, softTargets, out).ok());
        for (std::size_t v = 0; v < out.size(); ++v)
            worst = std::max(worst, distance(out[v], pose.apply(rest.vertices[v])) / size(rest));
        for (std::size_t h = 0; h < hard.size(); ++h) CHECK(out[hard[h]] == hardTargets[h]);
    }
    MESSAGE("worst error of rigid motions, of the mesh's size: " << worst);
    CHECK(worst < 1e-9);
}

TEST_CASE("energy stays near that of a converged local/global solver") {
    Random random(5);
    double worst = 0.0, sum = 0.0;
    int cases = 0;
    for (int k = 0; k < 40; ++k) {
        const TriangleMesh rest = grid(6, 6);
        const double pull = random.uniform(0.5, 3.0);
        const std::vector<std::int32_t> hard{0, 6, 42, 48};
        std::vector<Vec2> targets;
        for (const std::int32_t v : hard)
            targets.push_back(rest.vertices[v] +
                              Vec2{random.uniform(-pull, pull), random.uniform(-pull, pull)});
        const auto two = deformAsRigidAsPossible(rest, hard, targets);
        REQUIRE(two.ok());
        const double ours = arapEnergy(rest, *two);
        const double best = arapEnergy(rest, localGlobal(rest, hard, targets, *two));
        CHECK(ours >= best * (1 - 1e-9));
        worst = std::max(worst, ours / best);
        sum += ours / best;
        ++cases;
    }
    MESSAGE("energy over that of local/global: mean " << sum / cases << ", worst " << worst);
    CHECK(sum / cases < 1.5);
    CHECK(worst < 3.0);
}

TEST_CASE("the energy vanishes for rigid placements only, and grows with a stretch as it should") {
    const TriangleMesh rest = grid(1, 1);
    std::vector<Vec2> v;
    for (const Vec2 p : rest.vertices) v.push_back(poseOf(1.0, {3, 4}).apply(p));
    CHECK(arapEnergy(rest, v) < 1e-28);
    v = rest.vertices;
    for (Vec2& p : v) p.x *= 1.5;
    // Symmetric stretch keeps the rotation near the identity only where the triangle is symmetric; by hand:
    // S = sum of outer products, best angle 0 for the sum over the triangle's edges turned alike.
    double expected = 1e300;
    for (double angle = -0.5; angle <= 0.5; angle += 1e-4) {
        double one = 0;
        const Pose turn = poseOf(angle, {});
        const Triangle& t = rest.triangles[0];
        for (std::size_t k = 0; k < 3; ++k)
            one += lengthSquared(v[t[(k + 1) % 3]] - v[t[k]] -
                                 turn.apply(rest.vertices[t[(k + 1) % 3]] - rest.vertices[t[k]]));
        expected = std::min(expected, one);
    }
    CHECK(arapEnergy(rest, v) == doctest::Approx(2.0 * expected).epsilon(1e-5));
}

TEST_CASE("soft constraints draw in proportion to their weight") {
    const TriangleMesh rest = grid(6, 2);
    const std::vector<std::int32_t> hard{0, 14};
    double last = 1e300;
    for (const double weight : {0.01, 0.1, 1.0, 10.0, 1000.0}) {
        ArapSolver solver;
        REQUIRE(solver.setMesh(rest).ok());
        const std::vector<SoftConstraint> soft{{{10, {0, 1, 0}}, weight}};
        REQUIRE(solver.setConstraints(hard, soft).ok());
        const std::vector<Vec2> targets{rest.vertices[0], rest.vertices[14]};
        const Vec2 aim = soft[0].point.position(rest.triangles, rest.vertices) + Vec2{0.5, 1.0};
        std::vector<Vec2> out;
        REQUIRE(solver.solve(targets, std::vector<Vec2>{aim}, out).ok());
        const double miss = distance(soft[0].point.position(rest.triangles, out), aim);
        CHECK(miss < last);
        last = miss;
    }
    CHECK(last < 0.01);
}

TEST_CASE("constraints changed and changed back give the same bits as fresh ones") {
    const TriangleMesh rest = grid(8, 8);
    const std::vector<std::int32_t> a{0, 8, 80}, b{3, 40};
    const std::vector<Vec2> targetsA{{0, 1}, {9, 0}, {7, 9}}, targetsB{{2, 2}, {5, 6}};
    std::vector<Vec2> first, other, again;
    ArapSolver solver;
    REQUIRE(solver.setMesh(rest).ok());
    REQUIRE(solver.setConstraints(a, {}).ok());
    REQUIRE(solver.solve(targetsA, {}, first).ok());
    REQUIRE(solver.setConstraints(b, {}).ok());
    REQUIRE(solver.solve(targetsB, {}, other).ok());
    REQUIRE(solver.setConstraints(a, {}).ok());
    REQUIRE(solver.solve(targetsA, {}, again).ok());
    CHECK(first == again);
    CHECK(*deformAsRigidAsPossible(rest, a, targetsA) == first);
}

TEST_CASE("parts without constraints follow rigidly instead of failing") {
    TriangleMesh rest = grid(3, 3);
    const auto n = static_cast<std::int32_t>(rest.vertices.size());
    const TriangleMesh other = grid(2, 2);
    for (const Vec2 p : other.vertices) rest.vertices.push_back(p + Vec2{10, 0});
    for (const Triangle& t : other.triangles) rest.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    const Pose pose = poseOf(0.7, {3, -2});
    for (const std::vector<std::int32_t>& hard : {std::vector<std::int32_t>{0, 15}, {0, n}, {0, 15, n + 1}}) {
        std::vector<Vec2> targets;
        for (const std::int32_t v : hard) targets.push_back(pose.apply(rest.vertices[v]));
        const auto out = deformAsRigidAsPossible(rest, hard, targets);
        REQUIRE(out.ok());
        for (std::size_t v = 0; v < out->size(); ++v)
            CHECK(distance((*out)[v], pose.apply(rest.vertices[v])) < 1e-8);
    }
    // A bow tie: two triangles that share one vertex.
    const TriangleMesh tie{{{0, 0}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, {{0, 1, 2}, {0, 3, 4}}};
    const auto out = deformAsRigidAsPossible(tie, std::vector<std::int32_t>{1, 2},
                                             std::vector<Vec2>{{1, -1}, {1, 1}});
    REQUIRE(out.ok());
    for (std::size_t v = 0; v < 5; ++v) CHECK(distance((*out)[v], tie.vertices[v]) < 1e-9);
}

TEST_CASE("all vertices held") {
    const TriangleMesh rest = grid(1, 1);
    const std::vector<Vec2> targets{{0, 0}, {2, 0}, {0, 1}, {3, 3}};
    CHECK(*deformAsRigidAsPossible(rest, std::vector<std::int32_t>{0, 1, 2, 3}, targets) == targets);
}

TEST_CASE("targets that fall together give finite shapes") {
    const TriangleMesh rest = grid(4, 4);
    const auto out = deformAsRigidAsPossible(rest, std::vector<std::int32_t>{0, 24},
                                             std::vector<Vec2>{{1, 1}, {1, 1}});
    REQUIRE(out.ok());
    for (const Vec2 p : *out) CHECK(isFinite(p));
}

TEST_CASE("bad input is refused by name") {
    ArapSolver solver;
    std::vector<Vec2> out;
    CHECK_FALSE(solver.setConstraints(std::vector<std::int32_t>{0, 1}, {}).ok());
    CHECK_FALSE(solver.solve({}, {}, out).ok());
    CHECK_FALSE(solver.setMesh({}).ok());
    CHECK(solver.setMesh({{{0, 0}, {1, 0}, {2, 0}}, {{0, 1, 2}}}).message().find("triangle 0") !=
          std::string::npos);
    CHECK_FALSE(solver.setMesh({{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 3}}}).ok());
    CHECK_FALSE(solver.setMesh({{{0, 0}, {1, 0}, {0, 1}, {5, 5}}, {{0, 1, 2}}}).ok());
    REQUIRE(solver.setMesh(grid(2, 2)).ok());
    CHECK(solver.setConstraints(std::vector<std::int32_t>{0, 99}, {}).message().find("99") !=
          std::string::npos);
    CHECK(solver.setConstraints(std::vector<std::int32_t>{0, 0}, {}).message().find("twice") !=
          std::string::npos);
    CHECK_FALSE(solver.setConstraints(std::vector<std::int32_t>{0}, {}).ok());
    const std::vector<SoftConstraint> bad{{{0, {1, 0, 0}}, -1.0}};
    CHECK_FALSE(solver.setConstraints(std::vector<std::int32_t>{0, 1}, bad).ok());
    // The same point held hard and softly is one point.
    const std::vector<SoftConstraint> same{{{0, {1, 0, 0}}, 1.0}};
    CHECK_FALSE(solver.setConstraints(std::vector<std::int32_t>{0}, same).ok());
    REQUIRE(solver.setConstraints(std::vector<std::int32_t>{0, 1}, {}).ok());
    CHECK_FALSE(solver.solve(std::vector<Vec2>{{0, 0}}, {}, out).ok());
    CHECK_FALSE(solver.solve(std::vector<Vec2>{{0, 0}, {std::nan(""), 0}}, {}, out).ok());
}

TEST_CASE("time of one solve") {
    for (const int side : {9, 19, 30}) {
        const TriangleMesh rest = grid(side, side);
        const auto last = static_cast<std::int32_t>(rest.vertices.size()) - 1;
        const std::vector<std::int32_t> hard{0, side, last - side, last};
        std::vector<Vec2> targets, out;
        for (const std::int32_t v : hard) targets.push_back(rest.vertices[v] * 1.1);
        ArapSolver solver;
        REQUIRE(solver.setMesh(rest).ok());
        const auto start = std::chrono::steady_clock::now();
        REQUIRE(solver.setConstraints(hard, {}).ok());
        const auto factorised = std::chrono::steady_clock::now();
        for (int k = 0; k < 20; ++k) REQUIRE(solver.solve(targets, {}, out).ok());
        const auto solved = std::chrono::steady_clock::now();
        MESSAGE(rest.vertices.size()
                << " vertices: factorise "
                << std::chrono::duration<double, std::milli>(factorised - start).count() << " ms, solve "
                << std::chrono::duration<double, std::milli>(solved - factorised).count() / 20 << " ms");
    }
}
