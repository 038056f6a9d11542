#include "base/token_bucket.h"

#include <doctest.h>

#include <algorithm>
#include <vector>

#include "base/random.h"

using namespace muster;

namespace {

/// The same limit by another algorithm: virtual scheduling (generic cell rate algorithm, ITU-T I.371). An
/// event conforms where it is no more than the tolerance ahead of its theoretical time.
class VirtualSchedule {
public:
    VirtualSchedule(double rate, double burst) : interval_(1.0 / rate), tolerance_((burst - 1.0) / rate) {}
    bool take(double now) {
        if (expected_ - now > tolerance_) return false;
        expected_ = std::max(now, expected_) + interval_;
        return true;
    }

private:
    double interval_, tolerance_;
    double expected_ = 0.0;
};

}  // namespace

TEST_CASE("a full bucket lets its burst through at once, then one token per interval") {
    TokenBucket bucket(4.0, 3.0);
    for (int i = 0; i < 3; ++i) CHECK(bucket.take(0.0));
    CHECK(!bucket.take(0.0));
    CHECK(!bucket.take(0.125));
    CHECK(bucket.take(0.25));
    CHECK(!bucket.take(0.25));
    // However long nothing happens, no more than the burst is saved up.
    for (int i = 0; i < 3; ++i) CHECK(bucket.take(1000.0));
    CHECK(!bucket.take(1000.0));
}

TEST_CASE("several tokens are taken together or not at all") {
    TokenBucket bucket(1.0, 8.0);
    CHECK(!bucket.take(0.0, 9.0));
    CHECK(bucket.take(0.0, 8.0));
    CHECK(!bucket.take(2.0, 3.0));
    CHECK(bucket.take(2.0, 2.0));  // The refusal took none.
    CHECK(!bucket.take(100.0, 8.5));
    CHECK(bucket.take(100.0, 0.0));
    CHECK(bucket.take(100.0, 8.0));
}

TEST_CASE("decisions are those of a virtual schedule") {
    // Rates and times are multiples of powers of two, so both algorithms compute without rounding.
    Random random(21);
    for (const double rate : {0.5, 4.0, 64.0}) {
        for (const double burst : {1.0, 2.0, 5.0, 16.0}) {
            TokenBucket bucket(rate, burst);
            VirtualSchedule schedule(rate, burst);
            double now = 0.0;
            int passed = 0, refused = 0;
            for (int i = 0; i < 3000; ++i) {
                now += random.below(16) == 0 ? random.below(16) / rate : random.below(3) / (4.0 * rate);
                const bool expected = schedule.take(now);
                CHECK(bucket.take(now) == expected);
                ++(expected ? passed : refused);
            }
            CHECK(passed > 100);
            CHECK(refused > 100);
        }
    }
}

TEST_CASE("in no interval does more pass than the burst and the rate times its length") {
    Random random(4);
    const double rate = 3.0, burst = 5.0;
    TokenBucket bucket(rate, burst);
    std::vector<std::pair<double, double>> passed;
    double now = 0.0;
    for (int i = 0; i < 600; ++i) {
        now += random.uniform(0.0, 0.4);
        const double tokens = random.uniform(0.1, 3.0);
        if (bucket.take(now, tokens)) passed.push_back({now, tokens});
    }
    REQUIRE(passed.size() > 50);
    for (std::size_t i = 0; i < passed.size(); ++i) {
        double sum = 0.0;
        for (std::size_t j = i; j < passed.size(); ++j) {
            sum += passed[j].second;
            REQUIRE(sum <= burst + rate * (passed[j].first - passed[i].first) + 1e-9);
        }
    }
}
