#include "people/generator/key_poses.h"
#include "base/maths.h"

#include <doctest.h>

#include "people/generator/crawl.h"
#include "people/generator/measure.h"
#include "people/generator/other_clips.h"

using namespace muster;
using namespace muster::generator;

TEST_CASE("a path rests between equal keys") {
    const PointCurve path({{0.0, {0.0f, 0.0f, 0.0f}},
                           {1.0, {1.0f, 0.0f, 0.5f}},
                           {2.0, {1.0f, 0.0f, 0.5f}},
                           {3.0, {2.0f, 1.0f, 0.0f}}});
    for (double time = 1.0; time <= 2.0; time += 0.1) CHECK(path.at(time) == Vec3{1.0f, 0.0f, 0.5f});
    CHECK(path.at(2.5).x > 1.0f);
    CHECK(path.at(9.0) == Vec3{2.0f, 1.0f, 0.0f});
}

TEST_CASE("hands are held throughout a hold, free well before and after, between two holds on the way") {
    const std::vector<HandContact> holds{{1.0, 2.0, {0.5f, 0.2f, 1.0f}, 0.2, 0.3},
                                         {2.4, 3.0, {0.9f, 0.2f, 1.0f}, 0.3, 0.2}};
    CHECK(reachAt(holds, 0, 0.7).weight == 0.0);
    for (double time : {1.0, 1.5, 2.0}) {
        CHECK(reachAt(holds, 0, time).weight == 1.0);
        CHECK(distance(reachAt(holds, 0, time).wrist, holds[0].wrist) < 1e-5f);
    }
    const Reach between = reachAt(holds, 0, 2.22);
    CHECK(between.weight > 0.0);
    CHECK(between.wrist.x > 0.5f);
    CHECK(between.wrist.x < 0.9f);
    CHECK(distance(reachAt(holds, 0, 2.7).wrist, holds[1].wrist) < 1e-5f);
    CHECK(reachAt(holds, 0, 3.3).weight == 0.0);
    // No jump anywhere.
    for (double time = 0.5; time < 3.5; time += 0.002) {
        const Reach a = reachAt(holds, 0, time), b = reachAt(holds, 0, time + 0.002);
        CHECK(std::fabs(a.weight - b.weight) < 0.05);
        if (a.weight > 0.1 && b.weight > 0.1) CHECK(distance(a.wrist, b.wrist) < 0.02f);
    }
}

TEST_CASE("places on the way are no contacts") {
    std::vector<Contact> contacts;
    addContacts(contacts, 1, {{0.1, 0.2, {}, 0.1, 0.1, false}, {0.5, 0.9, {1.0f, 0.0f, 1.0f}}});
    REQUIRE(contacts.size() == 1);
    CHECK(contacts[0].limb == Limb::RightHand);
    CHECK(contacts[0].begin == 0.5);
}

TEST_CASE("channels with keys follow them, others stay") {
    const BodyKeys keys(
        {{Channel::ChestPitch, {{0.0, 10.0}, {1.0, 30.0}}}, {Channel::HipsZ, {{0.0, 0.9}, {1.0, 0.7}}}});
    ChannelValues base;
    base[Channel::HeadYaw] = 0.3;
    const ChannelValues end = keys.at(1.0, base);
    CHECK(end[Channel::ChestPitch] == doctest::Approx(degrees(30)));
    CHECK(end[Channel::HipsZ] == doctest::Approx(0.7));
    CHECK(end[Channel::HeadYaw] == 0.3);
}

TEST_CASE("the join of a kneeling or swimming leg is that leg") {
    const CrawlTrack crawl;
    const auto crawling = [&](double time) { return crawl.figure(time); };
    const auto swimming = [](double time) { return swimFigure(time); };
    for (const std::function<Figure(double)>& figure :
         {std::function<Figure(double)>(crawling), std::function<Figure(double)>(swimming)}) {
        for (double time : {0.1, 0.4, 0.9}) {
            for (std::size_t side = 0; side < 2; ++side) {
                const LegJoin join = joinOf(figure, side, time);
                const Figure at = figure(time);
                const Vec3 hip = hipJoint(at.body, side);
                const double shin = join.shape.thigh - join.shape.knee;
                CHECK(hip.x + kThigh * sine(join.shape.thigh) + kShin * sine(shin) ==
                      doctest::Approx(at.legs[side].ankle.x).epsilon(1e-3));
                CHECK(hip.z - kThigh * cosine(join.shape.thigh) - kShin * cosine(shin) ==
                      doctest::Approx(at.legs[side].ankle.z).epsilon(1e-3));
                const double pitch = shin + join.shape.ankle;
                CHECK(rotate(at.legs[side].foot, {1.0f, 0.0f, 0.0f}).z ==
                      doctest::Approx(sine(pitch)).epsilon(0.01));
            }
        }
    }
}

TEST_CASE("a crawler's knees lie on the ground while they stay, above it between") {
    const CrawlTrack crawl;
    for (int i = 0; i < 64; ++i) {
        const double time = i / 60.0;
        JointTransforms joints;
        jointTransforms(poseOf(crawl.figure(time)), {}, joints);
        for (std::size_t side = 0; side < 2; ++side) {
            const double phase = time / CrawlTrack::kCycle - (side == 0 ? 0.0 : 0.5);
            const double since = phase - std::floor(phase);
            const float height = joints[index(JointRole::LeftLeg) + 4 * side].translation.z;
            if (since < CrawlTrack::kContact)
                CHECK(height == doctest::Approx(0.065).epsilon(0.02));
            else
                CHECK(height > 0.064f);
        }
    }
}
