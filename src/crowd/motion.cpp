#include "muster/crowd/motion.h"

namespace muster {
namespace {

// One character's motion state, updated in place.
class MotionUpdate {
public:
    MotionUpdate(const Environment& environment, Characters& characters, std::size_t i, std::vector<MotionEvent>& events)
        : environment_(environment), characters_(characters), i_(i), events_(events) {}

    void run(double dt) {
        const GroundSample ground = environment_.ground(characters_.position[i_]);
        characters_.motionTime[i_] += dt;
        const bool samePatch = ground.patch.value == characters_.patch[i_];
        const bool sameMotion = ground.motion == groundMotion();
        if (!samePatch && (characters_.patch[i_] == 0 || ground.patch.value == 0 || !sameMotion)) change(ground);
        // From one patch to another of the same motion nothing changes: together they are one patch.
        characters_.patch[i_] = ground.patch.value;
        endTransition(ground);
        rearm(ground);
    }

private:
    const ClipFacts& clip(std::int32_t motion) const {
        return environment_.def().clips[static_cast<std::size_t>(motion)];
    }

    // The motion of the patch it was in; 0 in the open, even while a transition out still plays.
    std::int32_t groundMotion() const { return characters_.patch[i_] == 0 ? 0 : characters_.motion[i_]; }

    void tell(MotionChange what, std::uint32_t value) {
        events_.push_back({what, static_cast<std::int32_t>(i_), value});
    }

    void begin(std::int32_t motion, MotionPhase phase) {
        characters_.motion[i_] = motion;
        characters_.phase[i_] = phase;
        characters_.motionTime[i_] = 0.0;
    }

    void change(const GroundSample& ground) {
        if (characters_.patch[i_] != 0) leave(ground);
        if (ground.patch.value != 0) enter(ground);
    }

    void leave(const GroundSample& ground) {
        const std::int32_t motion = characters_.motion[i_];
        tell(MotionChange::LeavePatch, characters_.patch[i_]);
        if (ground.patch.value == 0 && clip(motion).cyclic && clip(motion).transitionTime > 0.0) {
            begin(motion, MotionPhase::Leaving);
            tell(MotionChange::TransitionStart, static_cast<std::uint32_t>(motion));
        } else {
            begin(0, MotionPhase::Steady);
        }
    }

    void enter(const GroundSample& ground) {
        const ClipFacts& facts = clip(ground.motion);
        tell(MotionChange::EnterPatch, ground.patch.value);
        if (!facts.cyclic) {
            const bool again = characters_.lastSingle[i_] == ground.patch.value;
            begin(ground.motion, MotionPhase::Locked);
            if (!again) tell(MotionChange::SingleStep, static_cast<std::uint32_t>(ground.motion));
            characters_.lastSingle[i_] = ground.patch.value;
        } else if (facts.transitionTime > 0.0) {
            begin(ground.motion, MotionPhase::Entering);
            tell(MotionChange::TransitionStart, static_cast<std::uint32_t>(ground.motion));
        } else {
            begin(ground.motion, MotionPhase::Steady);
        }
    }

    void endTransition(const GroundSample& ground) {
        const MotionPhase phase = characters_.phase[i_];
        if (phase != MotionPhase::Entering && phase != MotionPhase::Leaving) return;
        const std::int32_t motion = characters_.motion[i_];
        if (characters_.motionTime[i_] < clip(motion).transitionTime) return;
        tell(MotionChange::TransitionEnd, static_cast<std::uint32_t>(motion));
        begin(ground.patch.value == 0 ? 0 : motion, MotionPhase::Steady);
    }

    // motionTime runs from the moment the single-step patch was left.
    void rearm(const GroundSample& ground) {
        if (characters_.lastSingle[i_] == 0 || ground.patch.value == characters_.lastSingle[i_]) return;
        if (characters_.motionTime[i_] >= kRearmTime) characters_.lastSingle[i_] = 0;
    }

    const Environment& environment_;
    Characters& characters_;
    std::size_t i_;
    std::vector<MotionEvent>& events_;
};

}  // namespace

void updateMotions(const Environment& environment, double dt, Characters& characters,
                   std::vector<MotionEvent>& events) {
    for (std::size_t i = 0; i < characters.size(); ++i) MotionUpdate(environment, characters, i, events).run(dt);
}

}  // namespace muster
