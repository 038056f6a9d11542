// Our gaits beside recorded ones: curves over the cycle, from landing to landing.
#include <filesystem>

#include "muster/clip.h"
#include "people/clips/retarget.h"
#include "people/generator/measure.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::test;

namespace {

/// A recorded loop on our skeleton; none where the recordings are not at hand.
std::optional<Clip> recorded(const std::string& name) {
    const std::string path = sourceFolder() + "/../shared/mocap/" + name + ".bvh";
    if (!std::filesystem::exists(path)) {
        MESSAGE("skipped: " << name << " is not here");
        return {};
    }
    const auto motion = readBvh(path);
    REQUIRE_MESSAGE(motion.ok(), motion.status().message());
    RetargetOptions options{.name = name, .cyclic = true};
    auto clip = retarget(*motion, options);
    REQUIRE_MESSAGE(clip.ok(), clip.status().message());
    return std::move(clip).value();
}

/// When the foot lands in the cycle [s].
double landingOf(const Clip& clip, Limb limb) {
    for (const Contact& contact : clip.contacts)
        if (contact.limb == limb) return contact.begin;
    return 0.0;
}

struct Angles {
    double thigh, knee;  // [deg]
};

/// Both sides' mean, at a share of the cycle since the side's landing.
Angles anglesAt(const Clip& clip, double share) {
    Angles mean{0.0, 0.0};
    for (std::size_t side = 0; side < 2; ++side) {
        const Limb limb = side == 0 ? Limb::LeftFoot : Limb::RightFoot;
        BodyPose pose;
        clip.sample(landingOf(clip, limb) + share * clip.duration(), pose);
        JointTransforms joints;
        jointTransforms(pose, {}, joints);
        mean.thigh += 0.5 * thighOf(joints, side);
        mean.knee += 0.5 * bendOf(pose, JointRole::LeftLeg, side);
    }
    return mean;
}

/// Root of the mean square of the differences over the cycle [deg], contacts laid over each other.
Angles apart(const Clip& ours, const Clip& theirs) {
    Angles sum{0.0, 0.0};
    constexpr int kSamples = 60;
    for (int i = 0; i < kSamples; ++i) {
        const Angles a = anglesAt(ours, i / 60.0), b = anglesAt(theirs, i / 60.0);
        sum.thigh += (a.thigh - b.thigh) * (a.thigh - b.thigh) / kSamples;
        sum.knee += (a.knee - b.knee) * (a.knee - b.knee) / kSamples;
    }
    return {std::sqrt(sum.thigh), std::sqrt(sum.knee)};
}

}  // namespace

TEST_CASE("our walk follows the recorded one in hip and knee") {
    const auto theirs = recorded("walk_cmu02_01_loop");
    if (!theirs) return;
    const Angles off = apart(clipNamed("walk"), *theirs);
    MESSAGE("walk: thigh " << off.thigh << " deg, knee " << off.knee << " deg");
    CHECK(off.thigh < 6.0);
    CHECK(off.knee < 11.0);
}

TEST_CASE("our run follows the recorded jog, which is as fast") {
    const auto theirs = recorded("run_jog_cmu02_03_loop");
    if (!theirs) return;
    const Angles off = apart(clipNamed("run"), *theirs);
    MESSAGE("run: thigh " << off.thigh << " deg, knee " << off.knee << " deg");
    CHECK(off.thigh < 6.0);
    CHECK(off.knee < 9.0);
    // A walk is much farther from it: the measure tells gaits apart.
    CHECK(apart(clipNamed("walk"), *theirs).knee > 1.5 * off.knee);
}
