// Gaits against what has been measured of people.
#include "base/maths.h"
#include "people/generator/measure.h"

using namespace muster;
using namespace muster::test;

namespace {

/// Share of the cycle that a foot stands.
double contactShare(const Clip& clip) {
    const Contact& contact = clip.contacts.front();
    return (contact.end - contact.begin) / clip.duration();
}

Range hipsOf(const Clip& clip) {
    Range range;
    for (const BodyPose& pose : clip.poses) range.add(pose.hips.z);
    return range;
}

Range kneeOf(const Clip& clip) {
    return rangeOver(clip, [](const BodyPose& pose, const JointTransforms&, std::size_t side) {
        return bendOf(pose, JointRole::LeftLeg, side);
    });
}
Range elbowOf(const Clip& clip) {
    return rangeOver(clip, [](const BodyPose& pose, const JointTransforms&, std::size_t side) {
        return bendOf(pose, JointRole::LeftForeArm, side);
    });
}
Range thighsOf(const Clip& clip) {
    return rangeOver(clip, [](const BodyPose&, const JointTransforms& joints, std::size_t side) {
        return thighOf(joints, side);
    });
}

/// Lean of the trunk, hips to neck [deg].
double leanOf(const Clip& clip) {
    double sum = 0.0;
    for (const BodyPose& pose : clip.poses) {
        JointTransforms joints;
        jointTransforms(pose, {}, joints);
        const Vec3 way = joints[index(JointRole::Neck)].translation -
                         joints[index(JointRole::Hips)].translation;
        sum += degreesOf(arcTangent2(way.x, way.z));
    }
    return sum / static_cast<double>(clip.poses.size());
}

bool inAir(const Clip& clip, double time) {
    return !clip.touches(Limb::LeftFoot, time) && !clip.touches(Limb::RightFoot, time);
}

void checkWithin(double value, double least, double most, const std::string& what) {
    CHECK_MESSAGE(value >= least, what);
    CHECK_MESSAGE(value <= most, what << ": " << value);
}

}  // namespace

TEST_CASE("walking has the measured ranges") {
    const Clip& walk = clipNamed("walk");
    checkWithin(walk.duration(), 1.0, 1.15, "cycle");
    checkWithin(contactShare(walk), 0.55, 0.62, "contact");
    const Range thigh = thighsOf(walk), knee = kneeOf(walk), elbow = elbowOf(walk), hips = hipsOf(walk);
    checkWithin(thigh.least, -22, -12, "thigh back");
    checkWithin(thigh.most, 26, 36, "thigh forward");
    checkWithin(knee.least, 5, 14, "knee straight");
    checkWithin(knee.most, 65, 78, "knee bent");
    checkWithin(elbow.least, 10, 25, "elbow straight");
    checkWithin(elbow.most, 40, 75, "elbow bent");
    checkWithin(hips.most - hips.least, 0.02, 0.035, "bob");
    checkWithin(leanOf(walk), -2, 5, "lean");
}

TEST_CASE("jogging and running have the measured ranges") {
    for (const std::string name : {"jog", "run"}) {
        const Clip& clip = clipNamed(name);
        CAPTURE(name);
        checkWithin(clip.duration(), 0.70, 0.80, "cycle");
        checkWithin(contactShare(clip), 0.28, 0.35, "contact");
        const Range thigh = thighsOf(clip), knee = kneeOf(clip), elbow = elbowOf(clip), hips = hipsOf(clip);
        checkWithin(thigh.least, -22, -5, "thigh back");
        checkWithin(thigh.most, 33, 46, "thigh forward");
        checkWithin(knee.least, 10, 32, "knee straight");
        checkWithin(knee.most, 95, 120, "knee bent");
        checkWithin(elbow.least, 80, 95, "elbow straight");
        checkWithin(elbow.most, 100, 120, "elbow bent");
        checkWithin(hips.most - hips.least, 0.08, 0.108, "bob");
        checkWithin(leanOf(clip), 3, 12, "lean");
    }
}

TEST_CASE("the trunk leans more the faster one runs") {
    CHECK(leanOf(clipNamed("walk")) < leanOf(clipNamed("jog")));
    CHECK(leanOf(clipNamed("jog")) < leanOf(clipNamed("run")));
    CHECK(leanOf(clipNamed("run")) < leanOf(clipNamed("sprint")));
}

TEST_CASE("hips are highest over the standing foot in walking, lowest in running") {
    for (const std::string name : {"walk", "jog", "run", "sprint"}) {
        const Clip& clip = clipNamed(name);
        CAPTURE(name);
        const Contact& contact = clip.contacts.front();
        BodyPose middle;
        clip.sample(0.5 * (contact.begin + contact.end), middle);
        const Range hips = hipsOf(clip);
        const double place = (middle.hips.z - hips.least) / (hips.most - hips.least);
        // Who runs pushes off higher than he lands, so the lowest place comes a little before the middle.
        if (clip.name == "walk")
            CHECK(place > 0.95);
        else
            CHECK(place < 0.12);
    }
}

TEST_CASE("walking always stands on a foot and twice a cycle on both; running flies") {
    const Clip& walk = clipNamed("walk");
    int both = 0;
    for (int i = 0; i < 640; ++i) {
        const double time = walk.duration() * i / 640.0;
        CHECK(!inAir(walk, time));
        both += walk.touches(Limb::LeftFoot, time) && walk.touches(Limb::RightFoot, time) ? 1 : 0;
    }
    CHECK(both / 640.0 == doctest::Approx(0.2).epsilon(0.05));
    for (const std::string name : {"jog", "run", "sprint"}) {
        const Clip& clip = clipNamed(name);
        int flying = 0;
        for (int i = 0; i < 640; ++i) flying += inAir(clip, clip.duration() * i / 640.0) ? 1 : 0;
        CHECK_MESSAGE(flying / 640.0 == doctest::Approx(1.0 - 2.0 * contactShare(clip)).epsilon(0.03), name);
    }
}

TEST_CASE("in flight the hips fall freely") {
    for (const std::string name : {"jog", "run", "sprint", "jump", "jump-over"}) {
        const Clip& clip = clipNamed(name);
        const double frame = 1.0 / clip.rate;
        int checked = 0;
        for (std::size_t i = 1; i + 1 < clip.poses.size(); ++i) {
            const double time = static_cast<double>(i) * frame;
            if (!inAir(clip, time - frame) || !inAir(clip, time) || !inAir(clip, time + frame)) continue;
            const double bend = (clip.poses[i + 1].hips.z - 2.0 * clip.poses[i].hips.z +
                                 clip.poses[i - 1].hips.z) /
                                (frame * frame);
            CHECK_MESSAGE(bend == doctest::Approx(-9.81).epsilon(0.02), name << " at " << time << " s");
            ++checked;
        }
        CHECK_MESSAGE(checked >= 8, name);
    }
}

TEST_CASE("arms go against the legs, shoulders against the hips") {
    for (const std::string name : {"walk", "jog", "run", "sprint", "duck"}) {
        const Clip& clip = clipNamed(name);
        double arms = 0.0, trunk = 0.0;
        for (std::size_t i = 0; i < clip.poses.size(); ++i) {
            const JointTransforms joints = jointsAt(clip, static_cast<int>(i));
            const auto ahead = [&](JointRole left) {
                return static_cast<double>(joints[index(left)].translation.x -
                                           joints[sided(left, 1)].translation.x);
            };
            arms += ahead(JointRole::LeftForeArm) * ahead(JointRole::LeftLeg);
            trunk += ahead(JointRole::LeftArm) * ahead(JointRole::LeftUpLeg);
        }
        CHECK_MESSAGE(arms < 0.0, name);
        CHECK_MESSAGE(trunk < 0.0, name);
    }
}

TEST_CASE("half a cycle later the other side does the same") {
    for (const std::string name : {"walk", "jog", "run", "sprint", "duck", "crawl", "swim"}) {
        const Clip& clip = clipNamed(name);
        const int half = static_cast<int>(clip.poses.size()) / 2;
        if (clip.poses.size() % 2 != 0) continue;
        for (std::size_t i = 0; i < clip.poses.size(); ++i) {
            const JointTransforms now = jointsAt(clip, static_cast<int>(i)),
                                  later = jointsAt(clip, static_cast<int>(i) + half);
            for (JointRole role :
                 {JointRole::LeftHand, JointRole::LeftLeg, JointRole::LeftFoot, JointRole::LeftToeBase}) {
                Vec3 other = later[sided(role, 1)].translation;
                other.y = -other.y;
                // A swimmer breathes on one side only, and the head moves the arms a little.
                CHECK_MESSAGE(distance(now[index(role)].translation, other) < 0.002f, name << " frame " << i);
            }
        }
    }
}

TEST_CASE("left and right bends are mirror images half a cycle apart") {
    const Clip &left = clipNamed("walk-left"), &right = clipNamed("walk-right");
    for (int i = 0; i < static_cast<int>(left.poses.size()); ++i) {
        const JointTransforms a = jointsAt(left, i),
                              b = jointsAt(right, i + static_cast<int>(left.poses.size()) / 2);
        Vec3 mirrored = b[index(JointRole::RightFoot)].translation;
        mirrored.y = -mirrored.y;
        CHECK(distance(a[index(JointRole::LeftFoot)].translation, mirrored) < 0.002f);
    }
}

TEST_CASE("bends are leant into, the head less than the trunk") {
    for (const std::string name : {"walk-left", "jog-left", "run-left"}) {
        double trunk = 0.0, head = 0.0;
        const Clip& clip = clipNamed(name);
        for (std::size_t i = 0; i < clip.poses.size(); ++i) {
            const JointTransforms joints = jointsAt(clip, static_cast<int>(i));
            trunk += rotate(joints[index(JointRole::Chest)].rotation, {0.0f, 0.0f, 1.0f}).y;
            head += rotate(joints[index(JointRole::Head)].rotation, {0.0f, 0.0f, 1.0f}).y;
        }
        trunk /= static_cast<double>(clip.poses.size());
        head /= static_cast<double>(clip.poses.size());
        CHECK_MESSAGE(trunk > 0.04, name);
        CHECK_MESSAGE(head < 0.6 * trunk, name);
    }
}

TEST_CASE("loops close: across the wrap nothing moves faster than next to it") {
    for (const Clip& clip : ownClips().clips) {
        if (!clip.cyclic) continue;
        const int n = static_cast<int>(clip.poses.size());
        const auto bend = [&](int frame, std::size_t joint) {
            return static_cast<double>(length(jointsAt(clip, frame + 1)[joint].translation -
                                              2.0f * jointsAt(clip, frame)[joint].translation +
                                              jointsAt(clip, frame - 1)[joint].translation));
        };
        for (std::size_t joint = 0; joint < kJointCount; ++joint) {
            double inside = 0.0;
            for (int frame = 1; frame + 1 < n; ++frame) inside = std::max(inside, bend(frame, joint));
            // Left landings lie at the wrap, right ones in the middle of the loop: the mirrored joint sees
            // the same.
            const std::size_t other = joint < 5 ? joint
                                                : (joint < 13 ? 5 + (joint - 5 + 4) % 8
                                                              : 13 + (joint - 13 + 4) % 8);
            for (int frame = 1; frame + 1 < n; ++frame) inside = std::max(inside, bend(frame, other));
            CHECK_MESSAGE(bend(0, joint) <= 1.3 * inside + 1e-4, clip.name << ", " << skeleton()[joint].name);
            CHECK_MESSAGE(bend(n - 1, joint) <= 1.3 * inside + 1e-4,
                          clip.name << ", " << skeleton()[joint].name);
        }
    }
}

TEST_CASE("heads stay level and low where they must") {
    for (const std::string name : {"walk", "jog", "run", "sprint"}) {
        const Clip& clip = clipNamed(name);
        for (std::size_t i = 0; i < clip.poses.size(); ++i) {
            const Vec3 up = rotate(jointsAt(clip, static_cast<int>(i))[index(JointRole::Head)].rotation,
                                   {0.0f, 0.0f, 1.0f});
            CHECK_MESSAGE(up.z > 0.995f, name);
        }
    }
    const auto top = [](const std::string& name) {
        return rangeOver(clipNamed(name),
                         [](const BodyPose&, const JointTransforms& joints, std::size_t) {
                             return static_cast<double>(
                                 joints[index(JointRole::Head)].apply({0.0f, 0.0f, 0.19f}).z);
                         })
            .most;
    };
    CHECK(top("duck") < 1.27);
    CHECK(top("crawl") < 0.72);
    CHECK(top("swim") < 0.0);
}

TEST_CASE("a crawler's back stays below 0.65 m; knees and hands across land together") {
    const Clip& crawl = clipNamed("crawl");
    for (const BodyPose& pose : crawl.poses) {
        JointTransforms joints;
        jointTransforms(pose, {}, joints);
        for (JointRole role : {JointRole::Hips, JointRole::Spine, JointRole::Chest, JointRole::Neck})
            CHECK(joints[index(role)].translation.z + 0.125f < 0.66f);
    }
    const auto begin = [&](Limb limb) {
        for (const Contact& contact : crawl.contacts)
            if (contact.limb == limb) return contact.begin / crawl.duration();
        return -1.0;
    };
    CHECK(std::fabs(begin(Limb::LeftKnee) - begin(Limb::RightHand)) < 0.1);
    CHECK(std::fabs(begin(Limb::RightKnee) - begin(Limb::LeftHand)) < 0.1);
}
