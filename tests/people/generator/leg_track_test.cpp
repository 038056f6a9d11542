#include "people/generator/leg_track.h"

#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "people/generator/gait.h"
#include "people/generator/measure.h"

using namespace muster;
using namespace muster::generator;

namespace {

/// Hips at one height that go ahead at 1 m/s.
Course evenCourse() {
    Course course;
    course.travel = straight([](double time) { return time; });
    course.body = [](double) {
        ChannelValues body;
        body[Channel::HipsZ] = 0.9;
        return body;
    };
    return course;
}

Step stepAt(double begin, double end, float x) {
    Step step;
    step.begin = begin;
    step.end = end;
    step.anchor = {x, 0.09f, 0.08f};
    step.strike = degrees(15);
    step.flat = 0.08;
    step.rise = 0.15;
    step.push = degrees(45);
    step.swing = {{}, {{0.4, degrees(70)}}, {}};
    return step;
}

std::vector<Step> twoSteps() {
    return {stepAt(-0.3, 0.3, 0.0f), stepAt(0.7, 1.3, 1.0f)};
}

/// Speed of the ankle at a time, from both sides [m/s].
Vec3 rateOf(const LegTrack& track, double time, double step) {
    return (track.at(time + step).ankle - track.at(time).ankle) * static_cast<float>(1.0 / step);
}

}  // namespace

TEST_CASE("a standing foot moves against the travel, and nothing else") {
    const LegTrack track(0, twoSteps(), evenCourse());
    for (double time = -0.2; time < 0.14; time += 0.02) {
        const Leg leg = track.at(time);
        CHECK(leg.ankle.x == doctest::Approx(-time).epsilon(1e-4));
        CHECK(leg.ankle.y == doctest::Approx(0.09));
        CHECK(leg.ankle.z == doctest::Approx(0.08));
    }
}

TEST_CASE("swings take over place and speed at both ends") {
    const LegTrack track(0, twoSteps(), evenCourse());
    for (double edge : {0.3, 0.7}) {
        const Vec3 before = rateOf(track, edge, -1e-3), after = rateOf(track, edge, 1e-3);
        CHECK(distance(track.at(edge - 1e-5).ankle, track.at(edge + 1e-5).ankle) < 1e-3f);
        CHECK(distance(before, after) < 0.6f);
    }
}

TEST_CASE("feet that swing keep above the ground") {
    const LegTrack track(0, twoSteps(), evenCourse());
    for (double time = 0.31; time < 0.70; time += 0.01) {
        const Leg leg = track.at(time);
        const double heel = leg.ankle.z + rotate(leg.foot, kHeel).z;
        const double tip = leg.ankle.z + (leg.toe < 0.0 ? 1.0f : rotate(leg.foot, kToeTip).z);
        CHECK(std::min(heel, tip) > -1e-3);
    }
}

TEST_CASE("a track joined in mid-swing goes on as the other one would") {
    const GaitTrack gait(gaitOf(GaitKind::Run));
    const LegTrack whole = gait.leg(0);
    const double join = 0.5 * gait.gait().cycle;
    REQUIRE(whole.at(join).ankle.z > 0.2f);
    const LegTrack joined(0, gait.steps(0, -1, 2), gait.course(), whole.join(join));
    CHECK(distance(joined.at(join + 1e-6).ankle, whole.at(join + 1e-6).ankle) < 1e-3f);
    CHECK(distance(rateOf(joined, join + 1e-6, 1e-3), rateOf(whole, join + 1e-6, 1e-3)) < 0.2f);
    // And lands where it would.
    const double landing = gait.landing(0, 1);
    CHECK(distance(joined.at(landing).ankle, whole.at(landing).ankle) < 1e-5f);
}

TEST_CASE("before its first and after its last step a foot stands") {
    const LegTrack track(0, twoSteps(), evenCourse());
    CHECK(track.at(-5.0).ankle.x == doctest::Approx(5.0).epsilon(0.01));
    CHECK(track.at(9.0).ankle.z > 0.079f);
}

TEST_CASE("a runner's hips fall and rise without a jump of speed or force") {
    const GaitTrack gait(gaitOf(GaitKind::Run));
    const auto z = [&](double time) { return gait.body(time)[Channel::HipsZ]; };
    const double stay = gait.gait().contact * gait.gait().cycle, h = 1e-4;
    for (double edge : {0.0, stay, 0.5 * gait.gait().cycle}) {
        const double before = (z(edge - h) - z(edge - 2.0 * h)) / h,
                     after = (z(edge + 2.0 * h) - z(edge + h)) / h;
        CHECK(before == doctest::Approx(after).epsilon(0.02));
    }
    CHECK(z(stay) - z(0.0) == doctest::Approx(gait.gait().lift).epsilon(1e-6));
}

TEST_CASE("steps of a bend lie on both sides of its circle and turn with it") {
    const double radius = 2.5;
    const GaitTrack gait(bent(gaitOf(GaitKind::Jog), radius));
    const Vec3 centre{0.0f, static_cast<float>(radius), 0.08f};
    const auto left = gait.steps(0, 0, 2), right = gait.steps(1, 0, 2);
    for (std::size_t i = 0; i < left.size(); ++i) {
        CHECK(distance(left[i].anchor, centre) < distance(right[i].anchor, centre));
        CHECK(std::fabs(distance(left[i].anchor, centre) - radius) < 0.25);
    }
    CHECK(left[1].yaw - left[0].yaw == doctest::Approx(gait.gait().speed * gait.gait().cycle / radius));
}

TEST_CASE("no joint of any clip spins") {
    for (const Clip& clip : ownClips().clips) {
        double most = 0.0;
        for (std::size_t i = 1; i < clip.poses.size(); ++i)
            for (std::size_t j = 0; j < kJointCount; ++j)
                most = std::max(
                    most, angleBetween(clip.poses[i - 1].rotation[j], clip.poses[i].rotation[j]) * clip.rate);
        // Arms that push out of the water are the fastest.
        CHECK_MESSAGE(most < (clip.name == "swim-exit" ? 45.0 : 25.0), clip.name << ": " << most << " rad/s");
    }
}
