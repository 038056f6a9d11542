// Clips between motions begin and end in the poses of their neighbours.
#include "people/generator/measure.h"

using namespace muster;
using namespace muster::test;

namespace {

struct Neighbours {
    std::string clip;
    std::string before;
    std::string after;
};

const Neighbours kNeighbours[] = {
    {"start", "idle", "jog"},       {"start-walk", "idle", "walk"}, {"stop", "jog", "idle"},
    {"stop-walk", "walk", "idle"},  {"turn-left", "idle", "idle"},  {"turn-right", "idle", "idle"},
    {"duck-enter", "jog", "duck"},  {"duck-exit", "duck", "jog"},   {"crawl-enter", "jog", "crawl"},
    {"crawl-exit", "crawl", "jog"}, {"swim-enter", "jog", "swim"},  {"swim-exit", "swim", "jog"},
    {"jump", "jog", "jog"},         {"jump-over", "jog", "jog"},    {"climb", "jog", "jog"},
};

/// The farthest joint between two poses in their own frames [m].
double apart(const BodyPose& a, const BodyPose& b) {
    JointTransforms ja, jb;
    jointTransforms(a, {}, ja);
    jointTransforms(b, {}, jb);
    double most = 0.0;
    for (std::size_t j = 0; j < kJointCount; ++j)
        most = std::max(most, static_cast<double>(distance(ja[j].translation, jb[j].translation)));
    return most;
}

BodyPose poseAt(const Clip& clip, double time) {
    BodyPose pose;
    clip.sample(time, pose);
    return pose;
}

/// The farthest difference between velocities on the ground [m/s], of joints.
double hasteApart(const Clip& a, double timeA, const Clip& b, double timeB) {
    constexpr double kStep = 1.0 / 60.0;
    double most = 0.0;
    const auto speeds = [&](const Clip& clip, double time) {
        const JointTransforms from = jointsOnGround(clip, time), to = jointsOnGround(clip, time + kStep);
        const Quat back = yawTurn(-clip.travelAt(time).yaw);
        std::array<Vec3, kJointCount> out;
        for (std::size_t j = 0; j < kJointCount; ++j)
            out[j] = rotate(back, to[j].translation - from[j].translation) * static_cast<float>(1.0 / kStep);
        return out;
    };
    const auto va = speeds(a, timeA), vb = speeds(b, timeB);
    for (std::size_t j = 0; j < kJointCount; ++j)
        most = std::max(most, static_cast<double>(distance(va[j], vb[j])));
    return most;
}

}  // namespace

TEST_CASE("every clip between motions begins where the one before is left") {
    for (const Neighbours& three : kNeighbours) {
        const Clip &clip = clipNamed(three.clip), &before = clipNamed(three.before);
        const double gap = apart(clip.poses.front(), poseAt(before, clip.exitPhase * before.duration()));
        CHECK_MESSAGE(gap < 0.005, three.clip << " after " << three.before << ": " << gap);
    }
}

TEST_CASE("every clip between motions ends where the one after is entered") {
    for (const Neighbours& three : kNeighbours) {
        const Clip &clip = clipNamed(three.clip), &after = clipNamed(three.after);
        const double gap = apart(clip.poses.back(), poseAt(after, clip.entryPhase * after.duration()));
        CHECK_MESSAGE(gap < 0.005, three.clip << " before " << three.after << ": " << gap);
    }
}

TEST_CASE("speeds of all joints carry over, but where a wall stops the body") {
    for (const Neighbours& three : kNeighbours) {
        const Clip &clip = clipNamed(three.clip), &before = clipNamed(three.before),
                   &after = clipNamed(three.after);
        if (clip.motion == "climb") continue;
        const double in = hasteApart(clip, 0.0, before, clip.exitPhase * before.duration());
        const double last = clip.duration() - 1.0 / 60.0;
        double entry = clip.entryPhase * after.duration() - 1.0 / 60.0;
        if (entry < 0.0) entry += after.duration();
        const double out = hasteApart(clip, last, after, entry);
        CHECK_MESSAGE(in < 2.0, three.clip << " begins: " << in);
        CHECK_MESSAGE(out < 2.0, three.clip << " ends: " << out);
    }
}

TEST_CASE("a foot that stands at the end of a clip stands at the same place in the next") {
    for (const Neighbours& three : kNeighbours) {
        const Clip &clip = clipNamed(three.clip), &after = clipNamed(three.after);
        for (std::size_t side = 0; side < 2; ++side) {
            const Limb limb = side == 0 ? Limb::LeftFoot : Limb::RightFoot;
            const double entry = clip.entryPhase * after.duration();
            const bool now = clip.touches(limb, clip.duration() - 1e-3),
                       next = after.touches(limb, entry + 1e-3);
            CHECK_MESSAGE(now == next, three.clip << ", " << std::string(limbName(limb)));
        }
    }
}
