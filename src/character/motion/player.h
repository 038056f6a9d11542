// Which clip each character plays, and at what time in it (SPEC C3 to C5).
#pragma once

#include <cstdint>
#include <vector>

#include "character/motion/clip_table.h"
#include "character/motion/crowd_view.h"
#include "character/motion/feature_database.h"
#include "character/motion/patch_crossing.h"
#include "crowd/characters.h"
#include "environment/environment.h"
#include "muster/motion.h"

namespace muster {

/// What one character plays.
struct Mover {
    std::uint32_t id = 0;
    bool fresh = true;      ///< It has just appeared.
    bool switched = false;  ///< It plays another clip, or another part of it, since this step.
    Vec2 position;          ///< Simulated [m].
    Vec2 velocity;          ///< Of the simulated position, smoothed [m/s].
    float size = 1.0f;
    float cadence = 1.0f;  ///< Steps a second relative to others of its speed.
    std::uint16_t clip = 0;
    std::uint16_t fromClip = 0;
    float time = 0.0f;      ///< [s]
    float fromTime = 0.0f;  ///< [s]
    float fade = 0.0f;
    float rate = 1.0f;     ///< Clip seconds a second.
    float strideX = 1.0f;  ///< Steps relative to the clip's: share ahead.
    float strideY = 0.0f;  ///< Steps relative to the clip's: share to the left.
    float yaw = 0.0f;      ///< Facing [rad].
    Rotation facing;       ///< The same.
    float shift = 0.0f;    ///< Yaw from the simulated heading towards a crossing [rad].
    PatchCrossing action;
    std::uint32_t donePatch = 0;  ///< Single-step patch done last, until the simulation forgets it.
};

/// Where a character walks to, as the simulation steers it.
struct WalkTarget {
    Vec2 cruise;            ///< Velocity along the path [m/s].
    bool arriving = false;  ///< The place is near, so it is steered to directly.
    Vec2 toPlace;           ///< The place from here [m].
    Vec2 placeVelocity;     ///< [m/s]
    double topSpeed = 2.0;  ///< [m/s]
};

/// The predicted trajectory of a character with `velocity` [m/s] and direction `facing`, in its body axes,
/// for a body of size 1.
Trajectory predict(Vec2 velocity, const Rotation& facing, const WalkTarget& target, float size);

/// Plays clips for all characters of a world.
class Player {
public:
    /// The table must outlive this.
    explicit Player(const ClipTable& table);

    /// Forgets all characters.
    void restart();
    /// Call after each step of the world.
    void update(const CrowdView& crowd);
    /// One per character.
    const std::vector<Mover>& movers() const { return movers_; }

private:
    /// A motion id of the world.
    struct Motion {
        ClipUse use = ClipUse::Locomotion;
        std::int32_t clip = -1;        ///< What it plays.
        std::int32_t movingClip = -1;  ///< What it plays on a patch that moves.
        double transition = 0.0;       ///< Duration of its transitions [s].
    };
    /// One step of one character.
    struct Step {
        const CrowdView* crowd;
        std::size_t i;  ///< Index of the character.
        double dt;      ///< [s]
        float speed;    ///< Of travel [m/s].
    };

    void learnMotions(const Environment& environment);
    void matchMovers(const Characters& characters);
    void begin(Mover& mover, const Characters& characters, std::size_t i) const;
    void follow(Mover& mover, const Characters& characters, std::size_t i, double dt) const;
    void play(Mover& mover, const Step& step);
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
    float continuationCost(const Mover& mover, Trajectory trajectory, std::int32_t row) const;
    void searchLocomotion(Mover& mover, const Step& step, bool must) const;
    void advance(Mover& mover, double dt) const;
    void turnToCrossing(Mover& mover, const Step& step) const;
    void show(Mover& mover, std::size_t clip, float time) const;
    void setStride(Mover& mover, const Step& step) const;

    const ClipTable& table_;
    FeatureDatabase features_;
    std::vector<TravelTimes> travelTimes_;  ///< By clip; of cyclic ones unused.
    std::vector<Motion> motions_;
    std::vector<std::string> motionNames_;
    std::vector<Mover> movers_;
    std::vector<Mover> spare_;
    std::uint32_t searchSlot_ = 0;  ///< Characters of this slot search in this step.
};

}  // namespace muster
