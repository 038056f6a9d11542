#include "engine/steering/motion_state.h"

#include <span>

namespace muster {
namespace {

// The finite state machine of one character's motion.
class MotionStateMachine {
public:
    MotionStateMachine(const Environment& environment, Characters& characters, std::int32_t i,
                       std::vector<MotionEvent>& events)
        : environment_(environment), characters_(characters), i_(i), events_(events) {}

    void run(const GroundSample& ground, double dt) {
        const std::uint32_t before = characters_.patch[i_];
        characters_.motionTime[i_] += dt;
        if (ground.patch.value != before) {
            // Overlapping patches of one motion are one patch.
            if (before == 0 || ground.patch.value == 0 || ground.motion != groundMotion())
                change(ground);
            else if (characters_.phase[i_] == MotionPhase::Locked)
                characters_.lastSingle[i_] = ground.patch.value;
        }
        characters_.patch[i_] = ground.patch.value;
        endTransition(ground);
        allowRepetition();
    }

private:
    const ClipFacts& clip(std::int32_t motion) const { return environment_.def().clips[motion]; }

    // The motion of the patch that it was in, even while a transition out of another motion still plays; 0 in
    // the open.
    std::int32_t groundMotion() const {
        if (characters_.patch[i_] == 0) return 0;
        if (characters_.phase[i_] != MotionPhase::Leaving) return characters_.motion[i_];
        const PatchDef* patch = environment_.patch(PatchId{characters_.patch[i_]});
        return patch != nullptr ? patch->motion : characters_.motion[i_];
    }

    void addEvent(MotionChange change, std::uint32_t value) { events_.push_back({change, i_, value}); }

    void begin(std::int32_t motion, MotionPhase phase) {
        characters_.motion[i_] = motion;
        characters_.phase[i_] = phase;
        characters_.motionTime[i_] = 0.0;
    }

    bool hasTransition(std::int32_t motion) const {
        return clip(motion).cyclic && clip(motion).transitionTime > 0.0;
    }

    void beginTransition(std::int32_t motion, MotionPhase phase) {
        begin(motion, phase);
        addEvent(MotionChange::TransitionStart, static_cast<std::uint32_t>(motion));
    }

    void change(const GroundSample& ground) {
        if (characters_.patch[i_] != 0) addEvent(MotionChange::LeavePatch, characters_.patch[i_]);
        if (ground.patch.value != 0) addEvent(MotionChange::EnterPatch, ground.patch.value);
        const MotionPhase phase = characters_.phase[i_];
        const std::int32_t motion = characters_.motion[i_];
        const bool single = ground.patch.value != 0 && !clip(ground.motion).cyclic;
        // A transition out plays to its end before another motion begins. It ends at once where the character
        // comes back to the same motion, or to a single-step motion.
        const bool returns = ground.patch.value != 0 && ground.motion == motion;
        if (phase == MotionPhase::Leaving && !returns && !single) return;
        if (phase == MotionPhase::Entering || phase == MotionPhase::Leaving)
            addEvent(MotionChange::TransitionEnd, static_cast<std::uint32_t>(motion));
        const bool leaves = phase != MotionPhase::Leaving && characters_.patch[i_] != 0 &&
                            hasTransition(motion);
        if (single)
            beginSingleStep(ground);
        else if (leaves)
            beginTransition(motion, MotionPhase::Leaving);
        else
            beginGroundMotion(ground);
    }

    // Begins the motion of the ground, which is cyclic.
    void beginGroundMotion(const GroundSample& ground) {
        if (ground.patch.value != 0 && hasTransition(ground.motion))
            beginTransition(ground.motion, MotionPhase::Entering);
        else
            begin(ground.motion, MotionPhase::Steady);
    }

    void beginSingleStep(const GroundSample& ground) {
        const std::uint32_t last = characters_.lastSingle[i_];
        const bool repeated = last == ground.patch.value ||
                              environment_.onePatch(PatchId{last}, ground.patch);
        begin(ground.motion, MotionPhase::Locked);
        if (!repeated) addEvent(MotionChange::SingleStep, static_cast<std::uint32_t>(ground.motion));
        characters_.lastSingle[i_] = ground.patch.value;
    }

    void endTransition(const GroundSample& ground) {
        const MotionPhase phase = characters_.phase[i_];
        if (phase != MotionPhase::Entering && phase != MotionPhase::Leaving) return;
        const std::int32_t motion = characters_.motion[i_];
        if (characters_.motionTime[i_] < clip(motion).transitionTime) return;
        addEvent(MotionChange::TransitionEnd, static_cast<std::uint32_t>(motion));
        if (phase == MotionPhase::Leaving)
            beginGroundMotion(ground);
        else
            begin(motion, MotionPhase::Steady);
    }

    // motionTime counts from the moment when the single-step patch was left.
    void allowRepetition() {
        if (characters_.lastSingle[i_] == 0 || characters_.phase[i_] == MotionPhase::Locked) return;
        if (characters_.motionTime[i_] >= kRearmTime) characters_.lastSingle[i_] = 0;
    }

    const Environment& environment_;
    Characters& characters_;
    std::int32_t i_;
    std::vector<MotionEvent>& events_;
};

}  // namespace

void updateMotions(const Environment& environment, double dt, Characters& characters,
                   std::vector<MotionEvent>& events) {
    const bool patches = !environment.patchIds().empty();
    const std::span<const MotionPhase> phases = characters.phase;
    const std::span<const std::uint32_t> singles = characters.lastSingle;
    const std::span<const std::uint32_t> inPatch = characters.patch;
    const std::span<double> times = characters.motionTime;
    for (std::int32_t i = 0; i < std::ssize(phases); ++i) {
        // Most characters keep their motion.
        const bool steady = phases[i] == MotionPhase::Steady && singles[i] == 0;
        if (!patches && steady && inPatch[i] == 0) {
            times[i] += dt;
            continue;
        }
        const GroundSample ground = environment.ground(characters.position[i]);
        if (steady && ground.patch.value == inPatch[i])
            times[i] += dt;
        else
            MotionStateMachine(environment, characters, i, events).run(ground, dt);
    }
}

}  // namespace muster
