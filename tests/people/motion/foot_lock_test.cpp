// Feet in the world: they stand still while they touch, whatever the body does above them.
#include <doctest.h>

#include <cmath>

#include "base/maths.h"
#include "people/motion/crowd_scene.h"
#include "people/motion/posed_body.h"
#include "people/motion/swinging_clips.h"

using namespace muster;
using namespace muster::testing;

namespace {

constexpr float kStep = 1.0f / 60.0f;

/// One body that plays a clip while it is moved as told.
struct Walker {
    ClipLibrary library = swingingClips();
    ClipTable table{library};
    Mover mover;
    PosedBody body;

    explicit Walker(const char* clip) { mover.clip = static_cast<std::uint16_t>(table.find(clip)); }

    void step(Vec2 velocity, float rate, float stride) {
        mover.position += velocity * static_cast<double>(kStep);
        mover.velocity = velocity;
        mover.rate = rate;
        mover.time = std::fmod(mover.time + rate * kStep, table[mover.clip].duration);
        mover.strideX = stride;
        const auto decay = static_cast<float>(
            exponential(static_cast<double>(-kInertialisationRate * kStep)));
        solveBody(table, mover, kStep, decay, body);
        mover.switched = false;
    }

    Vec3 ankle(std::size_t side) const {
        MotionState state{.position = mover.position, .size = mover.size};
        JointTransforms joints;
        worldJoints(state, body.pose, joints);
        return joints[index(side == 0 ? JointRole::LeftFoot : JointRole::RightFoot)].translation;
    }
};

/// The farthest that a locked ankle strays from where it was taken, and how many contacts were seen.
std::pair<double, int> stray(Walker& walker, Vec2 velocity, float rate, float stride, int steps) {
    double worst = 0.0;
    int contacts = 0;
    std::array<bool, 2> locked{};
    std::array<Vec3, 2> taken;
    for (int k = 0; k < steps; ++k) {
        walker.step(velocity, rate, stride);
        for (std::size_t side = 0; side < 2; ++side) {
            const bool now = walker.body.limbs[side].locked;
            const Vec3 at = walker.ankle(side);
            if (now && !locked[side]) {
                taken[side] = at;
                ++contacts;
            }
            const double away = std::sqrt(
                static_cast<double>((at.x - taken[side].x) * (at.x - taken[side].x) +
                                    (at.y - taken[side].y) * (at.y - taken[side].y)));
            if (now && locked[side]) worst = std::max(worst, away);
            locked[side] = now;
        }
    }
    return {worst, contacts};
}

}  // namespace

TEST_CASE("a walker at the clip's own speed treads without a slide") {
    Walker walker("walk");
    const auto [worst, contacts] = stray(walker, {1.25, 0.0}, 1.0f, 1.0f, 600);
    CHECK(worst < 1e-3);
    CHECK(contacts >= 19);
}

TEST_CASE("longer and shorter steps carry other speeds") {
    for (const float stride : {0.5f, 0.8f, 1.2f}) {
        Walker walker("walk");
        const auto [worst, contacts] = stray(walker, {1.25 * static_cast<double>(stride), 0.0}, 1.0f, stride,
                                             600);
        CHECK(worst < 3e-3);
        CHECK(contacts >= 18);
    }
}

TEST_CASE("a body that is carried off too fast lets its feet go, and they step") {
    Walker walker("idle");
    stray(walker, {0.0, 0.0}, 1.0f, 1.0f, 30);
    CHECK(walker.body.limbs[0].locked);
    CHECK(walker.body.limbs[1].locked);
    int steps = 0, both = 0;
    float highest = 0.0f;
    for (int k = 0; k < 240; ++k) {
        walker.step({0.1, 0.0}, 1.0f, 1.0f);
        const auto& limbs = walker.body.limbs;
        both += limbs[0].stepping && limbs[1].stepping;
        steps += limbs[0].stepping != limbs[1].stepping;
        for (std::size_t side = 0; side < 2; ++side) highest = std::max(highest, walker.ankle(side).z);
    }
    CHECK(steps > 20);
    CHECK(both == 0);        // One foot at a time.
    CHECK(highest > 0.11f);  // Lifted, not dragged.
    for (std::size_t side = 0; side < 2; ++side)
        CHECK(std::fabs(static_cast<double>(walker.ankle(side).x) - walker.mover.position.x) < 0.2);
}

TEST_CASE("feet of larger and smaller bodies stand on the floor") {
    for (const float size : {0.96f, 1.04f}) {
        Walker walker("walk");
        walker.mover.size = size;
        for (int k = 0; k < 120; ++k) {
            walker.step({1.25 * static_cast<double>(size), 0.0}, 1.0f, 1.0f);
            for (std::size_t side = 0; side < 2; ++side) {
                CHECK(walker.ankle(side).z > 0.08f * size - 0.004f);
                if (walker.body.limbs[side].locked && walker.body.limbs[side].fade == 0.0f)
                    CHECK(walker.ankle(side).z == doctest::Approx(0.08f * size).epsilon(0.02));
            }
        }
    }
}

TEST_CASE("a switch while a foot stands leaves it where it stands") {
    Walker walker("walk");
    stray(walker, {1.25, 0.0}, 1.0f, 1.0f, 18);  // In the midst of the left stance.
    REQUIRE(walker.body.limbs[0].locked);
    const Vec3 before = walker.ankle(0);
    walker.mover.clip = static_cast<std::uint16_t>(walker.table.find("jog"));
    walker.mover.time = 0.12f;
    walker.mover.switched = true;
    for (int k = 0; k < 8 && walker.body.limbs[0].locked; ++k) {
        walker.step({1.25, 0.0}, 0.7f, 0.9f);
        CHECK(std::fabs(walker.ankle(0).x - before.x) < 2e-3f);
    }
}

TEST_CASE("scenes: the motion of what a patch asks is played, once where it is asked once") {
    WorldDef def = field(9);
    PatchDef jump, duck;
    jump.polygon = {{4, -8}, {6.1, -8}, {6.1, 8}, {4, 8}};
    jump.motion = 5;
    duck.polygon = {{9, -8}, {12, -8}, {12, 8}, {9, 8}};
    duck.motion = 2;
    def.patches = {jump, duck};
    World world = World::create(def).value();
    const ClipLibrary clips = swingingClips();
    CrowdMotion motion(clips);
    MotionReport report;
    carry(world, {0, 0}, {18, 0});
    int ducking = 0, entering = 0, wrong = 0;
    run(world, motion, report, 25.0, [&] {
        for (std::size_t i = 0; i < motion.states().size(); ++i) {
            const Clip& clip = clips.clips[motion.states()[i].clip];
            ducking += clip.name == "duck";
            entering += clip.name == "duck-enter";
            const bool steady = world.characters().phase[i] == MotionPhase::Steady;
            const bool ducks = world.characters().motion[i] == 2;
            wrong += steady && ducks != (clip.motion == "duck") && clip.motion != "jump";
        }
    });
    const MotionFigures f = report.figures();
    CHECK(ducking > 100);
    CHECK(entering > 50);
    CHECK(wrong == 0);
    CHECK(f.singleSteps >= 9);
    CHECK(f.actions == f.singleSteps);
}

TEST_CASE("a recorded foot that slides in its contact is locked still all the same") {
    ClipLibrary library = swingingClips();
    const auto walk = static_cast<std::size_t>(library.indexOf("walk"));
    Clip& clip = library.clips[walk];
    for (Travel& travel : clip.travel) travel.x *= 1.2f;  // The body gets ahead of its steps.
    const ClipTable table(library);
    double clipSlides = 0.0, heldSlides = 0.0;
    for (const Contact& contact : clip.contacts) {
        if (contact.limb != Limb::LeftFoot && contact.limb != Limb::RightFoot) continue;
        const std::size_t foot = contact.limb == Limb::LeftFoot ? 0 : 1;
        const auto middle = static_cast<float>(0.5 *
                                               (contact.begin + std::min(contact.end, clip.duration())));
        const ContactTrack* track = table.contactAt(walk, foot, middle);
        REQUIRE(track != nullptr);
        const auto first = static_cast<float>(contact.begin), last = middle;
        const float way = (clip.travelAt(static_cast<double>(last)).x -
                           clip.travelAt(static_cast<double>(first)).x) /
                          6.0f;
        clipSlides = std::max(clipSlides, static_cast<double>(way));
        const ContactFrame a = table.contactFrameAt(walk, *track, first),
                           b = table.contactFrameAt(walk, *track, last);
        heldSlides = std::max(heldSlides, static_cast<double>(std::fabs(b.roll.x - a.roll.x)));
    }
    CHECK(clipSlides > 0.03);
    CHECK(heldSlides < 0.002);
}
