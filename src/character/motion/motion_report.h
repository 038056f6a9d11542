// Measures of motion: do feet slide, do knees snap, does anything sink into the floor (SPEC C3 to C6).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "muster/motion.h"
#include "muster/world.h"

namespace muster {

/// Figures of a run. What was never seen is 0.
struct MotionFigures {
    std::uint64_t bodySteps = 0;  ///< Bodies seen times steps.
    std::uint64_t contacts = 0;   ///< Contacts of feet that ended.
    double
        slideMedian = 0.0;  ///< Way that the touching point of the sole went over the floor in a contact [m].
    double slide95 = 0.0;   ///< Of 95 in 100 contacts it was no more [m].
    double slideMax = 0.0;  ///< [m]
    double lowFast = 0.0;   ///< Of soles lower than 2 cm, the share that goes faster than 0.5 m/s.
    double lowSpeed95 = 0.0;        ///< 95 in 100 of these soles go no faster [m/s].
    double kneeMax = 0.0;           ///< Fastest bending of a knee [rad/s].
    double knee999 = 0.0;           ///< 999 in 1000 are no faster [rad/s].
    double penetration = 0.0;       ///< Deepest below the floor, swimmers excepted [m].
    double penetration999 = 0.0;    ///< 999 bodies in 1000 are no deeper [m].
    double accelerationMax = 0.0;   ///< Largest of any joint in the body's own frame [m/s^2].
    double acceleration999 = 0.0;   ///< 999 in 1000 bodies have no larger one [m/s^2].
    double rateLeast = 0.0;         ///< Slowest play of a plain way to go, relative to the clip.
    double rateMost = 0.0;          ///< Fastest.
    std::uint64_t switches = 0;     ///< Changes of clip, or to another part of the same.
    std::uint64_t singleSteps = 0;  ///< Single-step motions that the simulation asked for.
    std::uint64_t actions = 0;      ///< Single-step clips that were begun.
};

/// Watches the near ones of a crowd's motion, step by step.
class MotionReport {
public:
    /// Call after each CrowdMotion::update.
    void observe(const World& world, const CrowdMotion& motion);
    /// Of all that was seen.
    MotionFigures figures() const;

private:
    static constexpr std::size_t kSolePoints = 3;  // Heel, ball, toes.
    /// A body as it was one step ago.
    struct Seen {
        std::uint32_t id = 0;
        Vec2 position;            ///< [m]
        std::uint32_t steps = 0;  ///< Seen without a break, up to 2.
        bool onFloor = false;     ///< Its soles were seen one step ago.
        std::uint16_t clip = 0;
        float time = 0.0f;
        std::array<std::array<Vec3, kSolePoints>, 2> soles{};
        std::array<float, 2> knees{};
        std::array<bool, 2> locked{};
        std::array<double, 2> slide{};
        std::array<Vec3, kJointCount> joints{};
        std::array<Vec3, kJointCount> before{};
    };

    void observeBody(const CrowdMotion& motion, std::size_t k, float dt, Seen& seen);
    void observeFeet(const JointTransforms& joints, const CrowdMotion& motion, std::size_t k, float dt,
                     Seen& seen);
    void observeClip(const MotionState& state, const ClipLibrary& library, float dt, Seen& seen);

    std::vector<Seen> seen_;
    std::vector<Seen> now_;
    std::vector<float> slides_;
    std::vector<float> lowSpeeds_;
    std::vector<float> knees_;
    std::vector<float> accelerations_;
    std::vector<float> depths_;
    MotionFigures figures_;
};

}  // namespace muster
