#include "studio/session/frames/crowd_encoder.h"

namespace muster {
namespace {

constexpr int kLongestStep = 127;  // The largest change of a position within one frame [quanta].
// Whole positions are shorter where at least one in so many characters moves farther.
constexpr std::size_t kFarShare = 4;

void clearLists(protocol::CrowdFrame& frame) {
    for (auto* list : {&frame.x, &frame.y, &frame.jumpedX, &frame.jumpedY}) list->clear();
    for (auto* list : {&frame.stepX, &frame.stepY}) list->clear();
    for (auto* list : {&frame.jumped, &frame.changed}) list->clear();
    frame.clip.clear();
}

// Splits numbers into their upper bytes and, where `fine`, their lower bytes.
void split(const std::vector<std::uint16_t>& numbers, bool fine, std::vector<std::uint8_t>& high,
           std::vector<std::uint8_t>& low) {
    high.resize(numbers.size());
    low.resize(fine ? numbers.size() : 0);
    for (std::size_t i = 0; i < numbers.size(); ++i) high[i] = static_cast<std::uint8_t>(numbers[i] >> 8);
    for (std::size_t i = 0; i < low.size(); ++i) low[i] = static_cast<std::uint8_t>(numbers[i] & 255);
}

}  // namespace

// Returns false where whole positions are shorter than steps.
bool CrowdEncoder::encodeSteps(const CrowdPicture& picture, protocol::CrowdFrame& frame) const {
    const std::size_t count = picture.size();
    frame.stepX.resize(count);
    frame.stepY.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const int dx = static_cast<int>(picture.x[i]) - static_cast<int>(x_[i]);
        const int dy = static_cast<int>(picture.y[i]) - static_cast<int>(y_[i]);
        const bool far = dx > kLongestStep || dx < -kLongestStep || dy > kLongestStep || dy < -kLongestStep;
        frame.stepX[i] = static_cast<std::int8_t>(far ? 0 : dx);
        frame.stepY[i] = static_cast<std::int8_t>(far ? 0 : dy);
        if (!far) continue;
        if (frame.jumped.size() * kFarShare >= count) return false;
        frame.jumped.push_back(static_cast<std::uint32_t>(i));
        frame.jumpedX.push_back(picture.x[i]);
        frame.jumpedY.push_back(picture.y[i]);
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (picture.clip[i] == clip_[i]) continue;
        frame.changed.push_back(static_cast<std::uint32_t>(i));
        frame.clip.push_back(picture.clip[i]);
    }
    return true;
}

void CrowdEncoder::encode(const CrowdPicture& picture, bool restart, protocol::CrowdFrame& frame) {
    clearLists(frame);
    const bool known = !restart && x_.size() == picture.size() && corner_ == picture.lattice.corner() &&
                       quantum_ == picture.lattice.quantum();
    if (!known || !encodeSteps(picture, frame)) {
        clearLists(frame);
        frame.x = picture.x;
        frame.y = picture.y;
        frame.clip = picture.clip;
    }
    corner_ = picture.lattice.corner();
    quantum_ = picture.lattice.quantum();
    x_ = picture.x;
    y_ = picture.y;
    clip_ = picture.clip;
    const bool fine = picture.size() <= kFineCrowd;
    frame.count = static_cast<std::uint32_t>(picture.size());
    frame.x0 = corner_.x;
    frame.y0 = corner_.y;
    frame.quantum = static_cast<float>(quantum_);
    split(picture.heading, fine, frame.heading, frame.headingFine);
    split(picture.phase, fine || picture.longClips, frame.phase, frame.phaseFine);
    frame.near = picture.near;
    frame.nearPlaces = picture.nearPlaces;
    frame.nearPoses = picture.nearPoses;
}

}  // namespace muster
