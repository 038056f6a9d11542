// The room round each point of the ground, as far as formations need it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/ground/environment/environment.h"

namespace muster {

/// Version of a ground: the instance of an environment, and the version of its static obstacles.
struct GroundVersion {
    std::uint64_t instance = 0, version = 0;
    friend bool operator==(const GroundVersion&, const GroundVersion&) = default;
};
/// The version of an environment's present ground.
inline GroundVersion versionOf(const Environment& environment) {
    return {environment.instance(), environment.staticVersion()};
}

/// The ground in coarse cells with the distance to static obstacles: exact near obstacles, a lower bound in
/// the open. A cache: it follows from the ground alone.
class WayGround {
public:
    /// Takes over the environment, which must outlive it or the next update. Moving obstacles do not count.
    void update(const Environment& environment);

    const Environment& environment() const { return *environment_; }  ///< Environment of the last update.
    GroundVersion version() const { return version_; }                ///< Version at the last update.
    const Grid& grid() const { return grid_; }                        ///< Coarse cells.
    /// The point in a cell with most room [m].
    Vec2 point(std::int32_t cell) const { return point_[cell]; }
    double clearance(std::int32_t cell) const { return clearance_[cell]; }  ///< Room at that point [m].
    /// Distance from `p` to the nearest static obstacle or the edge of the world [m]; 0 or less inside.
    double clearanceAt(Vec2 p) const;
    /// True where some static ground is slower than other ground.
    bool uneven() const { return !slowness_.empty(); }
    /// Metres of good ground that a metre costs a formation whose middle is in a cell and which reaches
    /// `half` [m] to all sides.
    double slowness(std::int32_t cell, double half) const {
        if (slowness_.empty()) return 1.0;
        return toSlower_[cell] < half ? std::max(slowness_[cell], slower_[cell]) : slowness_[cell];
    }
    /// The slowness at a point.
    double slownessAt(Vec2 p, double half) const { return slowness(grid_.index(grid_.nearestCell(p)), half); }
    /// The least slowness of all ground.
    double leastSlowness() const { return least_; }

private:
    void roomOf(std::span<const float> near);
    void distances(std::span<const float> near);
    void findSlow(const Environment& environment);
    void spreadSlow();

    const Environment* environment_ = nullptr;
    GroundVersion version_;
    Grid fine_, grid_;
    std::int32_t factor_ = 1;       // Number of fine cells along the edge of a coarse one.
    std::vector<Vec2> point_;       // Centre of the fine cell with most room, per coarse cell [m].
    std::vector<float> clearance_;  // Room at these points [m].
    std::vector<float> distance_;   // Distance from the centre of a coarse cell [m].
    // Speeds per coarse cell; empty where all ground is equal.
    std::vector<float> slowness_;  // Greatest slowness in the cell.
    std::vector<float> slower_;    // Slowness of the nearest ground that is slower than the best.
    std::vector<float> toSlower_;  // Distance from the centre to that ground [m].
    double least_ = 1.0;
};

}  // namespace muster
