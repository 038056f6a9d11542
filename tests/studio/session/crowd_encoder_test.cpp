// The delta encoding of the crowd: the first frame is complete, later frames hold the changes, within eight
// bytes per character for ten thousand.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.h"
#include "studio/session/frames/crowd_encoder.h"
#include "studio/session/frames/places_encoder.h"
#include "studio/session/page_decoder.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr double kTurn = 6.283185307179586;

/// A walking crowd: a block on a lattice whose characters have their own paces and headings.
class Walkers {
public:
    Walkers(std::size_t count, double spacing) {
        const auto across = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
        for (std::size_t i = 0; i < count; ++i) {
            position.push_back(
                {spacing * static_cast<double>(i % across), spacing * static_cast<double>(i / across)});
            heading.push_back(random_.uniform() * 0.8);
            speed.push_back(0.8 + random_.uniform());
        }
        picture.place(position);
    }

    /// Moves all characters for that time; some change their clips as often as real characters do.
    void walk(double seconds) {
        for (std::size_t i = 0; i < position.size(); ++i) {
            heading[i] += (random_.uniform() - 0.5) * 0.1;
            position[i] += Vec2{std::cos(heading[i]), std::sin(heading[i])} * (speed[i] * seconds);
        }
        picture.place(position);
        for (std::size_t i = 0; i < position.size(); ++i) {
            picture.heading[i] = static_cast<std::uint16_t>(std::lround(heading[i] / kTurn * 65536.0) &
                                                            65535);
            picture.phase[i] = static_cast<std::uint16_t>(picture.phase[i] + 1900);
            if (random_.uniform() < 1.4 * seconds)
                picture.clip[i] = static_cast<std::uint8_t>(random_.uniform() * 29.0);
        }
    }

    /// Selects that many characters for whole poses.
    void look(std::uint32_t count) {
        picture.near.clear();
        for (std::uint32_t k = 0; k < count; ++k) picture.near.push_back(k);
        picture.nearPlaces.assign(3 * count, 1.0f);
        picture.nearPoses.assign((3 + 3 * kJointCount) * count, 7);
    }

    std::vector<Vec2> position;
    std::vector<double> heading, speed;
    CrowdPicture picture;

private:
    Random random_{42};
};

/// An encoder and the page that decodes its frames.
struct Link {
    CrowdEncoder encoder;
    PageDecoder decoder;
    protocol::Frame frame;

    const PageFrame& send(const CrowdPicture& picture, bool restart) {
        frame.ids.clear();
        frame.group.clear();
        for (std::uint32_t i = 0; restart && i < picture.size(); ++i)
            frame.ids.push_back(i + 1), frame.group.push_back(0);
        encoder.encode(picture, restart, frame.crowd);
        const auto bytes = protocol::encode(frame);
        const auto read = protocol::decodeServer(bytes);
        REQUIRE(read.ok());
        return decoder.take(std::get<protocol::Frame>(read.value()));
    }
};

void checkSame(const PageFrame& page, const Walkers& crowd, double within) {
    REQUIRE(page.x.size() == crowd.position.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < page.x.size(); ++i)
        worst = std::max(
            {worst, std::fabs(page.x[i] - crowd.position[i].x), std::fabs(page.y[i] - crowd.position[i].y)});
    CHECK(worst <= within);
    CHECK(page.clip == crowd.picture.clip);
}

double worstTurn(const PageFrame& page, const Walkers& crowd) {
    double worst = 0.0;
    for (std::size_t i = 0; i < page.heading.size(); ++i)
        worst = std::max(worst, std::fabs(std::remainder(page.heading[i] - crowd.heading[i], kTurn)));
    return worst;
}

}  // namespace

TEST_CASE("A hundred characters are decoded within half a millimetre, for as long as they walk") {
    Walkers crowd(100, 1.0);
    Link link;
    std::size_t whole = 0;
    for (int frame = 0; frame < 600; ++frame) {
        crowd.walk(1.0 / 60.0);
        const PageFrame& page = link.send(crowd.picture, frame == 0);
        checkSame(page, crowd, 0.00051);
        CHECK(worstTurn(page, crowd) < kTurn / 65536.0);
        whole += link.frame.crowd.stepX.empty() ? 1u : 0u;
    }
    CHECK(whole >= 1);
    CHECK(whole < 5);  // These are the frames in which the lattice moved with the crowd.
}

TEST_CASE("Ten thousand walking characters take eight bytes each, including whole poses, mesh and places") {
    Walkers crowd(10'000, 1.0);
    crowd.look(100);
    Link link;
    PlacesEncoder places;
    PlacesPicture placed;
    placed.offsets.assign(20'000, 0);
    placed.unfit.assign(1'250, 0);
    protocol::GroupFrame& group = link.frame.groups.emplace_back();
    group.vertices.assign(2 * 400, 1.0f);
    protocol::GroupMesh mesh{.group = group.id, .triangles = {0, 1, 2}};
    mesh.placeTriangles.assign(10'000, 0);
    mesh.placeWeights.assign(20'000, 0.25f);
    link.decoder.take(mesh);
    std::size_t most = 0;
    for (int frame = 0; frame < 60; ++frame) {
        crowd.walk(1.0 / 30.0);
        for (std::size_t k = 0; k < placed.offsets.size(); ++k)
            placed.offsets[k] = static_cast<std::int16_t>(frame + static_cast<int>(k % 7));
        placed.unfit[frame] = 255;
        places.encode(placed, group);
        const PageFrame& page = link.send(crowd.picture, frame == 0);
        checkSame(page, crowd, 0.00196);
        CHECK(worstTurn(page, crowd) <= 0.51 * kTurn / 256.0);
        if (frame > 0) most = std::max(most, protocol::encode(link.frame).size());
    }
    MESSAGE("measured: a frame of 10,000 takes at most ", static_cast<double>(most) / 10'000.0,
            " bytes for each");
    CHECK(most <= 80'000);
}

TEST_CASE("Across a kilometre decoded positions are within a centimetre") {
    Walkers crowd(10'000, 10.0);
    Link link;
    checkSame(link.send(crowd.picture, true), crowd, 0.0157);
    crowd.walk(0.1);
    checkSame(link.send(crowd.picture, false), crowd, 0.0157);
    CHECK(crowd.picture.lattice.quantum() <= 1.0 / 32.0);
}

TEST_CASE(
    "A character moved far away arrives in the next frame; where all move far, whole positions are sent") {
    Walkers crowd(64, 1.0);
    Link link;
    link.send(crowd.picture, true);
    crowd.position[3] = {7.5, 3.25};
    crowd.position[63] = {0.0, 0.5};
    crowd.picture.place(crowd.position);
    checkSame(link.send(crowd.picture, false), crowd, 0.00051);
    CHECK(link.frame.crowd.jumped.size() == 2);
    for (Vec2& p : crowd.position) p = {7.0 - p.x, p.y};
    crowd.picture.place(crowd.position);
    checkSame(link.send(crowd.picture, false), crowd, 0.00051);
    CHECK(link.frame.crowd.stepX.empty());
    CHECK(link.frame.crowd.x.size() == 64);
}

TEST_CASE("A standing character keeps its exact position while the lattice moves on with the others") {
    Walkers crowd(2, 1.0);
    crowd.picture.place(crowd.position);
    const double before = crowd.picture.lattice.corner().x +
                          crowd.picture.x[0] * crowd.picture.lattice.quantum();
    int moves = 0;
    for (int k = 0; k < 400; ++k) {
        const Vec2 corner = crowd.picture.lattice.corner();
        crowd.position[1].x += 0.1;
        crowd.picture.place(crowd.position);
        moves += crowd.picture.lattice.corner() == corner ? 0 : 1;
        const double now = crowd.picture.lattice.corner().x +
                           crowd.picture.x[0] * crowd.picture.lattice.quantum();
        CHECK(now == before);
    }
    CHECK(moves >= 1);
}

TEST_CASE("A crowd that grows, shrinks or becomes empty is sent completely") {
    Link link;
    for (const std::size_t count : {3u, 8u, 0u, 5u}) {
        const Walkers crowd(count, 1.0);
        checkSame(link.send(crowd.picture, true), crowd, 0.00051);
        checkSame(link.send(crowd.picture, false), crowd, 0.00051);
    }
}

TEST_CASE("Long clips have fine phases in large crowds too") {
    Walkers crowd(2'000, 1.0);
    Link link;
    link.send(crowd.picture, true);
    CHECK(link.frame.crowd.phaseFine.empty());
    crowd.picture.longClips = true;
    link.send(crowd.picture, false);
    CHECK(link.frame.crowd.phaseFine.size() == 2'000);
    CHECK(link.frame.crowd.headingFine.empty());
}

TEST_CASE("Changed places are sent in cyclic order, each within a few frames and once") {
    PlacesEncoder encoder;
    PlacesPicture picture;
    picture.offsets.assign(2 * 3'000, 5);
    picture.unfit.assign(375, 0);
    picture.unfit[2] = 129;
    protocol::GroupFrame frame;
    std::vector<int> sentCount(3'000, 0);
    for (int k = 0; k < 4; ++k) {
        encoder.encode(picture, frame);
        CHECK(frame.moved.size() == (k < 3 ? 1'000u : 0u));
        CHECK(frame.offsets.size() == 2 * frame.moved.size());
        CHECK(frame.unfit.size() == (k == 0 ? 375u : 0u));
        for (const std::uint32_t place : frame.moved) ++sentCount[place];
    }
    CHECK(std::all_of(sentCount.begin(), sentCount.end(), [](int times) { return times == 1; }));
    picture.offsets[2 * 17 + 1] = -9;
    encoder.encode(picture, frame);
    CHECK(frame.moved == std::vector<std::uint32_t>{17});
    CHECK(frame.offsets == std::vector<std::int16_t>{5, -9});
    encoder = {};
    encoder.encode(picture, frame);
    CHECK(frame.moved.size() == 1'000);
}
