#include "engine/orders/stream_piece.h"

#include <algorithm>
#include <cmath>

#include "engine/orders/turning.h"

namespace muster {
namespace {

constexpr double kPoseInterval = 0.5;  // Distance between poses of a formation that turns, in its reaches.

/// The point of a route at a distance from its begin [m].
Vec2 pointAt(std::span<const Vec2> way, double far) {
    for (std::size_t k = 1; k < way.size(); ++k) {
        const double part = distance(way[k - 1], way[k]);
        if (part > 0.0 && far <= part) return lerp(way[k - 1], way[k], std::max(0.0, far / part));
        far -= part;
    }
    return way.back();
}

/// Makes the poses one after the other.
class PoseList {
public:
    PoseList(const Pose& from, Turn turn, bool& reversed, std::vector<Pose>& poses)
        : at_(from), turn_(turn), reversed_(reversed), poses_(poses) {
        poses_.assign(1, from);
    }
    /// Moves the formation to a point without turning it.
    void go(Vec2 to) {
        at_.position = to;
        poses_.push_back(at_);
    }
    /// Turns its front to a direction, or its rear where that is nearer and may become its front.
    void face(Vec2 front) {
        const Rotation ahead{front.x, front.y}, back{-front.x, -front.y};
        const Rotation& now = reversed_ ? back : ahead;
        if (turn_ == Turn::Reverse && now.c * at_.rotation.c + now.s * at_.rotation.s < 0.0)
            reversed_ = !reversed_;
        at_.rotation = reversed_ ? back : ahead;
    }
    const Pose& at() const { return at_; }

private:
    Pose at_;
    Turn turn_;
    bool& reversed_;
    std::vector<Pose>& poses_;
};

}  // namespace

Rotation turned(Rotation r, double angle) {
    const double c = cosine(angle), s = sine(angle);
    Rotation out{r.c * c - r.s * s, r.s * c + r.c * s};
    const double size = std::sqrt(out.c * out.c + out.s * out.s);
    return {out.c / size, out.s / size};
}

Pose between(const Pose& from, const Pose& to, double share) {
    return {lerp(from.position, to.position, share),
            turned(from.rotation, share * angleBetween(from.rotation, to.rotation))};
}

void StreamPiece::start(std::span<const Pose> poses, double reach) {
    poses_.assign(poses.begin(), poses.end());
    done_.clear();
    for (std::size_t k = 0; k < poses.size(); ++k) {
        double part = 0.0;
        if (k > 0)
            part = distance(poses[k - 1].position, poses[k].position) +
                   reach * std::fabs(angleBetween(poses[k - 1].rotation, poses[k].rotation));
        done_.push_back(length() + part);
    }
}

Pose StreamPiece::at(double q) const {
    const double far = q * length();
    const auto next = std::upper_bound(done_.begin() + 1, done_.end(), far);
    if (next == done_.end()) return poses_.back();
    const auto k = static_cast<std::size_t>(next - done_.begin());
    return between(poses_[k - 1], poses_[k], (far - done_[k - 1]) / (done_[k] - done_[k - 1]));
}

void listPoses(const PieceDef& def, bool& reversed, std::vector<Pose>& poses) {
    PoseList list(def.from, def.turn, reversed, poses);
    if (def.turn == Turn::Keep) {
        for (const Vec2 corner : def.way) list.go(corner);
    } else {
        double whole = 0.0;
        for (std::size_t k = 1; k < def.way.size(); ++k) whole += distance(def.way[k - 1], def.way[k]);
        // The formation faces along the chord of the part of the route within its reach.
        const double reach = std::max(def.reach, kPoseInterval);
        const auto parts = static_cast<std::int32_t>(std::ceil(whole / (kPoseInterval * reach)));
        for (std::int32_t k = 0; parts > 0 && k <= parts; ++k) {
            const double far = whole * k / parts;
            const Vec2 chord = pointAt(def.way, far + reach) - pointAt(def.way, std::max(0.0, far - reach));
            const Vec2 front = list.at().rotation.apply({reversed ? -1.0 : 1.0, 0.0});
            list.face(normalized(chord, front));
            list.go(pointAt(def.way, far));
        }
    }
    if (def.facing) {
        list.face({cosine(*def.facing), sine(*def.facing)});
        list.go(list.at().position);
    }
}

}  // namespace muster
