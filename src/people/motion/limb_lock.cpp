#include "people/motion/limb_lock.h"

#include <algorithm>

#include "base/maths.h"

namespace muster {
namespace {

// Distance from its free target at which a locked limb is released [m].
constexpr float kReleaseDistance = 0.15f;
// Distance at which a locked foot is released while the other one steps [m].
constexpr float kReleaseStepping = 0.25f;
// Cosine of the rotation (0.6 rad) at which a standing foot is released.
constexpr double kReleaseCosine = 0.82533561;
constexpr float kReleaseTime = 0.2f;     // Fade time of the offset after a contact [s].
constexpr float kLockTime = 0.08f;       // Fade time of height and rotation at touch-down [s].
constexpr float kLeastLockTime = 0.08f;  // Remaining time below which a contact is not locked [s].
constexpr float kLockHeight = 0.05f;     // Largest height above its contact at which a limb is locked [m].
constexpr float kStepTime = 0.26f;       // Duration of a correcting step [s].
constexpr float kStepHeight = 0.05f;     // Lift of a correcting step [m].

float smooth(float t) {
    return t * t * (3.0f - 2.0f * t);
}

// The rotation on the ground from one direction to another; `otherwise` if either is too steep.
Rotation between(Vec2 from, Vec2 to, const Rotation& otherwise) {
    const double lengths = std::sqrt(lengthSquared(from) * lengthSquared(to));
    if (lengths < 0.1) return otherwise;
    return {dot(from, to) / lengths, cross(from, to) / lengths};
}

/// Target of a joint in the world.
struct JointTarget {
    Vec2 position;        ///< Position on the ground [m].
    float height = 0.0f;  ///< Height [m].
    Quat rotation;
};

/// The update of one limb in one step.
class LimbStep {
public:
    LimbStep(const ClipTable& table, const Mover& mover, const BodyFrame& axes, std::size_t number,
             PosedBody& body)
        : table_(table),
          mover_(mover),
          axes_(axes),
          number_(number),
          limb_(body.limbs[number]),
          other_(body.limbs[number ^ 1u]),
          contact_(table.contactAt(mover.clip, number, mover.time)) {
        if (contact_ != nullptr) contactFrame_ = table.contactFrameAt(mover.clip, *contact_, mover.time);
    }

    LimbTarget run(const LimbTarget& free, float dt) {
        free_ = {axes_.toGround(free.position), free.position.z * axes_.size, axes_.rotation * free.rotation};
        limb_.fade = std::max(0.0f, limb_.fade - dt / limb_.fadeTime);
        if (limb_.fade == 0.0f) limb_.stepping = false;
        if (limb_.locked && contact_ == nullptr) release(kReleaseTime, false);
        // If a switch changes the foot's pose, the foot remains locked at its position and its rotation
        // fades.
        if (limb_.locked && mover_.switched) lockAt({limb_.position, limb_.height, limb_.rotation});
        if (limb_.locked && strained()) release(kStepTime, true);
        if (!limb_.locked && contact_ != nullptr && !limb_.stepping && lasts() && low()) lock();
        const bool plain = !limb_.locked && limb_.fade == 0.0f;
        const JointTarget target = plain ? free_ : withOffset(limb_.locked ? lockedTarget() : free_);
        limb_.position = target.position;
        limb_.height = target.height;
        limb_.rotation = target.rotation;
        if (plain) return free;
        return {axes_.toBody(target.position, target.height), conjugate(axes_.rotation) * target.rotation};
    }

private:
    JointTarget lockedTarget() const {
        const double size = static_cast<double>(axes_.size);
        const Vec2 roll = limb_.axes.apply({contactFrame_.roll.x, contactFrame_.roll.y}) * size;
        return {limb_.anchor + roll, limb_.anchorHeight + contactFrame_.roll.z * axes_.size,
                yawRotation(limb_.axes) * contactFrame_.rotation};
    }

    // Adds the remaining offset.
    JointTarget withOffset(JointTarget target) const {
        if (limb_.fade == 0.0f) return target;
        const float w = smooth(limb_.fade);
        target.position += Vec2{static_cast<double>(limb_.offset.x * w),
                                static_cast<double>(limb_.offset.y * w)};
        target.height += limb_.offset.z * w;
        if (limb_.stepping) target.height += 4.0f * kStepHeight * limb_.fade * (1.0f - limb_.fade);
        target.rotation = nlerp({}, limb_.rotationOffset, w) * target.rotation;
        return target;
    }

    void fadeFrom(const JointTarget& shown, const JointTarget& target, float time) {
        const Vec2 d = shown.position - target.position;
        limb_.offset = {static_cast<float>(d.x), static_cast<float>(d.y), shown.height - target.height};
        limb_.rotationOffset = shown.rotation * conjugate(target.rotation);
        limb_.fade = 1.0f;
        limb_.fadeTime = time;
    }

    void release(float time, bool steps) {
        limb_.locked = false;
        limb_.stepping = steps;
        fadeFrom({limb_.position, limb_.height, limb_.rotation}, free_, time);
    }

    // Locks the touching point at its position and the limb in its direction.
    void lockAt(const JointTarget& now) {
        const Vec3 tip{1.0f, 0.0f, 0.0f};
        const Vec3 points = rotate(now.rotation, tip), pointed = rotate(contactFrame_.rotation, tip);
        limb_.axes = between({static_cast<double>(pointed.x), static_cast<double>(pointed.y)},
                             {static_cast<double>(points.x), static_cast<double>(points.y)}, limb_.axes);
        limb_.anchorHeight = contact_->height * (contact_->height > kFixedHeight ? 1.0f : axes_.size);
        const Vec3 point = touching(contactFrame_.rotation);
        limb_.anchor = {};
        const JointTarget there = lockedTarget();
        limb_.anchor = under(now, point) - under(there, point);
        limb_.locked = true;
        fadeFrom(now, lockedTarget(), kLockTime);
    }

    void lock() {
        const double turn = static_cast<double>(contactFrame_.turn);
        limb_.axes = axes_.facing;
        if (turn != 0.0) {
            const double c = cosine(turn), s = sine(turn);
            limb_.axes = {axes_.facing.c * c + axes_.facing.s * s, axes_.facing.s * c - axes_.facing.c * s};
        }
        lockAt(withOffset(free_));
    }

    // The touching point: the lower one of heel and ball for a foot, the wrist for a hand.
    Vec3 touching(Quat rotation) const { return number_ < 2 ? touchingPoint(rotation) : Vec3{}; }

    Vec2 under(const JointTarget& target, Vec3 point) const {
        const Vec3 p = rotate(target.rotation, point) * axes_.size;
        return target.position + Vec2{static_cast<double>(p.x), static_cast<double>(p.y)};
    }

    // True if the contact lasts long enough to lock the limb.
    bool lasts() const {
        float time = mover_.time;
        if (time < contact_->begin) time += table_[mover_.clip].duration;
        return contact_->end - time > kLeastLockTime;
    }

    // True if the limb is low enough to be locked.
    bool low() const {
        const float height = contact_->height + contactFrame_.roll.z;
        return std::fabs(withOffset(free_).height - height) < kLockHeight;
    }

    bool strained() const {
        const JointTarget target = lockedTarget();
        const auto d = static_cast<float>(distance(target.position, free_.position));
        const bool feet = number_ < 2;
        if (feet && other_.stepping && d < kReleaseStepping) return false;
        if (d > kReleaseDistance) return true;
        const double along = limb_.axes.c * axes_.facing.c + limb_.axes.s * axes_.facing.s;
        return feet && table_[mover_.clip].standing && along < kReleaseCosine;
    }

    const ClipTable& table_;
    const Mover& mover_;
    const BodyFrame& axes_;
    std::size_t number_;
    LimbLock& limb_;
    const LimbLock& other_;
    const ContactTrack* contact_;
    ContactFrame contactFrame_;
    JointTarget free_;
};

}  // namespace

Quat yawRotation(const Rotation& rotation) {
    const auto c = static_cast<float>(rotation.c), s = static_cast<float>(rotation.s);
    if (c > -0.5f) {
        const float w = std::sqrt(0.5f * (1.0f + c));
        return {0.0f, 0.0f, s / (2.0f * w), w};
    }
    const float z = std::sqrt(0.5f * (1.0f - c));
    return {0.0f, 0.0f, z, s / (2.0f * z)};
}

BodyFrame::BodyFrame(const Mover& mover)
    : position(mover.position), facing(mover.facing), rotation(yawRotation(mover.facing)), size(mover.size) {}

Vec3 BodyFrame::toBody(Vec2 point, float height) const {
    const Vec2 p = facing.applyInverse(point - position);
    const float shrink = 1.0f / size;
    return {static_cast<float>(p.x) * shrink, static_cast<float>(p.y) * shrink, height * shrink};
}

LimbTarget lockLimb(const ClipTable& table, const Mover& mover, const BodyFrame& axes, std::size_t limb,
                    const LimbTarget& free, float dt, PosedBody& body) {
    return LimbStep(table, mover, axes, limb, body).run(free, dt);
}

}  // namespace muster
