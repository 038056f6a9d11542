// Chooses and advances the clip of each character (SPEC C3 to C5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"
#include "muster/motion.h"
#include "people/motion/clip_table.h"
#include "people/motion/crowd_view.h"
#include "people/motion/feature_database.h"
#include "people/motion/patch_crossing.h"

namespace muster {

/// The motion state of one character.
struct Mover {
    std::uint32_t id = 0;         ///< Id of the character.
    bool fresh = true;            ///< True for a character that has just appeared.
    bool switched = false;        ///< True if this step switched to another clip or part of it.
    Vec2 position;                ///< Simulated position [m].
    Vec2 velocity;                ///< Smoothed velocity of the simulated position [m/s].
    float size = 1.0f;            ///< Size of the body relative to the skeleton.
    float cadence = 1.0f;         ///< Step frequency relative to other characters at its speed.
    std::uint16_t clip = 0;       ///< Clip played.
    std::uint16_t fromClip = 0;   ///< Clip that fades out.
    float time = 0.0f;            ///< Time in `clip` [s].
    float fromTime = 0.0f;        ///< Time in `fromClip` [s].
    float fade = 0.0f;            ///< Share of `fromClip` still shown, 0 to 1.
    float rate = 1.0f;            ///< Play rate [clip seconds per second].
    float strideX = 1.0f;         ///< Scale of steps relative to the clip: forward part.
    float strideY = 0.0f;         ///< Scale of steps relative to the clip: part to the left.
    float yaw = 0.0f;             ///< Facing [rad].
    Rotation facing;              ///< Facing as a rotation, the same as `yaw`.
    float shift = 0.0f;           ///< Yaw from the simulated heading towards a crossing [rad].
    PatchCrossing action;         ///< Crossing of a single-step patch; its patch is 0 for none.
    bool again = false;           ///< True where its motion starts again with the next update.
    std::int32_t chosen = -1;     ///< Clip chosen for it (CrowdView::chosenClips); -1 for none.
    bool chosenOver = false;      ///< True where that clip has been played to its end.
    std::uint32_t donePatch = 0;  ///< Last completed single-step patch, until the simulation clears it.
};

/// The steering target of a character in the simulation.
struct WalkTarget {
    Vec2 cruise;            ///< Velocity along the path [m/s].
    bool arriving = false;  ///< True if the place is near, so that the character steers directly to it.
    Vec2 toPlace;           ///< Vector from the character to its place [m].
    Vec2 placeVelocity;     ///< Velocity of the place [m/s].
    double topSpeed = 2.0;  ///< Top speed [m/s].
};

/// The predicted trajectory of a character with `velocity` [m/s] and direction `facing`, in its body axes,
/// scaled to a body of size 1.
Trajectory predict(Vec2 velocity, const Rotation& facing, const WalkTarget& target, float size);

/// Plays clips for all characters of a world.
class Player {
public:
    /// The table must outlive the player.
    explicit Player(const ClipTable& table);

    /// Forgets all characters.
    void restart();
    /// Call after each step of the world.
    void update(const CrowdView& crowd);
    /// State of the player between two updates.
    struct Moment {
        std::vector<Mover> movers;     ///< The states of movers().
        std::uint32_t searchSlot = 0;  ///< Slot whose characters searched last.
    };
    Moment moment() const { return {movers_, searchSlot_}; }  ///< The present moment, to go back to.
    /// Goes back, or on, to a moment of a player with the same clips.
    void goBack(const Moment& moment) { movers_ = moment.movers, searchSlot_ = moment.searchSlot; }
    /// The motion of these characters, by ids in ascending order, starts again.
    void forget(std::span<const std::uint32_t> ids);
    /// Motion states, one per character.
    const std::vector<Mover>& movers() const { return movers_; }

private:
    /// The clips that play one motion id of the world.
    struct Motion {
        ClipUse use = ClipUse::Locomotion;  ///< Use of the clip.
        std::int32_t clip = -1;             ///< Clip on a patch that never moves, -1 for none.
        std::int32_t movingClip = -1;       ///< Clip on a patch that moves, -1 for none.
        double transition = 0.0;            ///< Duration of its transitions [s].
    };
    /// One step of one character.
    struct Step {
        const CrowdView* crowd;
        std::size_t i;  ///< Index of the character.
        double dt;      ///< Duration of the step [s].
        float speed;    ///< Speed of travel [m/s].
    };

    void learnMotions(const Environment& environment);
    void matchMovers(const Characters& characters);
    void begin(Mover& mover, const Characters& characters, std::size_t i) const;
    void follow(Mover& mover, const Characters& characters, std::size_t i, double dt) const;
    void play(Mover& mover, const Step& step);
    bool playChosen(Mover& mover, const Step& step) const;
    bool playAction(Mover& mover, const Step& step);
    static bool needsAction(Mover& mover, const Step& step);
    bool airborne(std::size_t clip, float time) const;
    void startAction(Mover& mover, const Step& step) const;
    float leapRate(const Mover& mover, const Step& step, float middle) const;
    static void endAction(Mover& mover);
    void playTransition(Mover& mover, const Step& step, std::int32_t clip, double transition) const;
    void playCycle(Mover& mover, const Step& step, std::int32_t clip) const;
    void playLocomotion(Mover& mover, const Step& step) const;
    WalkTarget walkTarget(const Step& step) const;
    static std::optional<MotionSet> motionSet(const Step& step);
    float continuationCost(const Mover& mover, Trajectory trajectory, std::int32_t row) const;
    void searchLocomotion(Mover& mover, const Step& step, bool must) const;
    void advance(Mover& mover, double dt) const;
    void turnToCrossing(Mover& mover, const Step& step) const;
    void show(Mover& mover, std::size_t clip, float time) const;
    void setStride(Mover& mover, const Step& step) const;

    const ClipTable& table_;
    FeatureDatabase features_;
    std::vector<TravelTimes> travelTimes_;  ///< Travel times by clip; unused for cyclic clips.
    std::vector<Motion> motions_;
    std::vector<std::string> motionNames_;
    std::vector<Mover> movers_;
    std::vector<Mover> spare_;
    std::uint32_t searchSlot_ = 0;  ///< Slot whose characters search in this step.
};

}  // namespace muster
