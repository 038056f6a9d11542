// The bodies of a crowd as steering and contacts read them: no zeros that stand for parameters.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "muster/generated/people_definitions.h"
#include "muster/parameters.h"

namespace muster {

struct Characters;

/// Share of its acceleration with which a character brakes.
inline constexpr double kBrakes = 0.8;

/// The radius of a body [m].
inline double radiusOf(const Parameters::Character& def, const Body& body) {
    return body.radius > 0.0 ? body.radius : def.radius;
}
/// The top speed of a body in the open [m/s].
inline double maxSpeedOf(const Parameters::Character& def, const Body& body) {
    return body.maxSpeed > 0.0 ? body.maxSpeed : def.maxSpeed;
}
/// The time that a body keeps from who is ahead [s].
inline double headwayOf(const Parameters::Character& def, const Body& body) {
    return body.headway > 0.0 ? body.headway : def.headway;
}
/// The top acceleration of a body [m/s^2].
inline double accelerationOf(const Parameters::Character& def, const Body& body) {
    return body.acceleration > 0.0 ? body.acceleration : def.acceleration;
}

/// What each character of a crowd is in one step. Where nobody differs from the parameters no arrays are
/// kept, and all take the short way.
class CrowdBodies {
public:
    /// Everybody is as the parameters say.
    CrowdBodies() { reset({}); }
    explicit CrowdBodies(const Parameters::Character& def) { reset(def); }
    /// Everybody is as the parameters say.
    void reset(const Parameters::Character& def);
    /// Reads what each is. `firmness` holds for each group how firmly it stands: of two of different groups
    /// the firmer one gives way hardly at all. Empty for all alike.
    void resolve(const Parameters::Character& def, const Characters& now,
                 std::span<const std::uint8_t> firmness, const Ring& ring = {});

    /// The way from one position to another, in a ring the shorter one [m].
    Vec2 between(Vec2 from, Vec2 to) const { return ring_.between(from, to); }
    const Ring& ring() const { return ring_; }  ///< Ground that is joined, if any.
    /// The time that it keeps from who is ahead [s].
    double headway(std::size_t i) const { return alike() ? def_.headway : headway_[i]; }
    bool alike() const { return radius_.empty(); }               ///< Nobody differs from the parameters.
    double largestRadius() const { return largest_; }            ///< [m]
    double fastest() const { return fastest_; }                  ///< The highest top speed [m/s].
    const Parameters::Character& usual() const { return def_; }  ///< Of who has no number of its own.

    double radius(std::size_t i) const { return alike() ? def_.radius : radius_[i]; }  ///< [m]
    double maxSpeed(std::size_t i) const {                                             ///< [m/s]
        return alike() ? def_.maxSpeed : maxSpeed_[i];
    }
    double acceleration(std::size_t i) const {  ///< [m/s^2]
        return alike() ? def_.acceleration : acceleration_[i];
    }
    /// The distance in which it brakes from its top speed, as a time at that speed [s].
    double brakingTime(std::size_t i) const { return 0.5 * maxSpeed(i) / acceleration(i); }
    /// The speed of a stream in which gaps are as long as a radius, by the law of headway: g / (T (1 - k)),
    /// at most `topSpeed` [m/s]. Who walks as fast gets on.
    double crowdedSpeed(std::size_t i, double topSpeed) const {
        const double slower = (1.0 - def_.inStep) * headway(i);
        return slower * topSpeed > radius(i) ? radius(i) / slower : topSpeed;
    }
    double longestBraking() const { return longestBraking_; }  ///< Of all [s].
    double longestHeadway() const { return longestHeadway_; }  ///< Of all [s].
    /// The gap from which on two count as near [m]: what the faster one walks in its headway. Who cannot stop
    /// within the foresight of others is near while both have to brake.
    double nearGap(std::size_t a, std::size_t b) const {
        return alike() ? farthestGap()
                       : std::max(maxSpeed_[a], maxSpeed_[b]) * std::max(nearTime_[a], nearTime_[b]);
    }
    /// Of any two [m].
    double farthestGap() const { return fastest_ * nearTime(longestHeadway_, longestBraking_); }
    /// True where steering and contacts do not move it.
    bool isFixed(std::size_t i) const { return !alike() && inverseMass_[i] == 0.0; }
    /// Distance at which two touch [m].
    double touching(std::size_t a, std::size_t b) const { return radius(a) + radius(b); }
    /// The share of a correction between two that `a` takes; `b` takes the rest. Of two fixed ones none takes
    /// any, and both answers are 0.
    double share(std::size_t a, std::size_t b) const { return alike() ? 0.5 : ownShare(a, b); }
    /// True where `a` holds its ground against `b`, who is of another group, or `b` makes room.
    bool isFirmer(std::size_t a, std::size_t b) const {
        return !alike() && group_[a] != group_[b] && firmness_[a] > firmness_[b];
    }

    /// Drops from a list, which reaches beyond the largest diameter, the pairs that are farther beyond their
    /// own touching distance than that.
    void shorten(std::span<const Vec2> positions, NeighbourList& neighbours) const;

private:
    static constexpr double kNear = 0.5;  // Who can reach each other within this time are near [s].

    double ownShare(std::size_t a, std::size_t b) const;
    double nearTime(double headway, double braking) const {
        return braking > def_.foresight ? 2.0 * braking : std::max(kNear, headway);
    }

    Parameters::Character def_;
    Ring ring_;
    double largest_ = 0.0, fastest_ = 0.0, longestBraking_ = 0.0, longestHeadway_ = 0.0;
    std::vector<double> radius_, maxSpeed_, acceleration_, headway_;
    std::vector<double> nearTime_;        // At top speed, until it meets who counts as near [s].
    std::vector<double> inverseMass_;     // 0 for who is fixed.
    std::vector<std::uint8_t> firmness_;  // That of its group.
    std::vector<std::uint32_t> group_;
};

}  // namespace muster
