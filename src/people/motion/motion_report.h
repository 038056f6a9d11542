// Measures the quality of motion: foot sliding, knee speed, floor penetration, acceleration (SPEC C3 to C6).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "muster/motion.h"
#include "muster/world.h"

namespace muster {

/// Figures of a run. Figures without any sample are 0.
struct MotionFigures {
    std::uint64_t bodySteps = 0;    ///< Number of bodies observed, summed over steps.
    std::uint64_t contacts = 0;     ///< Number of finished contacts of feet.
    double slideMedian = 0.0;       ///< Slide of the sole's touching point in a contact, median [m].
    double slide95 = 0.0;           ///< 95th percentile of the slide [m].
    double slideMax = 0.0;          ///< Largest slide [m].
    double lowFast = 0.0;           ///< Share of soles lower than 2 cm that are faster than 0.5 m/s.
    double lowSpeed95 = 0.0;        ///< 95th percentile of the speed of soles lower than 2 cm [m/s].
    double kneeMax = 0.0;           ///< Largest angular speed of a knee [rad/s].
    double knee999 = 0.0;           ///< 99.9th percentile of the speed of knees [rad/s].
    double penetration = 0.0;       ///< Largest depth below the floor, without swimmers [m].
    double penetration999 = 0.0;    ///< 99.9th percentile of the depth [m].
    double accelerationMax = 0.0;   ///< Largest acceleration of a joint in the body axes [m/s^2].
    double acceleration999 = 0.0;   ///< 99.9th percentile of the acceleration [m/s^2].
    double rateLeast = 0.0;         ///< Lowest play rate of locomotion.
    double rateMost = 0.0;          ///< Highest play rate of locomotion.
    std::uint64_t switches = 0;     ///< Number of switches to another clip or another part of the same clip.
    std::uint64_t singleSteps = 0;  ///< Number of single-step motions that the simulation requested.
    std::uint64_t actions = 0;      ///< Number of single-step clips that were started.
};

/// Observes the near characters of a crowd's motion step by step.
class MotionReport {
public:
    /// Call after each CrowdMotion::update.
    void observe(const World& world, const CrowdMotion& motion);
    /// Figures of all observations.
    MotionFigures figures() const;

private:
    static constexpr std::size_t kSolePoints = 3;  // Number of points of a sole: heel, ball, toes.
    /// State of a body one step ago.
    struct Seen {
        std::uint32_t id = 0;     ///< Id of the character.
        Vec2 position;            ///< Position of the character [m].
        std::uint32_t steps = 0;  ///< Number of steps observed without a gap, up to 2.
        bool onFloor = false;     ///< True if its soles were observed one step ago.
        std::uint16_t clip = 0;   ///< Clip that it played.
        float time = 0.0f;        ///< Time in the clip [s].
        std::array<std::array<Vec3, kSolePoints>, 2> soles{};  ///< Points of both soles [m].
        std::array<float, 2> knees{};                          ///< Angles of the knees [rad].
        std::array<bool, 2> locked{};                          ///< True for a locked foot.
        std::array<double, 2> slide{};           ///< Slide of each foot in its present contact [m].
        std::array<Vec3, kJointCount> joints{};  ///< Positions of the joints in the body axes [m].
        std::array<Vec3, kJointCount> before{};  ///< Positions of the joints two steps ago.
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
