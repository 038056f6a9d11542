#include "session/motion_frames.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr std::uint32_t kStepsBetweenChoices = 6;
constexpr std::size_t kMostClips = 256;  // Their indices are single bytes.
constexpr double kLongestClip = 65.0;    // Times in them are 16 bits of milliseconds [s].
constexpr std::size_t kMostPoses =
    50'000;                         // Of all clips: some 9 MB on the wire, 34 MB on the graphics card.
constexpr float kWhole = 32767.0f;  // What 1 is in the numbers of a rotation.

std::int16_t share(float value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * kWhole));
}

std::int16_t millimetres(float metres) {
    return static_cast<std::int16_t>(std::lround(std::clamp(metres * 1000.0f, -32767.0f, 32767.0f)));
}

std::uint16_t milliseconds(float seconds) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(seconds * 1000.0f, 0.0f, 65535.0f)));
}

void appendRotations(const BodyPose& pose, std::vector<std::int16_t>& list) {
    for (const Quat& q : pose.rotation)
        for (const float value : {q.x, q.y, q.z, q.w}) list.push_back(share(value));
}

Status tooMany(const std::string& what, std::size_t found, std::size_t most) {
    return {StatusCode::LimitExceeded,
            what + ": found " + std::to_string(found) + ", expected at most " + std::to_string(most)};
}

protocol::ClipFrames clipFrames(const Clip& clip) {
    protocol::ClipFrames frames;
    frames.name = clip.name;
    frames.motion = clip.motion;
    frames.rate = static_cast<float>(clip.rate);
    frames.cyclic = clip.cyclic;
    frames.poses = static_cast<std::uint32_t>(clip.poses.size());
    for (const BodyPose& pose : clip.poses) {
        for (const float value : {pose.hips.x, pose.hips.y, pose.hips.z}) frames.hips.push_back(value);
        appendRotations(pose, frames.rotations);
    }
    return frames;
}

}  // namespace

Status MotionFrames::fits(const ClipLibrary& library) {
    if (library.clips.size() > kMostClips) return tooMany("motions", library.clips.size(), kMostClips);
    std::size_t poses = 0;
    for (const Clip& clip : library.clips) {
        const double seconds = std::ceil(clip.duration());
        if (seconds > kLongestClip) {
            return tooMany("motion \"" + clip.name + "\" in seconds", static_cast<std::size_t>(seconds),
                           static_cast<std::size_t>(kLongestClip));
        }
        poses += clip.poses.size();
    }
    return poses <= kMostPoses ? Status() : tooMany("frames of all motions", poses, kMostPoses);
}

void MotionFrames::restart(ClipLibrary library) {
    motion_.reset();
    library_ = std::make_unique<ClipLibrary>(std::move(library));
    motion_ = std::make_unique<CrowdMotion>(*library_);
    untilChoice_ = 0;
    encodeMotions();
}

void MotionFrames::encodeMotions() {
    protocol::Motions message;
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const Joint& joint = skeleton()[j];
        const auto parent = joint.parent < 0 ? static_cast<std::uint32_t>(j) : static_cast<std::uint32_t>(joint.parent);
        message.joints.push_back({joint.name, parent, joint.offset.x, joint.offset.y, joint.offset.z});
    }
    for (const Clip& clip : library_->clips) message.clips.push_back(clipFrames(clip));
    std::vector<std::uint8_t> bytes = protocol::encode(message);
    if (bytes == motions_) return;
    motions_ = std::move(bytes);
    ++revision_;
}

// Everyone whom some client looks at; those nearest to where it looks, the lower id first where equally near.
void MotionFrames::chooseNear(const World& world, const std::vector<Attention>& attentions) {
    const Characters& characters = world.characters();
    near_.clear();
    for (const Attention& attention : attentions) {
        const std::size_t count = std::min(attention.count, characters.size());
        if (count == 0) continue;
        byDistance_.clear();
        for (std::size_t i = 0; i < characters.size(); ++i)
            byDistance_.emplace_back(lengthSquared(characters.position[i] - attention.centre), characters.id[i]);
        const auto last = byDistance_.begin() + static_cast<std::ptrdiff_t>(count);
        if (last != byDistance_.end()) std::nth_element(byDistance_.begin(), last, byDistance_.end());
        for (auto at = byDistance_.begin(); at != last; ++at) near_.push_back(at->second);
    }
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    motion_->setNear(near_);
}

void MotionFrames::observe(const World& world, const std::vector<Attention>& attentions) {
    std::size_t asked = 0;
    for (const Attention& attention : attentions) asked += attention.count;
    if (untilChoice_ == 0 || asked != attended_) {
        chooseNear(world, attentions);
        untilChoice_ = kStepsBetweenChoices;
        attended_ = asked;
    }
    --untilChoice_;
    motion_->update(world);
}

void MotionFrames::build(protocol::Frame& frame) const {
    const auto playbacks = motion_->playbacks();
    const std::size_t count = playbacks.size();
    for (auto* list : {&frame.clip, &frame.fromClip, &frame.fade}) list->resize(count);
    for (auto* list : {&frame.clipTime, &frame.fromTime}) list->resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Playback& playback = playbacks[i];
        frame.clip[i] = static_cast<std::uint8_t>(playback.clip);
        frame.fromClip[i] = static_cast<std::uint8_t>(playback.fromClip);
        frame.clipTime[i] = milliseconds(playback.time);
        frame.fromTime[i] = milliseconds(playback.fromTime);
        frame.fade[i] = static_cast<std::uint8_t>(std::lround(std::clamp(playback.fade, 0.0f, 1.0f) * 255.0f));
        if (i < frame.heading.size()) frame.heading[i] = playback.yaw;
    }
    frame.near.assign(motion_->near().begin(), motion_->near().end());
    frame.nearPoses.clear();
    for (std::size_t k = 0; k < frame.near.size(); ++k) {
        const BodyPose& pose = motion_->pose(k);
        for (const float value : {pose.hips.x, pose.hips.y, pose.hips.z}) frame.nearPoses.push_back(millimetres(value));
        appendRotations(pose, frame.nearPoses);
    }
}

}  // namespace muster
