#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/maths.h"
#include "people/clips/retarget.h"

namespace muster {
namespace {

constexpr float kFootHeight = 0.05f;   // Largest height of a sole in contact [m].
constexpr float kMostFloor = 0.07f;    // Largest floor height estimated for one foot [m].
constexpr float kHandHeight = 0.09f;   // Largest height of a wrist in contact [m].
constexpr float kKneeHeight = 0.12f;   // Largest height of a knee in contact [m].
constexpr double kContactSpeed = 0.5;  // Largest speed of a limb in contact [m/s].
// Largest speed of a limb in contact in clips faster than kFastClip, in which feet roll faster [m/s].
constexpr double kFastContactSpeed = 1.0;
constexpr double kFastClip = 2.0;        // Speed above which a clip is fast [m/s].
constexpr double kLeastDuration = 0.05;  // Duration below which gaps are closed and contacts dropped [s].
constexpr float kAnkle = 0.08f, kBall = 0.03f;  // Heights of ankle and ball above a flat sole [m].

/// Speed below which a limb is in contact, in a clip of this speed [m/s]. Slow gaits swing their feet slowly
/// too.
double slowFor(double speed) {
    return speed > kFastClip ? kFastContactSpeed : std::min(kContactSpeed, 0.2 + 0.5 * speed);
}

/// State of a limb in one frame.
struct LimbAt {
    Vec3 joint;           ///< Ankle, wrist or knee in the ground frame [m].
    Vec3 tip;             ///< Ball of the foot; for other limbs the joint [m].
    float heading = 0.0;  ///< Yaw of the foot [rad].
};

class ContactFinder {
public:
    explicit ContactFinder(Clip& clip)
        : clip_(clip), frames_(clip.poses.size()), slow_(slowFor(clip.speed())) {
        for (std::size_t f = 0; f < frames_ + (clip.cyclic ? 1 : 0); ++f) {
            const Travel& at = clip.travel[f];
            jointTransforms(clip.poses[f % frames_], {yawTurn(at.yaw), {at.x, at.y, 0.0f}},
                            joints_.emplace_back());
        }
        for (const Limb foot : {Limb::LeftFoot, Limb::RightFoot})
            floor_[static_cast<std::size_t>(foot)] = floorOf(foot);
    }

    void find() {
        clip_.contacts.clear();
        for (std::size_t l = 0; l < kLimbCount; ++l) findOf(static_cast<Limb>(l));
        std::stable_sort(clip_.contacts.begin(), clip_.contacts.end(),
                         [](const Contact& a, const Contact& b) { return a.begin < b.begin; });
    }

private:
    static bool isFoot(Limb limb) { return limb == Limb::LeftFoot || limb == Limb::RightFoot; }

    LimbAt at(Limb limb, std::size_t frame) const {
        const JointRole role = limbJoint(limb);
        const Transform& joint = joints_[frame][index(role)];
        LimbAt found{joint.translation, joint.translation};
        if (!isFoot(limb)) return found;
        found.tip = joints_[frame][index(role) + 1].translation;
        const Vec3 ahead = found.tip - found.joint;
        found.heading = static_cast<float>(arcTangent2(ahead.y, ahead.x));
        return found;
    }

    /// Height of the floor under one foot [m]. It is estimated per foot, because the feet of a recording may
    /// differ.
    float floorOf(Limb foot) const {
        std::vector<float> heights;
        for (std::size_t f = 0; f < frames_; ++f) {
            const LimbAt here = at(foot, f);
            heights.push_back(std::min(here.joint.z - kAnkle, here.tip.z - kBall));
        }
        const auto low = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 10);
        std::nth_element(heights.begin(), low, heights.end());
        return std::clamp(*low, 0.0f, kMostFloor);
    }

    double speed(Limb limb, std::size_t frame, Vec3 LimbAt::*point) const {
        // A cycle continues beyond its ends with an additional travel, so differences of neighbouring frames
        // are not valid across them.
        const std::size_t last = joints_.size() - 1;
        const std::size_t a = frame > 0 ? frame - 1 : 0, b = std::min(frame + 1, last);
        return static_cast<double>(distance(at(limb, a).*point, at(limb, b).*point)) * clip_.rate /
               static_cast<double>(b - a);
    }

    bool touches(Limb limb, std::size_t frame) const {
        const LimbAt here = at(limb, frame);
        if (!isFoot(limb)) {
            const bool knee = limb == Limb::LeftKnee || limb == Limb::RightKnee;
            return here.joint.z < (knee ? kKneeHeight : kHandHeight) &&
                   speed(limb, frame, &LimbAt::joint) < slow_;
        }
        const float floor = floor_[static_cast<std::size_t>(limb)];
        const bool heel = here.joint.z - kAnkle - floor < kFootHeight &&
                          speed(limb, frame, &LimbAt::joint) < slow_;
        const bool ball = here.tip.z - kBall - floor < kFootHeight &&
                          speed(limb, frame, &LimbAt::tip) < slow_;
        return heel || ball;
    }

    /// Sets runs of frames that differ from `value` to it if they are too short.
    void fillShort(std::vector<char>& touch, char value) const {
        const auto least = static_cast<std::size_t>(kLeastDuration * clip_.rate);
        for (std::size_t begin = 0; begin < touch.size();) {
            std::size_t end = begin;
            while (end < touch.size() && touch[end] == touch[begin]) ++end;
            const bool inside = begin > 0 && end < touch.size();
            if (touch[begin] != value && end - begin <= least && inside)
                std::fill(touch.begin() + begin, touch.begin() + end, value);
            begin = end;
        }
    }

    void findOf(Limb limb) {
        std::vector<char> touch(frames_);
        for (std::size_t f = 0; f < frames_; ++f) touch[f] = touches(limb, f) ? 1 : 0;
        fillShort(touch, 1);
        fillShort(touch, 0);
        const bool all = std::find(touch.begin(), touch.end(), 0) == touch.end();
        const bool wraps = clip_.cyclic && !all && touch.front() && touch.back();
        std::size_t begin = 0;
        if (wraps) begin = static_cast<std::size_t>(std::find(touch.begin(), touch.end(), 0) - touch.begin());
        while (begin < frames_) {
            if (!touch[begin]) {
                ++begin;
                continue;
            }
            std::size_t end = begin;
            while (end < frames_ && touch[end]) ++end;
            const std::size_t more = wraps && end == frames_
                                         ? static_cast<std::size_t>(std::find(touch.begin(), touch.end(), 0) -
                                                                    touch.begin())
                                         : 0;
            add(limb, begin, end, more);
            begin = end;
        }
    }

    /// Adds a contact from frame `begin` to before frame `end`, and `more` frames into the next cycle.
    void add(Limb limb, std::size_t begin, std::size_t end, std::size_t more) {
        Contact contact;
        contact.limb = limb;
        contact.begin = static_cast<double>(begin) / clip_.rate;
        contact.end = std::min(static_cast<double>(end + more) / clip_.rate,
                               clip_.duration() * (clip_.cyclic ? 2.0 : 1.0));
        if (!(contact.end - contact.begin > kLeastDuration)) return;
        Vec3 sum;
        for (std::size_t f = begin; f < end; ++f) sum += flat(limb, f);
        contact.anchor = sum * (1.0f / static_cast<float>(end - begin));
        clip_.contacts.push_back(contact);
    }

    /// Position of the joint if the foot were flat on its ball [m].
    Vec3 flat(Limb limb, std::size_t frame) const {
        const LimbAt here = at(limb, frame);
        if (!isFoot(limb)) return here.joint;
        const float reach = skeleton()[index(JointRole::LeftToeBase)].offset.x;
        const auto c = static_cast<float>(cosine(here.heading)), s = static_cast<float>(sine(here.heading));
        return {here.tip.x - reach * c, here.tip.y - reach * s, kAnkle};
    }

    Clip& clip_;
    std::size_t frames_;
    double slow_;
    std::array<float, kLimbCount> floor_{};
    std::vector<JointTransforms> joints_;
};

}  // namespace

void findContacts(Clip& clip) {
    ContactFinder(clip).find();
}

}  // namespace muster
