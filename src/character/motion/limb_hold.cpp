#include "character/motion/limb_hold.h"

#include <algorithm>

#include "character/motion/sole.h"

namespace muster {
namespace {

constexpr float kLetGo = 0.15f;          // A held limb this far from where it belongs is let go [m].
constexpr float kLetGoBoth = 0.25f;      // ... even while the other foot steps [m].
constexpr double kTwisted = 0.82533561;  // A standing foot turned away by more is let go (cosine of 0.6 rad).
constexpr float kReleaseTime = 0.2f;     // Difference fades after a contact [s].
constexpr float kTakeTime = 0.08f;       // Height and turn of a foot that touches down fade in [s].
constexpr float kShortest = 0.08f;       // Rest of a contact for which nothing is taken any more [s].
constexpr float kTouchHeight = 0.05f;    // A limb is taken no higher above its contact [m].
constexpr float kStepTime = 0.26f;       // Of a step aside [s].
constexpr float kStepHeight = 0.05f;     // Lift of a step aside [m].

float smooth(float t) {
    return t * t * (3.0f - 2.0f * t);
}

// The turn from one direction to another; `otherwise` where either is too steep to point anywhere.
Rotation between(Vec2 from, Vec2 to, const Rotation& otherwise) {
    const double lengths = std::sqrt(lengthSquared(from) * lengthSquared(to));
    if (lengths < 0.1) return otherwise;
    return {dot(from, to) / lengths, cross(from, to) / lengths};
}

/// A place in the world.
struct Spot {
    Vec2 place;
    float height = 0.0f;
    Quat rotation;
};

/// One limb in one step.
class LimbStep {
public:
    LimbStep(const ClipTable& table, const Mover& mover, const BodyFrame& frame, std::size_t number,
             Body& body)
        : table_(table),
          mover_(mover),
          frame_(frame),
          number_(number),
          limb_(body.limbs[number]),
          other_(body.limbs[number ^ 1u]),
          contact_(table.contactAt(mover.clip, number, mover.time)) {
        if (contact_ != nullptr) held_ = table.heldAt(mover.clip, *contact_, mover.time);
    }

    LimbTarget run(const LimbTarget& free, float dt) {
        free_ = {frame_.toGround(free.place), free.place.z * frame_.size, frame_.turn * free.rotation};
        limb_.left = std::max(0.0f, limb_.left - dt / limb_.fadeTime);
        if (limb_.left == 0.0f) limb_.steps = false;
        if (limb_.held && contact_ == nullptr) letGo(kReleaseTime, false);
        // Another clip holds the same foot otherwise: it stays where it is and turns over.
        if (limb_.held && mover_.switched) hold({limb_.place, limb_.placeHeight, limb_.rotation});
        if (limb_.held && strained()) letGo(kStepTime, true);
        if (!limb_.held && contact_ != nullptr && !limb_.steps && lasts() && low()) take();
        const bool plain = !limb_.held && limb_.left == 0.0f;
        const Spot spot = plain ? free_ : softened(limb_.held ? heldSpot() : free_);
        limb_.place = spot.place;
        limb_.placeHeight = spot.height;
        limb_.rotation = spot.rotation;
        limb_.used = true;
        if (plain) return free;
        return {frame_.toBody(spot.place, spot.height), conjugate(frame_.turn) * spot.rotation};
    }

private:
    Spot heldSpot() const {
        const double size = static_cast<double>(frame_.size);
        const Vec2 roll = limb_.frame.apply({held_.roll.x, held_.roll.y}) * size;
        return {limb_.anchor + roll, limb_.height + held_.roll.z * frame_.size,
                uprightTurn(limb_.frame) * held_.rotation};
    }

    // With what is left of a difference.
    Spot softened(Spot spot) const {
        if (limb_.left == 0.0f) return spot;
        const float w = smooth(limb_.left);
        spot.place += Vec2{static_cast<double>(limb_.offset.x * w), static_cast<double>(limb_.offset.y * w)};
        spot.height += limb_.offset.z * w;
        if (limb_.steps) spot.height += 4.0f * kStepHeight * limb_.left * (1.0f - limb_.left);
        spot.rotation = nlerp({}, limb_.turned, w) * spot.rotation;
        return spot;
    }

    void differ(const Spot& shown, const Spot& target, float time) {
        const Vec2 d = shown.place - target.place;
        limb_.offset = {static_cast<float>(d.x), static_cast<float>(d.y), shown.height - target.height};
        limb_.turned = shown.rotation * conjugate(target.rotation);
        limb_.left = 1.0f;
        limb_.fadeTime = time;
    }

    void letGo(float time, bool steps) {
        limb_.held = false;
        limb_.steps = steps;
        differ({limb_.place, limb_.placeHeight, limb_.rotation}, free_, time);
    }

    // From now on the limb is held. The point of it that touches stays where it is, and which way it points.
    void hold(const Spot& now) {
        const Vec3 tip{1.0f, 0.0f, 0.0f};
        const Vec3 points = rotate(now.rotation, tip), pointed = rotate(held_.rotation, tip);
        limb_.frame = between({static_cast<double>(pointed.x), static_cast<double>(pointed.y)},
                              {static_cast<double>(points.x), static_cast<double>(points.y)}, limb_.frame);
        limb_.height = contact_->height * (contact_->height > kFixedHeight ? 1.0f : frame_.size);
        const Vec3 point = touching(held_.rotation);
        limb_.anchor = {};
        const Spot there = heldSpot();
        limb_.anchor = under(now, point) - under(there, point);
        limb_.held = true;
        differ(now, heldSpot(), kTakeTime);
    }

    void take() {
        const double turn = static_cast<double>(held_.turn);
        limb_.frame = frame_.facing;
        if (turn != 0.0) {
            const double c = cosine(turn), s = sine(turn);
            limb_.frame = {frame_.facing.c * c + frame_.facing.s * s,
                           frame_.facing.s * c - frame_.facing.c * s};
        }
        hold(softened(free_));
    }

    // Heel or ball of a foot, whichever is lower; of a hand the wrist.
    Vec3 touching(Quat rotation) const { return number_ < 2 ? touchingPoint(rotation) : Vec3{}; }

    Vec2 under(const Spot& spot, Vec3 point) const {
        const Vec3 p = rotate(spot.rotation, point) * frame_.size;
        return spot.place + Vec2{static_cast<double>(p.x), static_cast<double>(p.y)};
    }

    // A contact that is nearly over is not worth taking.
    bool lasts() const {
        float time = mover_.time;
        if (time < contact_->begin) time += table_[mover_.clip].duration;
        return contact_->end - time > kShortest;
    }

    // Nor is a limb taken before it has come down.
    bool low() const {
        const float height = contact_->height + held_.roll.z;
        return std::fabs(softened(free_).height - height) < kTouchHeight;
    }

    bool strained() const {
        const Spot spot = heldSpot();
        const auto d = static_cast<float>(distance(spot.place, free_.place));
        const bool feet = number_ < 2;
        if (feet && other_.steps && d < kLetGoBoth) return false;
        if (d > kLetGo) return true;
        const double along = limb_.frame.c * frame_.facing.c + limb_.frame.s * frame_.facing.s;
        return feet && table_[mover_.clip].standing && along < kTwisted;
    }

    const ClipTable& table_;
    const Mover& mover_;
    const BodyFrame& frame_;
    std::size_t number_;
    HeldLimb& limb_;
    const HeldLimb& other_;
    const HeldContact* contact_;
    HeldFrame held_;
    Spot free_;
};

}  // namespace

Quat uprightTurn(const Rotation& rotation) {
    const auto c = static_cast<float>(rotation.c), s = static_cast<float>(rotation.s);
    if (c > -0.5f) {
        const float w = std::sqrt(0.5f * (1.0f + c));
        return {0.0f, 0.0f, s / (2.0f * w), w};
    }
    const float z = std::sqrt(0.5f * (1.0f - c));
    return {0.0f, 0.0f, z, s / (2.0f * z)};
}

BodyFrame::BodyFrame(const Mover& mover)
    : position(mover.position), facing(mover.facing), turn(uprightTurn(mover.facing)), size(mover.size) {}

Vec3 BodyFrame::toBody(Vec2 place, float height) const {
    const Vec2 p = facing.applyInverse(place - position);
    const float shrink = 1.0f / size;
    return {static_cast<float>(p.x) * shrink, static_cast<float>(p.y) * shrink, height * shrink};
}

LimbTarget holdLimb(const ClipTable& table, const Mover& mover, const BodyFrame& frame, std::size_t limb,
                    const LimbTarget& free, float dt, Body& body) {
    return LimbStep(table, mover, frame, limb, body).run(free, dt);
}

}  // namespace muster
