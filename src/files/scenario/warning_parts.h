// The parts of scenarioWarnings(): what is valid in a scenario but likely a mistake, one sentence each.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/ground/environment/environment.h"
#include "muster/generated/world_definitions.h"

namespace muster {

/// Warnings, at most so many.
struct WarningList {
    std::size_t most = 0;            ///< How many are kept.
    std::vector<std::string> texts;  ///< Those so far.

    /// True where no more are kept.
    bool full() const { return texts.size() >= most; }
    /// Adds one unless the list is full.
    void add(std::string text) {
        if (!full()) texts.push_back(std::move(text));
    }
};

/// A scenario and its ground at the beginning, where obstacles stand as they do then.
struct WarnedScene {
    const WorldDef& def;        ///< The scenario.
    const Environment& ground;  ///< Its ground.
    /// The bodies of each group, one for each character that is there from the beginning.
    std::vector<std::vector<Body>> bodies;

    /// The radius of a character of a group [m].
    double radiusOf(std::size_t group, std::size_t member) const {
        const double own = bodies[group][member].radius;
        return own > 0.0 ? own : def.parameters.character.radius;
    }
    /// The smallest radius of all, at most the usual one [m].
    double leastRadius() const;
    /// Distance from a point to the nearest obstacle or side of the ground [m], at most
    /// Environment::kClearanceLimit; negative in obstacles and off the ground.
    double clearance(Vec2 p) const;
};

/// A scene of a definition; the ground must outlive it.
WarnedScene warnedScene(const WorldDef& def, const Environment& ground);
/// A point as text: "(1.00, 2.00)".
std::string pointText(Vec2 p);
/// A length as text: "0.225 m".
std::string metresText(double value);
/// A group as text, by its id: `group 1 "Guests"`.
std::string groupText(const WorldDef& def, std::size_t group);
/// A thing as text, by its kind and id and, if it has one, its name: `patch 2 "Net"`.
std::string thingText(std::string_view kind, std::size_t index, const std::string& name);
/// An area as text, by its id: `exit 1 "Main door"`.
std::string areaText(const WorldDef& def, std::size_t area);
/// True where the middle of a disc of `radius` [m] can be in the area.
bool hasRoom(const WarnedScene& scene, const AreaDef& area, double radius);

/// Starts in obstacles, off the ground, and on top of others.
void warnOfStarts(const WarnedScene& scene, WarningList& warnings);
/// Exits and waiting areas that nobody can come into, sources that send nobody, lines of people through
/// obstacles, exits that are all shut, orders behind a wait without end.
void warnOfAreas(const WarnedScene& scene, WarningList& warnings);
/// People who have no way to an exit of theirs or to their waiting area, because of their size or at all.
void warnOfWays(const WarnedScene& scene, WarningList& warnings);

}  // namespace muster
