// How everybody fares in a battle, judged from outside: speeds, overlaps, who stands unnoticed.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "muster/world.h"

namespace muster::scale {

/// Looks at a world after each step.
class BattleWatch {
public:
    /// `overlaps` false leaves them out, since a building was put on somebody a moment ago.
    void look(const World& world, bool overlaps);

    std::int64_t changes() const { return changes_; }  ///< Changes of place, as events tell.
    std::int32_t stuck() const { return stuck_; }      ///< Who stood, and no event said so.
    double overlap() const { return overlap_; }        ///< Deepest, as a share of the radius sum.
    double speed() const { return speed_; }            ///< Highest over one's own top speed.

private:
    struct Record {
        Vec2 last, spot;                      // Where it was in the last step, and where it stands [m].
        double since = 0.0, reported = -1e9;  // Since when, and when an event reported it [s].
        double away = 0.0;                    // Since when it is away from its place [s].
        bool counted = false;                 // It has been counted as stuck.
    };
    void lookAtOverlaps(const World& world);
    void lookAt(const World& world, std::size_t character, double topSpeed);

    std::unordered_map<std::uint32_t, Record> records_;  // By id; read by id only.
    std::vector<std::int32_t> order_;                    // Characters by x.
    std::int64_t changes_ = 0;
    std::int32_t stuck_ = 0;
    double overlap_ = 0.0, speed_ = 0.0;
};

/// Distance of a character from where its place will stand; negative where it has none [m].
double distanceFromTarget(const World& world, std::size_t character);

}  // namespace muster::scale
