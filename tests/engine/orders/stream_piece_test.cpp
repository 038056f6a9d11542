// Marches in one piece, against what can be reckoned: their poses, lengths and the speed of places.
#include "engine/orders/stream_piece.h"

#include <doctest.h>

#include "base/maths.h"
#include "engine/orders/stream.h"
#include "engine/orders/turning.h"

using namespace muster;

namespace {

constexpr double kReach = 5.0;

struct Walked {
    std::vector<Pose> poses;
    bool reversed = false;
};

Walked walk(Turn turn, const Pose& from, const std::vector<Vec2>& way, std::optional<double> facing = {},
            bool reversed = false) {
    Walked walked{{}, reversed};
    listPoses({from, way, turn, facing, kReach}, walked.reversed, walked.poses);
    return walked;
}

double headingOf(const Pose& pose) {
    return arcTangent2(pose.rotation.s, pose.rotation.c);
}

}  // namespace

TEST_CASE("who wheels faces along its way, and no place goes farther than is reckoned") {
    const std::vector<Vec2> way{{0, 0}, {40, 0}, {40, 30}};
    const Walked walked = walk(Turn::Wheel, {}, way);
    StreamPiece piece;
    piece.start(walked.poses, kReach);
    CHECK(piece.at(0.0) == walked.poses.front());
    CHECK(distance(piece.at(1.0).position, {40, 30}) < 1e-9);
    CHECK(headingOf(piece.at(1.0)) == doctest::Approx(kPi / 2));
    CHECK(piece.length() > 65.0);
    CHECK(piece.length() < 70.0 + kReach * kPi / 2 + 0.1);
    for (int k = 0; k < 1000; ++k) {
        const Pose a = piece.at(k / 1000.0), b = piece.at((k + 1) / 1000.0);
        for (int side = 0; side < 16; ++side) {
            const Vec2 rim = Vec2{cosine(side * kPi / 8), sine(side * kPi / 8)} * kReach;
            CHECK(distance(a.apply(rim), b.apply(rim)) <= piece.length() / 1000.0 + 1e-9);
        }
    }
}

TEST_CASE("who reverses does not turn, and faces back") {
    const Walked walked = walk(Turn::Reverse, {}, {{0, 0}, {-20, 0}});
    CHECK(walked.reversed);
    for (const Pose& pose : walked.poses) CHECK(std::fabs(headingOf(pose)) < 1e-12);
    // Back again its front leads.
    CHECK_FALSE(walk(Turn::Reverse, walked.poses.back(), {{-20, 0}, {0, 0}}, {}, true).reversed);
    CHECK(walk(Turn::Wheel, {}, {{0, 0}, {-20, 0}}).poses.back().rotation.c == doctest::Approx(-1.0));
}

TEST_CASE("who keeps its facing turns at the end alone") {
    const std::vector<Vec2> way{{0, 0}, {20, 0}, {20, 30}, {0, 30}};
    for (const Pose& pose : walk(Turn::Keep, {}, way).poses) CHECK(headingOf(pose) == 0.0);
    const Walked turns = walk(Turn::Keep, {}, way, 1.0);
    CHECK(headingOf(turns.poses.back()) == doctest::Approx(1.0));
    CHECK(headingOf(turns.poses[turns.poses.size() - 2]) == 0.0);
}

TEST_CASE("ways of no length and of doubled corners end") {
    for (const Turn turn : {Turn::Wheel, Turn::Reverse, Turn::Keep})
        for (const std::vector<Vec2>& way : {std::vector<Vec2>{{0, 0}}, std::vector<Vec2>{{0, 0}, {0, 0}},
                                             std::vector<Vec2>{{0, 0}, {5, 0}, {5, 0}, {5, 5}, {5, 5}}}) {
            const Walked walked = walk(turn, {}, way, 2.0);
            StreamPiece piece;
            piece.start(walked.poses, kReach);
            CHECK(distance(piece.at(1.0).position, way.back()) < 1e-9);
            const Rotation front = piece.at(1.0).rotation;
            const double sign = walked.reversed ? -1.0 : 1.0;
            CHECK(sign * front.c == doctest::Approx(cosine(2.0)));
            CHECK(sign * front.s == doctest::Approx(sine(2.0)));
            CHECK(isFinite(piece.at(0.5).position));
        }
}

TEST_CASE("a stream in one piece keeps the shape, and is blocked where a place would meet a wall") {
    std::vector<Vec2> offsets, starts, ends;
    for (int row = 0; row < 4; ++row)
        for (int file = 0; file < 3; ++file) offsets.push_back({1.0 * file, 1.0 * row});
    const std::vector<Vec2> way{{0, 0}, {20, 0}, {20, 20}};
    const Walked walked = walk(Turn::Wheel, {}, way);
    for (const Vec2 p : offsets) {
        starts.push_back(p);
        ends.push_back(walked.poses.back().apply(p));
    }
    StreamDef def{offsets, starts, ends, way};
    def.poses = walked.poses;
    for (const bool wall : {false, true}) {
        Stream stream;
        stream.start(def);
        const auto ground = [&](Vec2 p) { return wall ? distance(p, {20, 12}) - 1.0 : 10.0; };
        const StreamStatus status = stream.advance(ground, 1'000'000);
        CHECK(status == (wall ? StreamStatus::Blocked : StreamStatus::Straight));
        if (wall) continue;
        std::vector<Vec2> places(offsets.size());
        for (int k = 0; k <= 20; ++k) {
            stream.at(k / 20.0, places);
            for (std::size_t i = 1; i < places.size(); ++i)
                CHECK(distance(places[i], places[0]) == doctest::Approx(distance(offsets[i], offsets[0])));
        }
    }
}
