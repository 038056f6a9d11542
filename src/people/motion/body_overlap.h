// Measures how deep the drawn bodies of a crowd lie in each other, at torso and head.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "muster/motion.h"
#include "muster/world.h"

namespace muster {

/// Overlaps of the bodies that play one motion with any others.
struct MotionOverlap {
    std::string motion;           ///< Motion of the clip: "crawl", "swim"...
    double deepest = 0.0;         ///< Largest overlap [m].
    std::uint64_t pairSteps = 0;  ///< Number of pairs nearer than 2 m, summed over steps.
    std::uint64_t deepSteps = 0;  ///< Number of these pairs deeper than kDeepOverlap.
    std::uint32_t first = 0;      ///< Id of one body of the deepest pair.
    std::uint32_t second = 0;     ///< Id of the other body.
    std::string otherMotion;      ///< Motion of the other body.
    double time = 0.0;            ///< Time when they were deepest [s].
};

/// Overlap above which people see at once that two bodies overlap [m].
inline constexpr double kDeepOverlap = 0.10;

/// The solid parts of a drawn body: a torso of two capsules side by side, and a head.
struct SolidBody {
    std::array<Vec3, 2> left;   ///< Ends of the axis of the left half of the torso [m].
    std::array<Vec3, 2> right;  ///< Ends of the axis of the right half [m].
    Vec3 head;                  ///< Middle of the head [m].
    float size = 1.0f;          ///< Factor of the skeleton.
};

/// The solid parts of a body with those joints in the world.
SolidBody solidBody(const JointTransforms& joints, float size);

/// The depth of two bodies in each other [m]; negative where they are apart.
double overlapOf(const SolidBody& a, const SolidBody& b);

/// Observes the near characters of a crowd's motion step by step.
class BodyOverlapReport {
public:
    /// Call after each CrowdMotion::update.
    void observe(const World& world, const CrowdMotion& motion);
    /// One entry for each motion that was played near others, by name.
    const std::vector<MotionOverlap>& motions() const { return motions_; }
    /// Largest overlap of all [m].
    double deepest() const;

private:
    struct Placed {
        double x = 0.0;        ///< Coordinate of the character's position [m].
        std::size_t near = 0;  ///< Index into CrowdMotion::near().
    };

    void observePair(const World& world, const CrowdMotion& motion, std::size_t a, std::size_t b);
    MotionOverlap& of(const std::string& motion);

    std::vector<SolidBody> bodies_;
    std::vector<Placed> placed_;
    std::vector<MotionOverlap> motions_;
};

}  // namespace muster
