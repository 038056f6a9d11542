// Halls: worlds of rooms and corridors with crowds and exits, and their runs.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lab/measures/crossings.h"
#include "lab/measures/region.h"
#include "lab/measures/speeds.h"
#include "lab/measures/trajectories.h"
#include "lab/verify/sample.h"
#include "lab/verify/verify_scene.h"
#include "muster/world.h"

namespace muster {

/// A box from its left, lower, right and upper side [m].
inline Box boxOf(double left, double low, double right, double high) {
    return {{left, low}, {right, high}};
}
/// Corners of the box, counter-clockwise.
Polygon cornersOf(const Box& box);

/// Definition of a crowd.
struct CrowdDef {
    std::string name = "People";
    std::vector<Vec2> starts = {};       ///< Start of each person [m].
    std::vector<PeopleDef> people = {};  ///< Sorts of persons; empty for the preset's.
    std::vector<Body> bodies = {};       ///< Body of each person; empty for none.
    Order order = {};                    ///< Order that the crowd has.
    Conduct conduct = {};                ///< Conduct that the crowd has.
};

/// A world that is made of free rectangles: everything else in its box is wall.
class Hall {
public:
    /// The rectangles [m]; they may overlap. Persons are those of the preset `people`.
    explicit Hall(std::vector<Box> rooms, bool ring = false);

    /// Adds an exit, which takes out persons that come into it. `rate` as in AreaDef.
    AreaId exit(const Box& box, const std::string& name = "Exit", double rate = 0.0);
    /// Adds a standing obstacle.
    void obstacle(const Box& box);
    /// Adds a round obstacle.
    void pillar(Vec2 centre, double radius);
    /// Adds stairs whose way up has the heading `ascent` [rad], on which everybody keeps the given shares of
    /// their speed.
    void stairs(const Box& box, double ascent, double up, double down);
    void crowd(const CrowdDef& crowd);
    /// The ground outside of walls and obstacles.
    Region ground() const;

    WorldDef def;  ///< Definition of the world, which may be changed.
};

/// `count` points on a lattice of triangles in a box, moved a little by the seed, at least `margin` [m]
/// inside.
std::vector<Vec2> scattered(const Box& box, std::int32_t count, std::uint64_t seed, double margin = 0.3);
/// `count` different persons of one speed.
PeopleDef personsOf(const Distribution& speed);
/// Men of 30 to 50 years of the IMO's circulars: 0.97 to 1.62 m/s.
PeopleDef menOfImo();

/// The moment at which a person left.
struct Leaving {
    std::uint32_t id = 0;
    AreaId area;
    double time = 0.0;  ///< Time of leaving [s].
};

/// A run of a hall: its world, the positions of all persons, and the times at which they left.
class HallRun {
public:
    static Result<HallRun> start(const Hall& hall, std::uint64_t seed);

    World& world() { return *world_; }
    double time() const { return world_->time(); }
    /// Number of people who are still there.
    std::size_t present() const { return world_->characters().size(); }
    /// Steps until nobody is left or the time is over, calling `watch` after each step.
    void runUntil(double seconds, const std::function<void()>& watch = {});
    /// Steps until the time is over, calling `watch` after each step.
    void runFor(double seconds, const std::function<void()>& watch = {});

    /// Moments at which persons left, by time.
    const std::vector<Leaving>& leavings() const { return leavings_; }
    /// Time at which the last person left; kUnmeasured where somebody is left.
    double lastLeaving() const;
    /// Positions of all persons, twenty times a second.
    Trajectories trajectories() const;
    /// Largest distance of anybody's middle from the ground [m].
    double outside() const { return outside_; }
    /// Curve of the number of people who have left by each time.
    std::vector<Vec2> evacuation() const;

    /// Fills the common part of a sample: hash, time, and the picture where it is wanted, with N positions
    /// per path.
    void report(VerifySample& sample, const SceneRun& run) const;

private:
    void step(const std::function<void()>& watch);
    void look();
    std::string draw() const;

    std::optional<World> world_;
    std::optional<Region> ground_;
    std::vector<Sighting> sightings_;
    std::vector<Leaving> leavings_;
    std::vector<Box> exits_;
    double outside_ = 0.0;
};

/// The line across a corridor at `x`, from `low` to `high`: 1 is the direction +x.
inline Line uprightLine(double x, double low, double high) {
    return {{x, low}, {x, high}};
}
/// The line across at `y`, from `left` to `right`: 1 is the direction +y.
inline Line levelLine(double y, double left, double right) {
    return {{right, y}, {left, y}};
}
/// The number at the beginning of a text.
double numberIn(const std::string& text);
/// Number `index` of several words.
std::string wordIn(const std::string& text, std::size_t index);
/// Points of an N-t curve: the time of each crossing and the number of crossings by then.
std::vector<Vec2> curveOf(std::span<const Crossing> crossed);
/// Rate of sightings, whose times lie on multiples of its inverse [1/s].
inline constexpr double kSightingRate = 20.0;

}  // namespace muster
