// Measures how long the crowd takes for changes of formation, relative to the least possible time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/vec2.h"
#include "muster/world.h"

namespace muster {

/// One change of formation of a group.
struct FormationChangeRecord {
    FormationKind kind = FormationKind::Square;  ///< The new shape.
    double time = 0.0;                           ///< Time of the change [s].
    /// Value of the bottleneck assignment from the positions at the change to the new places [m].
    double bottleneck = 0.0;
    /// Time from the change until 95 % have arrived (SPEC 8) [s]; NaN where they never did.
    double arrived95 = 0.0;
    double arrived100 = 0.0;  ///< Time from the change until all have arrived [s]; NaN where they never did.
    double stood95 = 0.0;     ///< As arrived95, but within 0.1 m of the place [s].
    /// Characters that had not arrived when the observation of this change ended and stood still for its last
    /// 5 s.
    std::int32_t stuck = 0;
    /// Ratio of arrived95 to the time that the bottleneck takes at `speed` [m/s].
    double ratio(double speed) const { return arrived95 / (bottleneck / speed); }
    /// Ratio of stood95 to the same time.
    double strictRatio(double speed) const { return stood95 / (bottleneck / speed); }
};

/// Observes one group of a world from its first step on.
class ChangeWatch {
public:
    /// Observes the group with that index.
    explicit ChangeWatch(const World& world, std::size_t group = 0);
    /// Call after every step.
    void observe(const World& world);
    /// All changes so far. The last is as of the last observed step.
    std::vector<FormationChangeRecord> changes() const;

private:
    std::vector<Vec2> positions(const World& world) const;
    void begin(const World& world);
    FormationChangeRecord judged() const;

    std::size_t group_;
    std::uint32_t version_ = 0;
    double lastTime_ = 0.0;
    std::vector<Vec2> last_;  // Positions of the step before [m].
    FormationChangeRecord running_;
    bool watching_ = false;
    // By character: time since which it is within reach of its place [s]; infinite outside.
    std::vector<double> reachedAt_;
    std::vector<double> stoodAt_;  // By character: time since which it is within the shorter reach [s].
    std::vector<double> movedAt_;  // By character: time at which it last left its spot [s].
    std::vector<Vec2> spot_;
    std::vector<FormationChangeRecord> done_;
};

/// The value of the bottleneck assignment by straight distances: the smallest d such that every start can
/// have a place of its own at most d away [m]. 0 without starts; -1 where there are fewer places than starts.
double bottleneckWalk(std::span<const Vec2> starts, std::span<const Vec2> places);

}  // namespace muster
