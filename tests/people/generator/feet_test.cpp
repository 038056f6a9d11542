// What touches stays where it is, and nothing goes through the floor.
#include "people/generator/measure.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("soles in contact slide by a centimetre at most") {
    double worst = 0.0;
    std::size_t contacts = 0;
    for (const Clip& clip : ownClips().clips) {
        for (const Contact& contact : clip.contacts) {
            if (!isFoot(contact.limb) || onTheWall(clip, contact)) continue;
            const double slide = slideOf(clip, contact);
            CHECK_MESSAGE(slide <= 0.01, clip.name << ", " << std::string(limbName(contact.limb)) << " from "
                                                   << contact.begin << " s: " << slide);
            worst = std::max(worst, slide);
            ++contacts;
        }
    }
    CHECK(contacts > 50);
    MESSAGE("worst slide of " << contacts << " contacts: " << worst * 1000.0 << " mm");
}

TEST_CASE("a slide would be seen: the same clip on another ground") {
    Clip clip = clipNamed("run");
    for (Travel& at : clip.travel) at.x *= 1.1f;
    CHECK(slideOf(clip, clip.contacts.front()) > 0.03);
}

TEST_CASE("hands, knees and feet on the wall stay at their anchors") {
    for (const Clip& clip : ownClips().clips) {
        for (const Contact& contact : clip.contacts) {
            if (isFoot(contact.limb) && !onTheWall(clip, contact)) continue;
            double far = 0.0;
            for (double time = contact.begin; time < contact.end; time += 1.0 / 120.0) {
                const Vec3 joint = jointsOnGround(clip, time)[index(limbJoint(contact.limb))].translation;
                far = std::max(far, static_cast<double>(distance(joint, contact.anchor)));
            }
            CHECK_MESSAGE(far <= 0.01, clip.name << ", " << std::string(limbName(contact.limb)) << " from "
                                                 << contact.begin << " s: " << far);
        }
    }
}

TEST_CASE("a foot in contact has its sole on the ground, its ankle at the anchor while it is flat") {
    for (const Clip& clip : ownClips().clips) {
        for (const Contact& contact : clip.contacts) {
            if (!isFoot(contact.limb) || onTheWall(clip, contact)) continue;
            const std::size_t side = contact.limb == Limb::LeftFoot ? 0 : 1;
            bool flat = false;
            for (double time = contact.begin; time < contact.end; time += 1.0 / 60.0) {
                const JointTransforms joints = jointsOnGround(clip, time);
                const auto sole = soleOf(joints, side);
                const double low = std::min({sole[0].z, sole[1].z, sole[2].z});
                CHECK_MESSAGE(std::fabs(low) <= 0.01, clip.name << " at " << time << " s: " << low);
                const Vec3 ankle = joints[index(limbJoint(contact.limb))].translation;
                flat = flat || distance(ankle, contact.anchor) < 0.005f;
            }
            const bool whole = contact.begin > 0.02 && (clip.cyclic || contact.end < clip.duration() - 0.02);
            if (whole)
                CHECK_MESSAGE(flat, clip.name << ", " << std::string(limbName(contact.limb)) << " from "
                                              << contact.begin << " s is never flat");
        }
    }
}

TEST_CASE("no part of a foot, hand or knee goes deeper than a centimetre into the floor") {
    for (const Clip& clip : ownClips().clips) {
        if (clip.motion == "swim") continue;
        for (std::size_t frame = 0; frame < clip.poses.size(); ++frame) {
            const JointTransforms joints = jointsAt(clip, static_cast<int>(frame));
            double low = 1.0;
            for (std::size_t side = 0; side < 2; ++side) {
                for (Vec3 p : soleOf(joints, side)) low = std::min(low, static_cast<double>(p.z));
                low = std::min(low, joints[sided(JointRole::LeftLeg, side)].translation.z - 0.05);
                low = std::min(low, joints[sided(JointRole::LeftHand, side)].translation.z - 0.035);
                const float out = side == 0 ? 1.0f : -1.0f;
                low = std::min(
                    low, joints[sided(JointRole::LeftHand, side)].apply({0.0f, 0.15f * out, 0.0f}).z - 0.01);
            }
            CHECK_MESSAGE(low >= -0.01, clip.name << " at frame " << frame << ": " << low);
        }
    }
}

TEST_CASE("knees bend one way, never quite straight in gaits, and turn at less than 20 rad/s") {
    for (const Clip& clip : ownClips().clips) {
        Range speed;
        for (std::size_t i = 1; i < clip.poses.size(); ++i) {
            for (std::size_t side = 0; side < 2; ++side) {
                const Quat a = clip.poses[i - 1].rotation[sided(JointRole::LeftLeg, side)];
                const Quat b = clip.poses[i].rotation[sided(JointRole::LeftLeg, side)];
                speed.add(angleBetween(a, b) * clip.rate);
                // A hinge about the leg's own y axis, bent backwards.
                CHECK_MESSAGE(std::fabs(b.x) + std::fabs(b.z) < 1e-3f, clip.name);
                CHECK_MESSAGE(b.y * b.w >= 0.0f, clip.name);
            }
        }
        CHECK_MESSAGE(speed.most < 20.0, clip.name << ": " << speed.most);
        if (clip.cyclic && clip.motion != "swim")
            CHECK_MESSAGE(rangeOver(
                              clip,
                              [](const BodyPose& pose, const JointTransforms&, std::size_t side) {
                                  return bendOf(pose, JointRole::LeftLeg, side);
                              }).least > 5.0,
                          clip.name);
    }
}
