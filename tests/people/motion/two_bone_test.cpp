#include "people/motion/two_bone.h"

#include <doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

using namespace muster;

namespace {

/// A leg that hangs straight down, and a hip for it.
TwoBones hangingLeg() {
    return {.root = {0.1f, 0.2f, 0.9f},
            .middle = {0.1f, 0.2f, 0.48f},
            .end = {0.1f, 0.2f, 0.07f},
            .upper = 0.42f,
            .lower = 0.41f};
}

/// Where the end comes when the bones are turned.
Vec3 endOf(const TwoBones& leg, const TwoBoneRotation& turn, Vec3* knee = nullptr) {
    const Vec3 middle = leg.root + rotate(turn.upper, leg.middle - leg.root);
    if (knee != nullptr) *knee = middle;
    return middle + rotate(turn.lower, leg.end - leg.middle);
}

Vec3 anyPoint(float reach) {
    const auto part = [&] { return static_cast<float>(*rc::gen::inRange(-1000, 1001)) * 0.001f * reach; };
    const float x = part(), y = part(), z = part();
    return {x, y, z};
}

}  // namespace

TEST_CASE("a target within reach is reached, and the knee points to its pole") {
    const TwoBones leg = hangingLeg();
    const TwoBoneRotation turn = reach(leg, {0.4f, 0.2f, 0.3f}, {1.0f, 0.0f, 0.0f});
    Vec3 knee;
    CHECK(distance(endOf(leg, turn, &knee), {0.4f, 0.2f, 0.3f}) < 1e-5f);
    CHECK(distance(turn.end, {0.4f, 0.2f, 0.3f}) < 1e-5f);
    const Vec3 straight = normalized(Vec3{0.3f, 0.0f, -0.6f});
    const Vec3 fromHip = knee - leg.root;
    const Vec3 aside = fromHip - straight * dot(fromHip, straight);
    CHECK(aside.x > 0.0f);
    CHECK(std::fabs(aside.y) < 1e-5f);
    // Law of cosines, by hand.
    const double d = std::sqrt(0.45), c = (0.42 * 0.42 + 0.45 - 0.41 * 0.41) / (2.0 * 0.42 * d);
    CHECK(static_cast<double>(dot(fromHip, straight)) == doctest::Approx(0.42 * c).epsilon(1e-4));
}

TEST_CASE("bones keep their lengths and reach as far as they can, whatever is asked") {
    CHECK(rc::check("reach", [] {
        const TwoBones leg = hangingLeg();
        const Vec3 target = leg.root + anyPoint(1.5f), pole = anyPoint(1.0f);
        const TwoBoneRotation turn = reach(leg, target, pole);
        RC_ASSERT(isFinite(turn.end));
        Vec3 knee;
        const Vec3 end = endOf(leg, turn, &knee);
        RC_ASSERT(std::fabs(distance(leg.root, knee) - leg.upper) < 1e-4f);
        RC_ASSERT(std::fabs(distance(knee, end) - leg.lower) < 1e-4f);
        RC_ASSERT(distance(end, turn.end) < 1e-3f);
        const float asked = distance(leg.root, target);
        if (asked > 0.05f)
            RC_ASSERT(distance(turn.end, leg.root + (target - leg.root) * (softReach(asked, 0.83f) / asked)) <
                      1e-4f);
    }));
}

TEST_CASE("the soft reach is exact, then smooth, then short of straight") {
    CHECK(softReach(0.5f, 0.83f) == 0.5f);
    CHECK(softReach(kSoftReach * 0.83f, 0.83f) == doctest::Approx(kSoftReach * 0.83f));
    float before = 0.0f, slopeBefore = 1.0f;
    for (int k = 1; k <= 2000; ++k) {
        const float d = 0.001f * static_cast<float>(k), now = softReach(d, 0.83f);
        const float slope = (now - before) / 0.001f;
        CHECK(now >= before);
        CHECK(now < 0.83f);
        CHECK(slope <= slopeBefore + 2e-3f);
        before = now;
        slopeBefore = slope;
    }
    CHECK(softReach(0.823f, 0.83f) > 0.8215f);  // Little is lost where a leg is nearly straight.
}

TEST_CASE("a target at the hip and a pole along the leg do no harm") {
    const TwoBones leg = hangingLeg();
    for (const Vec3 target : {leg.root, leg.root + Vec3{0.0f, 0.0f, -0.5f}}) {
        const TwoBoneRotation turn = reach(leg, target, {0.0f, 0.0f, -1.0f});
        CHECK(isFinite(endOf(leg, turn)));
        CHECK(std::fabs(dot(turn.upper, turn.upper) - 1.0f) < 1e-4f);
        CHECK(std::fabs(dot(turn.lower, turn.lower) - 1.0f) < 1e-4f);
    }
}

TEST_CASE("The middle joint turns by no more than it may, and by all of it where more is wanted") {
    Random random(21);
    int held = 0;
    for (int i = 0; i < 2000; ++i) {
        TwoBones leg{.upper = 0.42f, .lower = 0.41f};
        const auto at = [&](double bend) {
            return std::sqrt(leg.upper * leg.upper + leg.lower * leg.lower +
                             2.0 * leg.upper * leg.lower * std::cos(bend));
        };
        const double before = random.uniform(0.0, 2.8), wanted = random.uniform(0.0, 2.8),
                     most = random.uniform(0.05, 0.5);
        const Vec3 way = normalized(Vec3{static_cast<float>(random.uniform(-1.0, 1.0)), 0.3f, -1.0f});
        const Vec3 target = way * static_cast<float>(at(wanted));
        const auto cosineBefore = static_cast<float>(-std::cos(before));  // Of the angle between the bones.
        const Vec3 paced = pacedTarget(leg, target, cosineBefore, static_cast<float>(most));
        const double expected = std::clamp(wanted, before - most, before + most);
        CHECK(length(paced) == doctest::Approx(at(std::max(0.0, expected))).epsilon(2e-3));
        CHECK(distance(normalized(paced), way) < 1e-4f);
        if (expected == wanted)
            CHECK(paced == target);
        else
            ++held;
    }
    CHECK(held > 500);
    CHECK(pacedTarget({{}, {}, {}, 0.4f, 0.4f}, {}, 0.0f, 0.1f) == Vec3{});
}
