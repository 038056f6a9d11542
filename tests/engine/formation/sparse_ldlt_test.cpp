#include <doctest.h>

#include "base/random.h"
#include "engine/formation/mesh/sparse_ldlt.h"

using namespace muster;

namespace {

// A symmetric matrix with a heavy diagonal, some rows of which come in pairs.
std::vector<SparseEntry> randomMatrix(Random& random, int size) {
    std::vector<SparseEntry> entries;
    for (int i = 0; i < size; ++i) entries.emplace_back(i, i, 20.0);
    for (int k = 0; k < 4 * size; ++k) {
        const int a = static_cast<int>(random.below(static_cast<std::uint32_t>(size)));
        const int b = static_cast<int>(random.below(static_cast<std::uint32_t>(size)));
        const double value = random.uniform(-1.0, 1.0);
        entries.emplace_back(a, b, value);
        entries.emplace_back(b, a, value);
    }
    return entries;
}

}  // namespace

TEST_CASE("two right sides solved at once get the bits of each alone, and both solve the system") {
    Random random(3);
    for (const int size : {1, 2, 7, 40, 120}) {
        const std::vector<SparseEntry> entries = randomMatrix(random, size);
        SparseLdlt factor;
        REQUIRE(factor.factorise(size, entries));
        std::vector<double> x, y;
        std::vector<Vec2> both;
        for (int i = 0; i < size; ++i) {
            x.push_back(random.uniform(-1.0, 1.0));
            y.push_back(random.uniform(-1.0, 1.0));
            both.push_back({x.back(), y.back()});
        }
        std::vector<double> left = x;
        factor.solve(x);
        factor.solve(y);
        factor.solve(both);
        for (std::size_t i = 0; i < x.size(); ++i) CHECK(both[i] == Vec2{x[i], y[i]});
        for (const SparseEntry& e : entries) left[e.row()] -= e.value() * x[e.col()];
        for (const double rest : left) CHECK(std::fabs(rest) < 1e-12);
    }
}
