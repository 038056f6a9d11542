#include "files/edits/edited_crowd.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/easing.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/motion_state.h"
#include "engine/world/inspect.h"

namespace muster {
namespace {

constexpr double kSameTime = 1e-9;  // [s]
constexpr double kGoing = 0.5;      // Speed from which the way alone tells where somebody faces [m/s].
constexpr double kOtherWay = 0.3;   // Difference of velocities from which it counts in full [m/s].
constexpr float kEyes = 1.6f;       // Height of the eyes of who is looked at [m].

double angleOf(Vec2 v) {
    return arcTangent2(v.y, v.x);
}

/// The part that a time lies in; null for none.
template <class Part>
const Part* partAt(const std::vector<Part>& parts, double time) {
    const auto found = std::find_if(parts.begin(), parts.end(),
                                    [&](const Part& part) { return time >= part.from && time < part.to; });
    return found == parts.end() ? nullptr : &*found;
}

}  // namespace

Vec2 turnedHeading(Vec2 heading, Vec2 recorded, Vec2 velocity) {
    const double other = smoothStep(length(velocity - recorded) / kOtherWay);
    const double going = smoothStep(length(velocity) / kGoing);
    if (other * going <= 0.0) return heading;
    // Who went aside goes on aside.
    const double went = smoothStep(length(recorded) / kGoing);
    const double face = angleOf(heading);
    const double aside = went > 0.0 ? went * wrappedAngle(face - angleOf(recorded)) : 0.0;
    const double turn = other * going * wrappedAngle(angleOf(velocity) + aside - face);
    return Rotation{cosine(turn), sine(turn)}.apply(heading);
}

EditedCrowd::EditedCrowd(std::vector<TakeEdit> edits, const ClipLibrary& library)
    : edits_(std::move(edits)), people_(editedPeople(edits_)), library_(&library) {
    editOf_.resize(people_.size());
    for (std::size_t e = 0; e < edits_.size(); ++e) {
        clocks_.emplace_back(edits_[e].clock);
        for (const std::uint32_t id : edits_[e].people) {
            const auto at = std::lower_bound(people_.begin(), people_.end(), id) - people_.begin();
            editOf_[static_cast<std::size_t>(at)] = e;
        }
    }
    one_.motion.resize(1), one_.phase.resize(1), one_.motionTime.resize(1), one_.patch.resize(1);
    one_.lastSingle.resize(1), one_.position.resize(1);
}

std::span<const ShownCharacter> EditedCrowd::shown(const World& world) {
    if (people_.empty() || (begun_ && world.stepCount() == step_)) return shown_;
    const bool follows = begun_ && world.stepCount() == step_ + 1;
    std::swap(before_, shown_);
    shown_.clear();
    if (!follows) before_.clear();
    const Characters& all = inspect::characters(world);
    for (std::size_t p = 0; p < people_.size(); ++p) {
        const std::int32_t i = all.indexOf(people_[p]);
        if (i >= 0) show(world, static_cast<std::size_t>(i), p);
    }
    // What others look at is known only now.
    for (ShownCharacter& one : shown_) {
        const auto at = std::lower_bound(people_.begin(), people_.end(), one.id) - people_.begin();
        look(world, edits_[editOf_[static_cast<std::size_t>(at)]], world.time(), one);
    }
    step_ = world.stepCount();
    begun_ = true;
    return shown_;
}

void EditedCrowd::show(const World& world, std::size_t index, std::size_t person) {
    const Characters& all = inspect::characters(world);
    const std::size_t e = editOf_[person];
    const TakeEdit& edit = edits_[e];
    const double time = world.time(), dt = world.parameters().stepTime;
    ShownCharacter one;
    one.id = people_[person];
    one.clip = clipAt(edit, time);
    OwnTime own = clocks_[e].at(time);
    TrackPoint was{all.position[index], all.velocity[index], all.heading[index]};
    const bool other = std::fabs(own.time - time) > kSameTime;
    const bool known = other && tracks_ && tracks_->at(one.id, own.time / dt, was);
    if (!known) own = {time, other ? 1.0 : own.rate};
    const PinMove move = pinMove(edit.pins, own.time);
    one.moved = own.time != time || own.rate != 1.0 || !(move.offset == Vec2{}) || !(move.velocity == Vec2{});
    if (one.moved) {
        one.position = was.position + move.offset;
        one.velocity = (was.velocity + move.velocity) * own.rate;
        one.heading = turnedHeading(was.heading, was.velocity * own.rate, one.velocity);
    } else {
        one.position = was.position, one.velocity = was.velocity, one.heading = was.heading;
    }
    one.motion = all.motion[index], one.phase = all.phase[index], one.motionTime = all.motionTime[index];
    one.patch = all.patch[index], one.lastSingle = all.lastSingle[index];
    if (one.moved) goOn(inspect::environment(world), dt, !before_.empty(), one);
    shown_.push_back(one);
}

// The motion of the ground at another place, by the rules of the simulation.
void EditedCrowd::goOn(const Environment& environment, double stepTime, bool follows, ShownCharacter& one) {
    const auto last = std::lower_bound(
        before_.begin(), before_.end(), one.id,
        [](const ShownCharacter& entry, std::uint32_t id) { return entry.id < id; });
    if (follows && last != before_.end() && last->id == one.id) {
        one_.motion[0] = last->motion, one_.phase[0] = last->phase, one_.motionTime[0] = last->motionTime;
        one_.patch[0] = last->patch, one_.lastSingle[0] = last->lastSingle;
        one_.position[0] = one.position;
        std::vector<MotionEvent> events;
        updateMotions(environment, stepTime, one_, events);
        one.motion = one_.motion[0], one.phase = one_.phase[0], one.motionTime = one_.motionTime[0];
        one.patch = one_.patch[0], one.lastSingle = one_.lastSingle[0];
        return;
    }
    const GroundSample ground = environment.ground(one.position);
    if (ground.patch.value == one.patch) return;
    const bool single = ground.patch && !environment.def().clips[ground.motion].cyclic;
    one.motion = ground.motion;
    one.phase = single ? MotionPhase::Locked : MotionPhase::Steady;
    one.motionTime = 0.0;
    one.patch = ground.patch.value;
    one.lastSingle = single ? ground.patch.value : 0;
}

std::int32_t EditedCrowd::clipAt(const TakeEdit& edit, double time) const {
    const ClipPart* part = partAt(edit.clips, time);
    return part == nullptr ? -1 : library_->indexOf(part->name);
}

void EditedCrowd::look(const World& world, const TakeEdit& edit, double time, ShownCharacter& one) const {
    const LookPart* part = partAt(edit.looks, time);
    if (part == nullptr || part->person == one.id) return;
    if (part->person == 0) {
        one.look = Vec3{static_cast<float>(part->point.x), static_cast<float>(part->point.y),
                        static_cast<float>(part->height)};
        return;
    }
    const Characters& all = inspect::characters(world);
    const std::int32_t i = all.indexOf(part->person);
    if (i < 0) return;
    Vec2 at = all.position[i];
    for (const ShownCharacter& other : shown_)
        if (other.id == part->person) at = other.position;
    one.look = Vec3{static_cast<float>(at.x), static_cast<float>(at.y), kEyes};
}

}  // namespace muster
