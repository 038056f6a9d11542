// The game: a hundred units, their orders, and a tower that shoots at them. It knows Muster, and no SDL.
#pragma once

#include <muster/world.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace game {

using muster::Vec2;
using Ids = std::set<std::uint32_t>;  ///< Units by the ids of their characters.

inline constexpr Vec2 kTower{14.0, 7.0};        ///< [m]
inline constexpr double kTowerRadius = 1.2;     ///< [m]
inline constexpr double kTowerReach = 8.5;      ///< [m]
inline constexpr double kReload = 0.8;          ///< Between two shots [s].
inline constexpr double kFallenSeconds = 60.0;  ///< For which the fallen lie on the field [s].

/// A unit as it is drawn between two steps.
struct UnitPose {
    std::uint32_t id = 0;
    std::uint32_t group = 0;  ///< Id of its group.
    Vec2 position;            ///< [m]
    Vec2 heading;             ///< Unit vector.
};
struct Fallen {
    Vec2 position;  ///< [m]
    double time;    ///< When [s].
};

/// Advances in steps of the world's own time; between two steps, poses are interpolated.
class Battle {
public:
    /// Makes the world, which steps on these threads.
    static muster::Result<Battle> create(const muster::TaskRunner& runner);

    double stepTime() const { return world_.parameters().stepTime; }
    void step();
    /// All units, a share of a step after the last step but one.
    std::vector<UnitPose> poses(double share) const;
    /// Units whose bodies lie in a rectangle, or at a point where both corners are equal.
    Ids unitsIn(Vec2 corner, Vec2 opposite) const;

    /// The units get an order together. Those of several groups become one, and leave the others of theirs.
    void order(const Ids& units, muster::Order order);
    /// Every group of theirs is divided into two, side by side.
    void split(const Ids& units);
    /// They fall.
    void fall(const Ids& units);

    const muster::World& world() const { return world_; }
    const std::vector<Fallen>& fallen() const { return fallen_; }
    /// Where the last shot hit, and how long ago [s].
    std::optional<Fallen> lastShot() const { return lastShot_; }

private:
    struct PendingOrder {
        Ids units;
        muster::Order order;
        std::uint32_t step;  // From which on its units are by themselves.
    };

    explicit Battle(muster::World world);
    void send(muster::CommandBody body);
    Ids membersOf(const muster::GroupView& group) const;
    void carryOut(const PendingOrder& pending);
    void shoot();
    void keepPoses();

    muster::World world_;
    std::uint32_t sequence_ = 0;
    std::vector<PendingOrder> pending_;
    std::vector<UnitPose> before_, now_;  // In ascending order of ids.
    std::vector<Fallen> fallen_;
    std::optional<Fallen> lastShot_;
    double nextShot_ = 0.0;
};

}  // namespace game
