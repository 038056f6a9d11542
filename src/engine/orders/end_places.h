// The ends of a formation's places: as ordered, moved to where the formation fits, or laid out on the ground
// round the target where it fits nowhere near.
#pragma once

#include <span>
#include <vector>

#include "base/cell_list.h"
#include "engine/formation/places/free_space.h"
#include "engine/formation/places/target_separation.h"
#include "engine/orders/pairing.h"

namespace muster {

/// The end of a formation.
struct EndDef {
    std::span<const Vec2> offsets;  ///< Offsets of the places in the frame of the formation [m].
    double spacing = 1.0;           ///< Spacing of the formation [m], above 0.
    double reach = 1.0;             ///< Distance from its middle to the farthest place [m].
    Pose pose;                      ///< Pose that was ordered.
    bool moves = true;              ///< True if the whole formation may stand beside the pose, where it fits.
    std::span<const Vec2> taken = {};  ///< Points where other agents stand or will stand [m].
    Vec2 from;                         ///< Point from which the formation comes [m].
};

/// Finds the places of one formation at a time. Memory is reused.
class EndPlaces {
public:
    /// Writes free points of the space, at least `apart` [m] from each other as far as there is room, and
    /// the pose of the formation among them.
    void find(const EndDef& def, const FreeSpace& space, double apart, std::vector<Vec2>& ends, Pose& pose);

private:
    bool isTaken(Vec2 p) const;
    bool fits(const EndDef& def, const FreeSpace& space, Vec2 at, bool beside) const;
    bool findFit(const EndDef& def, const FreeSpace& space, double farthest, bool beside, Vec2& at) const;
    static bool isBeside(const EndDef& def, const FreeSpace& space, Vec2 a, Vec2 b);
    bool isJoined(const FreeSpace& space, double spacing, std::span<const Vec2> ends, Vec2 middle);
    bool isOpenTo(const EndDef& def, Vec2 at) const;
    bool findBeside(const EndDef& def, const FreeSpace& space, Vec2 there, Vec2& at) const;
    bool isNearLast(Vec2 p, double distance) const;
    bool layOut(const EndDef& def, const FreeSpace& space, double apart, std::vector<Vec2>& ends);

    CellList taken_;
    std::span<const Vec2> takenAt_;
    double apart_ = 0.5;  // Least distance to taken points [m].
    SeparationMemory separation_;
    SiteFlood flood_;
    Pairing pairing_;
    std::vector<Vec2> asked_, points_;
    std::vector<std::uint8_t> fit_, met_;
    std::vector<std::int32_t> queue_;
};

}  // namespace muster
