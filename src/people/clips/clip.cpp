#include "muster/clip.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"

namespace muster {
namespace {

/// The frame at a time within one play, and the fraction of the interval to the next frame.
struct FrameAt {
    std::size_t frame = 0;
    float share = 0.0f;
};

FrameAt frameAt(double time, double rate, std::size_t last) {
    const double at = std::max(0.0, time * rate);
    const auto frame = static_cast<std::size_t>(at);
    if (frame >= last) return {last, 0.0f};
    return {frame, static_cast<float>(at - static_cast<double>(frame))};
}

/// Number of whole cycles before a time.
double cyclesBefore(double time, double duration) {
    return duration > 0.0 ? std::floor(time / duration) : 0.0;
}

Travel power(const Travel& cycle, double times) {
    Travel base = cycle;
    if (times < 0.0) {
        // The inverse of the travel `base`.
        const double c = cosine(-base.yaw), s = sine(-base.yaw);
        base = {static_cast<float>(-(c * base.x - s * base.y)),
                static_cast<float>(-(s * base.x + c * base.y)), -base.yaw};
        times = -times;
    }
    if (base.yaw == 0.0f)
        return {static_cast<float>(base.x * times), static_cast<float>(base.y * times), 0.0f};
    Travel sum;
    for (auto n = static_cast<std::uint64_t>(times); n > 0; n >>= 1) {
        if (n & 1u) sum = sum * base;
        base = base * base;
    }
    return sum;
}

}  // namespace

const char* limbName(Limb limb) {
    static constexpr const char* kNames[] = {"left foot",  "right foot", "left hand",
                                             "right hand", "left knee",  "right knee"};
    return kNames[static_cast<std::size_t>(limb)];
}

JointRole limbJoint(Limb limb) {
    static constexpr JointRole kJoints[] = {JointRole::LeftFoot,  JointRole::RightFoot, JointRole::LeftHand,
                                            JointRole::RightHand, JointRole::LeftLeg,   JointRole::RightLeg};
    return kJoints[static_cast<std::size_t>(limb)];
}

Travel operator*(const Travel& first, const Travel& then) {
    if (first.yaw == 0.0f) return {first.x + then.x, first.y + then.y, then.yaw};
    const auto c = static_cast<float>(cosine(first.yaw)), s = static_cast<float>(sine(first.yaw));
    return {first.x + c * then.x - s * then.y, first.y + s * then.x + c * then.y, first.yaw + then.yaw};
}

double Clip::duration() const {
    const std::size_t intervals = cyclic ? poses.size()
                                         : poses.size() - std::min<std::size_t>(poses.size(), 1);
    return static_cast<double>(intervals) / rate;
}

double Clip::length() const {
    if (travel.empty()) return 0.0;
    const Travel &a = travel.front(), &b = travel.back();
    return std::sqrt(static_cast<double>(b.x - a.x) * (b.x - a.x) +
                     static_cast<double>(b.y - a.y) * (b.y - a.y));
}

double Clip::speed() const {
    const double seconds = duration();
    return seconds > 0.0 ? length() / seconds : 0.0;
}

void Clip::sample(double time, BodyPose& out) const {
    if (cyclic) time -= cyclesBefore(time, duration()) * duration();
    const FrameAt at = frameAt(time, rate, cyclic ? poses.size() : poses.size() - 1);
    const std::size_t frame = cyclic && at.frame == poses.size() ? 0 : at.frame;
    if (at.share == 0.0f) {
        out = poses[frame];
        return;
    }
    blend(poses[frame], poses[frame + 1 == poses.size() ? 0 : frame + 1], at.share, out);
}

Travel Clip::travelAt(double time) const {
    const double cycles = cyclic ? cyclesBefore(time, duration()) : 0.0;
    const FrameAt at = frameAt(time - cycles * duration(), rate, travel.size() - 1);
    Travel here = travel[at.frame];
    if (at.share > 0.0f) {
        const Travel& next = travel[at.frame + 1];
        here = {here.x + (next.x - here.x) * at.share, here.y + (next.y - here.y) * at.share,
                here.yaw + (next.yaw - here.yaw) * at.share};
    }
    return cycles == 0.0 ? here : power(travel.back(), cycles) * here;
}

const Contact* Clip::contactAt(Limb limb, double time) const {
    const double seconds = duration();
    if (cyclic) time -= cyclesBefore(time, seconds) * seconds;
    for (const Contact& contact : contacts) {
        if (contact.limb != limb) continue;
        if (time >= contact.begin && time < contact.end) return &contact;
        if (cyclic && time + seconds < contact.end) return &contact;
    }
    return nullptr;
}

bool Clip::touches(Limb limb, double time) const {
    return contactAt(limb, time) != nullptr;
}

const Clip* ClipLibrary::find(std::string_view name) const {
    const std::int32_t at = indexOf(name);
    return at < 0 ? nullptr : &clips[at];
}

std::int32_t ClipLibrary::indexOf(std::string_view name) const {
    const auto at = std::find_if(clips.begin(), clips.end(),
                                 [&](const Clip& clip) { return clip.name == name; });
    return at == clips.end() ? -1 : static_cast<std::int32_t>(at - clips.begin());
}

Status validate(const Clip& clip) {
    const auto bad = [&](const std::string& what) {
        return Status(StatusCode::InvalidArgument, "clip \"" + clip.name + "\": " + what);
    };
    if (!(clip.rate > 0.0) || !std::isfinite(clip.rate)) return bad("its rate is not a positive number");
    if (clip.poses.size() < 2) return bad("it has fewer than two poses");
    if (clip.travel.size() != clip.poses.size() + (clip.cyclic ? 1 : 0))
        return bad("its travel does not fit its poses");
    for (const BodyPose& pose : clip.poses) {
        bool finite = isFinite(pose.hips);
        for (const Quat& q : pose.rotation) finite = finite && std::fabs(dot(q, q) - 1.0f) < 1e-3f;
        if (!finite) return bad("a pose holds numbers that are no rotation or no place");
    }
    for (const Travel& at : clip.travel)
        if (!std::isfinite(at.x) || !std::isfinite(at.y) || !std::isfinite(at.yaw))
            return bad("its travel is not finite");
    for (const Contact& contact : clip.contacts) {
        const bool inside = contact.begin >= 0.0 && contact.begin < clip.duration() &&
                            contact.end > contact.begin &&
                            contact.end <= clip.duration() * (clip.cyclic ? 2.0 : 1.0) + 1e-9;
        if (!inside || !isFinite(contact.anchor))
            return bad(std::string("a contact of the ") + limbName(contact.limb) + " lies outside it");
    }
    return {};
}

}  // namespace muster
