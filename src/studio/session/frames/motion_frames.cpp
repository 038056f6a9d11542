#include "studio/session/frames/motion_frames.h"

#include <algorithm>
#include <cmath>

#include "studio/session/inbox/protocol.h"

namespace muster {
namespace {

constexpr std::uint32_t kStepsBetweenChoices = 6;
constexpr std::size_t kMostClips = 256;  // Indices of clips are single bytes.
// Phases have 16 bits, so that one unit of the longest clip is about a millisecond [s].
constexpr double kLongestClip = 65.0;
constexpr float kCoarseClip = 5.0f;  // Phases of 8 bits suffice for clips up to this length [s].
constexpr std::size_t kLargeCrowd = 2000;
constexpr std::size_t kTrackedCrowd = 500;  // Most characters whose whole poses all go on in a replay.
// Largest number of whole poses per client in a large crowd. It keeps frames within 8 bytes per character.
constexpr std::size_t kNearOfLarge = 100;
// Largest number of poses of all clips: about 9 MB on the network, 34 MB on the graphics card.
constexpr std::size_t kMostPoses = 50'000;
constexpr float kWhole = 32767.0f;  // The integer that stands for 1 in quaternion components.

std::int16_t share(float value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0f, 1.0f) * kWhole));
}

std::int16_t millimetres(float metres) {
    return static_cast<std::int16_t>(std::lround(std::clamp(metres * 1000.0f, -32767.0f, 32767.0f)));
}

std::uint16_t turn65536(float angle) {
    const double turns = static_cast<double>(angle) / 6.283185307179586;
    return static_cast<std::uint16_t>(
        static_cast<std::uint32_t>((turns - std::floor(turns)) * 65536.0 + 0.5) & 65535u);
}

std::uint16_t phase65536(float time, float duration) {
    if (!(duration > 0.0f)) return 0;
    return static_cast<std::uint16_t>(std::clamp(time / duration * 65536.0f, 0.0f, 65535.0f));
}

void appendRotations(const BodyPose& pose, std::vector<std::int16_t>& list) {
    for (const Quat& q : pose.rotation)
        for (const float value : {q.x, q.y, q.z, q.w}) list.push_back(share(value));
}

// Encodes a unit quaternion in three 16-bit numbers (smallest three). The largest component follows from the
// others, which are at most sqrt(1/2). The lowest bits of the first two numbers are its index.
void appendSmallestThree(const Quat& q, std::vector<std::int16_t>& list) {
    constexpr float kMost = 0.70710678f, kUnits = 16383.0f;
    const float parts[4] = {q.x, q.y, q.z, q.w};
    int largest = 0;
    for (int k = 1; k < 4; ++k)
        if (std::fabs(parts[k]) > std::fabs(parts[largest])) largest = k;
    const float sign = parts[largest] < 0.0f ? -1.0f : 1.0f;
    for (int k = 0, written = 0; k < 4; ++k) {
        if (k == largest) continue;
        const long whole = std::lround(std::clamp(sign * parts[k] / kMost, -1.0f, 1.0f) * kUnits);
        const int bit = written < 2 ? (largest >> written) & 1 : 0;
        list.push_back(static_cast<std::int16_t>(2 * whole + bit));
        ++written;
    }
}

void appendPose(const BodyPose& pose, std::vector<std::int16_t>& list) {
    for (const float value : {pose.hips.x, pose.hips.y, pose.hips.z}) list.push_back(millimetres(value));
    for (const Quat& q : pose.rotation) appendSmallestThree(q, list);
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

bool MotionFrames::tracksAll(const WorldDef& def) {
    std::size_t count = 0;
    for (const GroupDef& group : def.groups) count += static_cast<std::size_t>(std::max(0, group.count));
    return count <= kTrackedCrowd;
}

void MotionFrames::goBack(const CrowdMotionState& state) {
    motion_->goBack(state);
}

void MotionFrames::restart(ClipLibrary library, bool trackAll) {
    motion_.reset();
    library_ = std::make_unique<ClipLibrary>(std::move(library));
    motion_ = std::make_unique<CrowdMotion>(*library_);
    trackAll_ = trackAll;
    untilChoice_ = 0;
    encodeMotions();
}

void MotionFrames::encodeMotions() {
    protocol::Motions message;
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const Joint& joint = skeleton()[j];
        const auto parent = joint.parent < 0 ? static_cast<std::uint32_t>(j)
                                             : static_cast<std::uint32_t>(joint.parent);
        message.joints.push_back({joint.name, parent, joint.offset.x, joint.offset.y, joint.offset.z});
    }
    durations_.clear();
    for (const Clip& clip : library_->clips) {
        message.clips.push_back(clipFrames(clip));
        durations_.push_back(static_cast<float>(clip.duration()));
    }
    longClips_ = std::any_of(durations_.begin(), durations_.end(),
                             [](float seconds) { return seconds > kCoarseClip; });
    std::vector<std::uint8_t> bytes = protocol::encode(message);
    if (bytes == motions_) return;
    motions_ = std::move(bytes);
    ++revision_;
}

// Chooses the characters nearest to each client's attention; the lower id comes first at equal distance.
void MotionFrames::chooseNear(const World& world, const std::vector<Attention>& attentions,
                              std::span<const ShownCharacter> shown) {
    const CharactersView characters = world.characters();
    near_.clear();
    for (const Attention& attention : attentions) {
        const std::size_t most = characters.size() > kLargeCrowd ? kNearOfLarge : characters.size();
        const std::size_t count = std::min(attention.count, most);
        if (count == 0) continue;
        byDistance_.clear();
        for (std::size_t i = 0; i < characters.size(); ++i)
            byDistance_.emplace_back(lengthSquared(characters.position[i] - attention.centre),
                                     characters.id[i]);
        const auto last = byDistance_.begin() + static_cast<std::ptrdiff_t>(count);
        if (last != byDistance_.end()) std::nth_element(byDistance_.begin(), last, byDistance_.end());
        for (auto at = byDistance_.begin(); at != last; ++at) near_.push_back(at->second);
    }
    if (!near_.empty())
        for (const ShownCharacter& one : shown) near_.push_back(one.id);
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    if (!trackAll_) motion_->setNear(near_);
}

void MotionFrames::observe(const World& world, const std::vector<Attention>& attentions,
                           std::span<const ShownCharacter> shown) {
    std::size_t asked = 0;
    for (const Attention& attention : attentions) asked += attention.count;
    if (untilChoice_ == 0 || asked != attended_) {
        chooseNear(world, attentions, shown);
        untilChoice_ = kStepsBetweenChoices;
        attended_ = asked;
    }
    --untilChoice_;
    motion_->update(world, shown);
}

void MotionFrames::build(CrowdPicture& picture) const {
    const auto states = motion_->states();
    picture.resize(states.size());
    picture.longClips = longClips_;
    for (std::size_t i = 0; i < states.size(); ++i) {
        const MotionState& state = states[i];
        picture.heading[i] = turn65536(state.yaw);
        picture.clip[i] = static_cast<std::uint8_t>(state.clip);
        picture.phase[i] = phase65536(state.time, durations_[state.clip]);
    }
    picture.near.clear();
    picture.nearPlaces.clear();
    picture.nearPoses.clear();
    for (std::size_t k = 0; k < motion_->near().size(); ++k) {
        if (trackAll_ && !std::binary_search(near_.begin(), near_.end(), motion_->nearId(k))) continue;
        const MotionState& state = states[motion_->near()[k]];
        picture.near.push_back(motion_->near()[k]);
        for (const double value : {state.position.x, state.position.y, static_cast<double>(state.yaw)})
            picture.nearPlaces.push_back(static_cast<float>(value));
        appendPose(motion_->pose(k), picture.nearPoses);
    }
}

}  // namespace muster
