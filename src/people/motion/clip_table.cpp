#include "people/motion/clip_table.h"

#include <algorithm>
#include <span>

#include "people/motion/limb_lock.h"

namespace muster {
namespace {

constexpr float kStandingClip = 0.05f;  // Mean speed below which a clip counts as standing [m/s].

bool endsWith(std::string_view name, std::string_view end) {
    return name.size() > end.size() && name.substr(name.size() - end.size()) == end;
}

ClipUse useOf(const Clip& clip) {
    if (clip.motion == "run" || clip.motion == "walk" || clip.motion == "idle") return ClipUse::Locomotion;
    if (endsWith(clip.name, "-enter") || endsWith(clip.name, "-exit")) return ClipUse::Transition;
    return clip.cyclic ? ClipUse::Cycle : ClipUse::Action;
}

std::size_t wrapped(const Clip& clip, std::int64_t frame) {
    const auto count = static_cast<std::int64_t>(clip.poses.size());
    if (!clip.cyclic) return static_cast<std::size_t>(std::clamp<std::int64_t>(frame, 0, count - 1));
    return static_cast<std::size_t>(((frame % count) + count) % count);
}

Quat turnQuat(float yaw) {
    return yawTurn(yaw);
}

// Travel speed between frames, smoothed over 0.1 s so that play rates do not jitter.
std::vector<float> localSpeeds(const Clip& clip) {
    const auto reach = static_cast<std::int64_t>(std::max(1.0, 0.05 * clip.rate));
    std::vector<float> speeds(clip.poses.size());
    for (std::size_t f = 0; f < speeds.size(); ++f) {
        double from = static_cast<double>(static_cast<std::int64_t>(f) - reach) / clip.rate;
        double to = static_cast<double>(static_cast<std::int64_t>(f) + reach) / clip.rate;
        if (!clip.cyclic) {
            from = std::max(0.0, from);
            to = std::min(clip.duration(), to);
        }
        const Travel a = clip.travelAt(from), b = clip.travelAt(to);
        const float dx = b.x - a.x, dy = b.y - a.y;
        speeds[f] = std::sqrt(dx * dx + dy * dy) / static_cast<float>(to - from);
    }
    return speeds;
}

// Mean position of each ankle during its contacts [m].
std::array<Vec3, 2> stanceMiddles(const Clip& clip) {
    std::array<Vec3, 2> sum{}, all{};
    std::array<int, 2> count{};
    JointTransforms joints;
    for (std::size_t f = 0; f < clip.poses.size(); ++f) {
        jointTransforms(clip.poses[f], {}, joints);
        for (std::size_t side = 0; side < 2; ++side) {
            const Vec3 ankle = joints[index(limbJoint(kLockableLimbs[side]))].translation;
            all[side] += ankle * (1.0f / static_cast<float>(clip.poses.size()));
            if (!clip.touches(kLockableLimbs[side], static_cast<double>(f) / clip.rate)) continue;
            sum[side] += ankle;
            ++count[side];
        }
    }
    for (std::size_t side = 0; side < 2; ++side)
        sum[side] = count[side] > 0 ? sum[side] * (1.0f / static_cast<float>(count[side])) : all[side];
    return sum;
}

}  // namespace

ClipTable::ClipTable(const ClipLibrary& library) : library_(&library) {
    for (const Clip& clip : library.clips) {
        ClipEntry entry;
        entry.clip = &clip;
        entry.use = useOf(clip);
        entry.cyclic = clip.cyclic;
        entry.duration = static_cast<float>(clip.duration());
        entry.speed = static_cast<float>(clip.speed());
        entry.length = static_cast<float>(clip.length());
        entry.standing = entry.speed < kStandingClip;
        entry.enter = library.indexOf(clip.name + "-enter");
        entry.exit = library.indexOf(clip.name + "-exit");
        entry.localSpeed = localSpeeds(clip);
        entry.stance = stanceMiddles(clip);
        addContacts(entry);
        entry.feetTouch = !entry.contacts[0].empty() || !entry.contacts[1].empty();
        entry.handsTouch = !entry.contacts[2].empty() || !entry.contacts[3].empty();
        const bool onFeet = clip.motion != "crawl" && clip.motion != "swim" && clip.motion != "climb";
        entry.onFloor = clip.motion != "swim";
        entry.strides = onFeet && entry.feetTouch && !entry.handsTouch && !entry.standing;
        const bool goes = entry.use == ClipUse::Locomotion && entry.cyclic && !entry.standing && !clip.set;
        if (goes && (slowest_ == 0.0f || entry.speed < slowest_)) slowest_ = entry.speed;
        entries_.push_back(std::move(entry));
    }
    idle_ = library.indexOf("idle");
    for (std::size_t c = 0; idle_ < 0 && c < entries_.size(); ++c)
        if (entries_[c].use == ClipUse::Locomotion && entries_[c].standing)
            idle_ = static_cast<std::int32_t>(c);
}

namespace {

// Removes foot sliding of recorded clips: fixes the touching point during a contact.
void plant(std::span<ContactFrame> frames) {
    for (std::size_t k = 1; k < frames.size(); ++k) {
        const ContactFrame& before = frames[k - 1];
        // While the heel is raised, the foot rolls about the joint of the toes, which remain flat.
        Vec3 point = touchingPoint(before.rotation);
        if (point.x > 0.0f) point = skeleton()[index(JointRole::LeftToeBase)].offset;
        const Vec3 spot = before.roll + rotate(before.rotation, point) - rotate(frames[k].rotation, point);
        frames[k].roll.x = spot.x;
        frames[k].roll.y = spot.y;
    }
}

}  // namespace

void ClipTable::addContacts(ClipEntry& entry) const {
    const Clip& clip = *entry.clip;
    JointTransforms joints;
    for (const Contact& contact : clip.contacts) {
        const auto limb = std::find(kLockableLimbs.begin(), kLockableLimbs.end(), contact.limb);
        if (limb == kLockableLimbs.end()) continue;
        ContactTrack track{
            static_cast<float>(contact.begin), static_cast<float>(contact.end), contact.anchor.z, 0, 0, 0};
        track.firstFrame = static_cast<std::int32_t>(contact.begin * clip.rate);
        track.frames = static_cast<std::uint32_t>(entry.frames.size());
        track.count = static_cast<std::uint32_t>(static_cast<std::int32_t>(contact.end * clip.rate) + 2 -
                                                 track.firstFrame);
        const Travel start = clip.travelAt(contact.begin);
        for (std::uint32_t k = 0; k < track.count; ++k) {
            const std::int64_t frame = track.firstFrame + static_cast<std::int64_t>(k);
            const double time = static_cast<double>(frame) / clip.rate;
            const Travel travel = clip.travelAt(clip.cyclic ? time : std::min(time, clip.duration()));
            jointTransforms(clip.poses[wrapped(clip, frame)],
                            {turnQuat(travel.yaw), {travel.x, travel.y, 0.0f}}, joints);
            const Transform& joint = joints[index(limbJoint(contact.limb))];
            const Quat back = turnQuat(-start.yaw);
            entry.frames.push_back({rotate(back, joint.translation - contact.anchor), back * joint.rotation,
                                    travel.yaw - start.yaw});
        }
        if (contact.limb == Limb::LeftFoot || contact.limb == Limb::RightFoot)
            plant(std::span(entry.frames).subspan(track.frames, track.count));
        entry.contacts[limb - kLockableLimbs.begin()].push_back(track);
    }
}

float ClipTable::speedAt(std::size_t clip, float time) const {
    const ClipEntry& entry = entries_[clip];
    const auto frame = static_cast<std::size_t>(
        std::max(0.0f, time * static_cast<float>(entry.clip->rate) + 0.5f));
    return entry.localSpeed[std::min(frame, entry.localSpeed.size() - 1)];
}

const ContactTrack* ClipTable::contactAt(std::size_t clip, std::size_t limb, float time) const {
    const ClipEntry& entry = entries_[clip];
    for (const ContactTrack& contact : entry.contacts[limb]) {
        if (time >= contact.begin && time < contact.end) return &contact;
        if (entry.cyclic && time + entry.duration < contact.end) return &contact;
    }
    return nullptr;
}

ContactFrame ClipTable::contactFrameAt(std::size_t clip, const ContactTrack& contact, float time) const {
    const ClipEntry& entry = entries_[clip];
    if (time < contact.begin && entry.cyclic) time += entry.duration;
    const float at = std::max(
        0.0f, time * static_cast<float>(entry.clip->rate) - static_cast<float>(contact.firstFrame));
    const auto frame = std::min(static_cast<std::uint32_t>(at), contact.count - 2);
    const float share = std::clamp(at - static_cast<float>(frame), 0.0f, 1.0f);
    const ContactFrame& a = entry.frames[contact.frames + frame];
    const ContactFrame& b = entry.frames[contact.frames + frame + 1];
    return {lerp(a.roll, b.roll, share), nlerp(a.rotation, b.rotation, share),
            a.turn + (b.turn - a.turn) * share};
}

}  // namespace muster
