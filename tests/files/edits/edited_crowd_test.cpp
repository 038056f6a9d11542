// The crowd of a take as its edits show it.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/maths.h"
#include "files/edits/edited_crowd.h"
#include "muster/motion.h"
#include "people/motion/motion_report.h"

using namespace muster;

namespace {

constexpr std::uint32_t kSteps = 720;

/// Two groups that cross, a pool beside the way, and nobody at the keys.
Take crossing() {
    WorldDef def{.name = "Crossing", .box = {{-20, -12}, {20, 12}}};
    GroupDef east{.count = 9, .position = {-12, 0}}, west{.count = 9, .position = {12, 1}};
    east.orders = {Order::move({12, 0})};
    west.orders = {Order::move({-12, 1})};
    def.groups = {east, west};
    PatchDef pool{.name = "Pool", .polygon = {{-4, 4}, {4, 4}, {4, 10}, {-4, 10}}};
    pool.motion = 4;  // swim
    def.patches = {pool};
    Take take;
    take.def = def;
    take.finished = true;
    auto world = World::create(def);
    REQUIRE(world.ok());
    for (std::uint32_t step = 0; step < kSteps; ++step) {
        world->step();
        if (world->stepCount() % kTakeMarkSpacing == 0)
            take.marks.push_back({world->stepCount(), world->hash(), 0});
    }
    return take;
}

/// How the crowd of a take is shown in each step.
struct Showing {
    std::vector<std::vector<MotionState>> states;
    std::vector<std::vector<BodyPose>> poses;
    std::vector<std::vector<Vec2>> worlds;  ///< Simulated positions.
    std::vector<std::vector<ShownCharacter>> shown;
    MotionFigures feet;
    std::uint32_t marks = 0;
};

Showing showing(const Take& take, const std::vector<TakeEdit>& edits) {
    Take edited = take;
    edited.about.edits = edits;
    auto tracks = gatherTracks(edited, kSteps / 60.0, 1, ReplayFrom::Simulation);
    REQUIRE_MESSAGE(tracks.ok(), tracks.status().message());
    EditedCrowd crowd(edits, ownClips());
    crowd.setTracks(std::make_shared<const OwnTracks>(std::move(tracks).value()));
    CrowdMotion motion(ownClips());
    MotionReport report;
    Showing all;
    const auto result = replayTake(edited, 1, [&](const World& world) {
        const auto shown = crowd.shown(world);
        motion.update(world, shown);
        report.observe(world, motion);
        all.states.emplace_back(motion.states().begin(), motion.states().end());
        all.shown.emplace_back(shown.begin(), shown.end());
        auto& poses = all.poses.emplace_back();
        for (std::size_t k = 0; k < motion.near().size(); ++k) poses.push_back(motion.pose(k));
        const auto now = world.characters().position;
        all.worlds.emplace_back(now.begin(), now.end());
        return true;
    });
    REQUIRE_MESSAGE(result.ok(), result.status().message());
    all.marks = result->compared;
    all.feet = report.figures();
    return all;
}

bool same(const MotionState& a, const MotionState& b) {
    return a.clip == b.clip && a.fromClip == b.fromClip && a.time == b.time && a.fromTime == b.fromTime &&
           a.fade == b.fade && a.position == b.position && a.yaw == b.yaw && a.size == b.size;
}

double stepped(const Showing& all, std::size_t i) {
    double most = 0.0;
    for (std::size_t s = 1; s < all.states.size(); ++s)
        most = std::max(most, distance(all.states[s][i].position, all.states[s - 1][i].position));
    return most * 60.0;
}

TEST_CASE("edited crowd: others keep every bit over a whole take, and the recording is still proved") {
    const Take take = crossing();
    const Showing plain = showing(take, {});
    const std::vector<TakeEdit> edits{
        {{1}, {{4.0, {0.0, 3.0}, 2.5}}, {}, {{"run", 2.0, 5.0}}, {{0, {5.0, 5.0}, 1.5, 1.0, 8.0}}},
        {{12, 15}, {{5.0, {1.0, 6.0}, 3.0}}, {{1.0, 1.0}, {5.0, 3.5}}, {}, {{1, {}, 1.6, 0.0, 12.0}}}};
    const Showing edited = showing(take, edits);
    CHECK(edited.marks == kSteps / kTakeMarkSpacing);
    for (std::size_t s = 0; s < kSteps; ++s) {
        REQUIRE(edited.worlds[s] == plain.worlds[s]);
        for (std::size_t i = 0; i < plain.states[s].size(); ++i) {
            const bool chosen = i == 0 || i == 11 || i == 14;
            if (chosen) continue;
            REQUIRE(same(edited.states[s][i], plain.states[s][i]));
            REQUIRE(edited.poses[s][i].rotation == plain.poses[s][i].rotation);
            REQUIRE(edited.poses[s][i].hips == plain.poses[s][i].hips);
        }
    }
    // Removed edits leave nothing behind, also of the edited.
    const Showing again = showing(take, {});
    for (std::size_t s = 0; s < kSteps; ++s)
        for (std::size_t i = 0; i < 18; ++i) REQUIRE(same(again.states[s][i], plain.states[s][i]));
}

TEST_CASE("edited crowd: a pin is met at its moment, nothing moves beyond it, and feet do not slide") {
    const Take take = crossing();
    const Showing plain = showing(take, {});
    const Showing edited = showing(take, {{{2}, {{6.0, {0.5, 2.0}, 3.0}}, {}, {}, {}}});
    for (std::size_t s = 0; s < kSteps; ++s) {
        const double time = (static_cast<double>(s) + 1.0) / 60.0;
        const Vec2 was = plain.states[s][1].position, is = edited.states[s][1].position;
        if (std::fabs(time - 6.0) < 1e-9) CHECK(distance(is, was + Vec2{0.5, 2.0}) < 1e-12);
        if (std::fabs(time - 6.0) > 3.0) REQUIRE(is == was);
    }
    CHECK(stepped(edited, 1) < stepped(plain, 1) + 1.875 * length(Vec2{0.5, 2.0}) / 3.0 + 1e-6);
    CHECK(edited.feet.slide95 <= 0.02);
    CHECK(edited.feet.kneeMax < 20.05);
    CHECK(edited.feet.penetration <= 0.01);
    // Half way to the pin it goes to the left of its way.
    const std::size_t half = 60 * 9 / 2 - 1;
    const float turn = edited.states[half][1].yaw - plain.states[half][1].yaw;
    CHECK(turn > 0.1f);
}

TEST_CASE("edited crowd: whoever is led into water swims there, as the ground asks") {
    const Take take = crossing();
    const Showing edited = showing(take, {{{1, 2, 3}, {{5.0, {0.0, 6.5}, 4.0}}, {}, {}, {}}});
    std::size_t swims = 0, wet = 0;
    for (std::size_t s = 0; s < kSteps; ++s)
        for (std::size_t i = 0; i < 3; ++i) {
            const MotionState& state = edited.states[s][i];
            const Vec2 at = state.position;
            const bool in = at.x > -3 && at.x < 3 && at.y > 5.2 && at.y < 9.5;
            const ShownCharacter& one = edited.shown[s][i];
            CHECK((!in || one.patch != 0));
            if (in) ++wet;
            if (in && ownClips().clips[state.clip].motion == "swim") ++swims;
        }
    REQUIRE(wet > 60);
    CHECK(swims > wet * 3 / 4);
}

TEST_CASE("edited crowd: an own clock shows the same path at other times, without jumps") {
    const Take take = crossing();
    const Showing plain = showing(take, {});
    // From 2 s on it falls behind, and goes on two seconds late.
    const Showing late = showing(take, {{{5}, {}, {{2.0, 2.0}, {6.0, 4.0}}, {}, {}}});
    for (std::size_t s = 0; s < kSteps; ++s) {
        const std::size_t i = 4;
        if (s + 1 <= 120) REQUIRE(late.states[s][i].position == plain.states[s][i].position);
        if (s + 1 >= 360)
            REQUIRE(distance(late.states[s][i].position, plain.states[s - 120][i].position) < 1e-9);
    }
    CHECK(stepped(late, 4) <= stepped(plain, 4) + 1e-9);
    CHECK(late.feet.slide95 <= 0.02);
}

TEST_CASE("edited crowd: a chosen clip plays in its time, and a head turns to what it looks at") {
    const Take take = crossing();
    const auto duck = static_cast<std::uint16_t>(ownClips().indexOf("duck"));
    const Showing plain = showing(take, {});
    const Vec2 point{0.0, 9.0};
    const Showing edited = showing(
        take, {{{3}, {}, {}, {{"duck", 3.0, 6.0}}, {}}, {{4}, {}, {}, {}, {{0, point, 1.6, 3.0, 6.0}}}});
    for (std::size_t s = 185; s < 359; ++s) REQUIRE(edited.states[s][2].clip == duck);
    std::size_t ducks = 0;
    for (std::size_t s = 400; s < kSteps; ++s) ducks += edited.states[s][2].clip == duck ? 1u : 0u;
    CHECK(ducks == 0);
    for (std::size_t s = 0; s < kSteps; ++s)
        REQUIRE(edited.states[s][2].position == plain.states[s][2].position);
    // The head's forward axis points where it looks, or as far as a neck turns.
    const auto facing = [&](const Showing& all, std::size_t s) {
        JointTransforms joints;
        worldJoints(all.states[s][3], all.poses[s][3], joints);
        const Transform& head = joints[index(JointRole::Head)];
        const Vec3 way = rotate(head.rotation, {1.0f, 0.0f, 0.0f});
        return std::atan2(way.y, way.x);
    };
    const std::size_t at = 300;
    const MotionState& state = edited.states[at][3];
    const Vec2 away = point - state.position;
    const double wanted = std::remainder(std::atan2(away.y, away.x) - state.yaw, 2.0 * kPi);
    const double expected = std::clamp(wanted, -75.0 / 180.0 * kPi, 75.0 / 180.0 * kPi);
    CHECK(std::fabs(std::remainder(facing(edited, at) - state.yaw - expected, 2.0 * kPi)) < 0.2);
    CHECK(std::fabs(std::remainder(facing(plain, at) - state.yaw, 2.0 * kPi)) < 0.3);
    for (std::size_t s = 1; s < kSteps; ++s)
        CHECK(std::fabs(std::remainder(facing(edited, s) - facing(edited, s - 1), 2.0 * kPi)) < 0.15);
    for (std::size_t s = 480; s < kSteps; ++s)
        CHECK(std::fabs(std::remainder(facing(edited, s) - facing(plain, s), 2.0 * kPi)) < 0.01);
    // Feet stay as they were.
    for (std::size_t s = 0; s < kSteps; ++s)
        CHECK(edited.poses[s][3].rotation[index(JointRole::LeftFoot)] ==
              plain.poses[s][3].rotation[index(JointRole::LeftFoot)]);
}

TEST_CASE("edited crowd: headings follow the edited way where it differs, and are kept where it does not") {
    const Vec2 east{1.0, 0.0}, north{0.0, 1.0};
    CHECK(turnedHeading(north, east, east) == north);
    CHECK(distance(turnedHeading(east, east, north), north) < 1e-9);
    // Who stood and is carried away walks that way; who went sideways goes on sideways.
    CHECK(distance(turnedHeading(east, {}, north), north) < 1e-9);
    CHECK(distance(turnedHeading(north, east, north), {-1.0, 0.0}) < 1e-9);
    CHECK(turnedHeading(east, {}, {}) == east);
}

}  // namespace
