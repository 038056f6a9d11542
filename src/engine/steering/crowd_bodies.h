// The bodies of a crowd as steering and contacts read them: no zeros that stand for parameters.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "muster/generated/parameters.h"
#include "muster/generated/people_definitions.h"

namespace muster {

struct Characters;

/// Share of its acceleration with which a character brakes.
inline constexpr double kBrakingShare = 0.8;

/// The radius of a body [m].
inline double radiusOf(const Parameters::Character& def, const Body& body) {
    return body.radius > 0.0 ? body.radius : def.radius;
}
/// The top speed of a body in the open [m/s].
inline double maxSpeedOf(const Parameters::Character& def, const Body& body) {
    return body.maxSpeed > 0.0 ? body.maxSpeed : def.maxSpeed;
}
/// The time that a body keeps from the agent ahead [s].
inline double headwayOf(const Parameters::Character& def, const Body& body) {
    return body.headway > 0.0 ? body.headway : def.headway;
}
/// The top acceleration of a body [m/s^2].
inline double accelerationOf(const Parameters::Character& def, const Body& body) {
    return body.acceleration > 0.0 ? body.acceleration : def.acceleration;
}

/// Bodies of all characters in one step. Where no character differs from the parameters no arrays are kept,
/// and all take the fast path.
class CrowdBodies {
public:
    /// All characters have the bodies of the parameters.
    CrowdBodies() { reset({}); }
    explicit CrowdBodies(const Parameters::Character& def) { reset(def); }
    /// All characters have the bodies of the parameters.
    void reset(const Parameters::Character& def);
    /// Reads the bodies of characters. `firmness` holds for each group how firmly it stands: of two
    /// characters of different groups the firmer one hardly gives way. Empty where all are equal.
    void resolve(const Parameters::Character& def, const Characters& now,
                 std::span<const std::uint8_t> firmness, const Ring& ring = {});

    /// The vector from one position to another, in a ring the shorter one [m].
    Vec2 between(Vec2 from, Vec2 to) const { return ring_.between(from, to); }
    const Ring& ring() const { return ring_; }  ///< Ring in which the ground is joined, if any.
    /// The time that a character keeps from the agent ahead [s].
    double headway(std::size_t i) const { return alike() ? def_.headway : headway_[i]; }
    bool alike() const { return radius_.empty(); }  ///< True where no character differs from the parameters.
    double largestRadius() const { return largest_; }            ///< Largest radius [m].
    double fastest() const { return fastest_; }                  ///< The highest top speed [m/s].
    const Parameters::Character& usual() const { return def_; }  ///< Numbers of characters without their own.

    double radius(std::size_t i) const { return alike() ? def_.radius : radius_[i]; }  ///< [m]
    double maxSpeed(std::size_t i) const {                                             ///< [m/s]
        return alike() ? def_.maxSpeed : maxSpeed_[i];
    }
    double acceleration(std::size_t i) const {  ///< [m/s^2]
        return alike() ? def_.acceleration : acceleration_[i];
    }
    /// Time in which a character would walk its braking distance at top speed [s].
    double brakingTime(std::size_t i) const { return 0.5 * maxSpeed(i) / acceleration(i); }
    /// The speed of a stream in which gaps are as long as a radius, by the law of headway: g / (T (1 - k)),
    /// at most `topSpeed` [m/s]. An agent at this speed gets on.
    double crowdedSpeed(std::size_t i, double topSpeed) const {
        const double slower = (1.0 - def_.inStep) * headway(i);
        return slower * topSpeed > radius(i) ? radius(i) / slower : topSpeed;
    }
    double longestBraking() const { return longestBraking_; }  ///< Longest braking time [s].
    double longestHeadway() const { return longestHeadway_; }  ///< Longest headway [s].
    /// The gap from which on two characters count as near [m]: the distance that the faster one walks in its
    /// headway. A character that cannot stop within the foresight of others is near while both have to brake.
    double nearGap(std::size_t a, std::size_t b) const {
        return alike() ? farthestGap()
                       : std::max(maxSpeed_[a], maxSpeed_[b]) * std::max(nearTime_[a], nearTime_[b]);
    }
    /// The largest near gap of any two [m].
    double farthestGap() const { return fastest_ * nearTime(longestHeadway_, longestBraking_); }
    /// True for a character that steering and contacts do not move.
    bool isFixed(std::size_t i) const { return !alike() && inverseMass_[i] == 0.0; }
    /// Distance between the centres of two characters that touch [m].
    double touching(std::size_t a, std::size_t b) const { return radius(a) + radius(b); }
    /// The share of a correction between two characters that `a` takes; `b` takes the rest. If both are
    /// fixed, both answers are 0.
    double share(std::size_t a, std::size_t b) const { return alike() ? 0.5 : ownShare(a, b); }
    /// True where `a` holds its ground against `b` of another group, or `b` makes room.
    bool isFirmer(std::size_t a, std::size_t b) const {
        return !alike() && group_[a] != group_[b] && firmness_[a] > firmness_[b];
    }

    /// Drops pairs from a list that reaches beyond the largest diameter: those that are farther beyond their
    /// own touching distance than the list is.
    void shorten(std::span<const Vec2> positions, NeighbourList& neighbours) const;

private:
    // Time within which two characters that can reach each other are near [s].
    static constexpr double kNearTime = 0.5;

    double ownShare(std::size_t a, std::size_t b) const;
    double nearTime(double headway, double braking) const {
        return braking > def_.foresight ? 2.0 * braking : std::max(kNearTime, headway);
    }

    Parameters::Character def_;
    Ring ring_;
    double largest_ = 0.0, fastest_ = 0.0, longestBraking_ = 0.0, longestHeadway_ = 0.0;
    std::vector<double> radius_, maxSpeed_, acceleration_, headway_;
    std::vector<double> nearTime_;        // Time at top speed to a near character [s].
    std::vector<double> inverseMass_;     // Inverse mass; 0 for fixed characters.
    std::vector<std::uint8_t> firmness_;  // Firmness of its group.
    std::vector<std::uint32_t> group_;
};

}  // namespace muster
