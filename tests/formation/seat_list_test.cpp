#include <doctest.h>

#include <algorithm>
#include <set>

#include "base/random.h"
#include "formation/places/seat_list.h"

using namespace muster;

namespace {

constexpr double kApart = 0.5;

using SeatPair = std::pair<std::size_t, std::size_t>;

// Seats that wander together, some of which leap, get lost or are found again from time to time.
struct Seats {
    Random random{7};
    std::vector<Vec2> now;
    std::vector<Vec2> next;
    std::vector<std::uint8_t> fit;

    explicit Seats(std::size_t count) : now(count), fit(count, 1) {
        for (Vec2& p : now) p = anywhere();
        next = now;
    }
    Vec2 anywhere() { return {random.uniform(-6.0, 6.0), random.uniform(-6.0, 6.0)}; }
    Vec2 little(double most) { return {random.uniform(-most, most), random.uniform(-most, most)}; }
    void move(double leaps) {
        const double most = 0.5 * SeatList::slack(kApart);
        for (std::size_t k = 0; k < now.size(); ++k) {
            now[k] = next[k] + Vec2{0.03, 0.01};
            if (random.uniform() < leaps) now[k] = anywhere();
            if (random.uniform() < leaps) fit[k] = fit[k] != 0 ? 0 : 1;
            next[k] = now[k] + little(most);
        }
    }
    bool close(const std::vector<Vec2>& at, std::size_t a, std::size_t b) const {
        return fit[a] != 0 && fit[b] != 0 && lengthSquared(at[a] - at[b]) < kApart * kApart;
    }
    bool taken(Vec2 spot, std::size_t self) const {
        for (std::size_t k = 0; k < now.size(); ++k)
            if (k != self && fit[k] != 0 && lengthSquared(now[k] - spot) < kApart * kApart) return true;
        return false;
    }
};

// Every pair of fit seats that is close now or next must be listed, from both of its seats.
void checkPairs(const Seats& s, const SeatList& list) {
    std::set<SeatPair> pairs, ordered;
    list.forPairs([&](std::size_t a, std::size_t b) { pairs.insert({a, b}); });
    for (std::size_t k = 0; k < s.now.size(); ++k)
        list.forNear(k, [&](std::size_t other) { ordered.insert({k, other}); });
    for (std::size_t a = 0; a < s.now.size(); ++a) {
        for (std::size_t b = a + 1; b < s.now.size(); ++b) {
            if (!s.close(s.now, a, b) && !s.close(s.next, a, b)) continue;
            CHECK(pairs.contains({a, b}));
            CHECK((ordered.contains({a, b}) && ordered.contains({b, a})));
        }
    }
}

}  // namespace

TEST_CASE("a list of seats knows all close pairs and taken spots, few strays or many") {
    for (const double leaps : {0.0, 0.004, 0.02, 0.3}) {
        Seats s(300);
        SeatList list;
        for (int step = 0; step < 40; ++step) {
            s.move(leaps);
            list.update(s.now, s.next, s.fit, kApart);
            checkPairs(s, list);
            for (int k = 0; k < 100; ++k) {
                const Vec2 spot = s.anywhere() * 1.3 + Vec2{0.03, 0.01} * step;
                const std::size_t self = s.random.below(300);
                CHECK(list.occupied(spot, s.now, s.fit, self) == s.taken(spot, self));
            }
        }
    }
}
