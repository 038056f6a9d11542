// Where groups and characters go in a take, for whoever changes their paths afterwards.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "files/edits/edit_findings.h"
#include "muster/take.h"
#include "muster/world.h"

namespace muster {

/// Steps from one point of a path to the next.
inline constexpr std::uint32_t kPathSpacing = 15;
/// Larger crowds have paths of groups only.
inline constexpr std::size_t kMostPathCharacters = 2000;

/// Gathers paths while a take is simulated, in any order of its steps.
class TakePaths {
public:
    explicit TakePaths(const Take& take);

    /// The world has made a step of the take.
    void observe(const World& world);
    /// Points of a group's middle, one per kPathSpacing steps, in their order. Empty for an unknown id, for
    /// steps before it came, and after it went. `first` becomes the step of the first point.
    std::vector<Vec2> ofGroup(GroupId group, std::uint32_t& first) const;
    /// The same of a character.
    std::vector<Vec2> ofCharacter(std::uint32_t character, std::uint32_t& first) const;
    /// The paths of all characters, in ascending order of ids, for steps of that time [s].
    std::vector<RecordedPath> all(double stepTime) const;
    bool knows(std::uint32_t character) const;  ///< True where that character has a path.
    bool knowsPeople() const;                   ///< False where the crowd is too large for that.
    /// The group whose mesh the finger of a client took hold of in that step; none where it took none.
    GroupId heldBy(std::uint32_t client, std::uint32_t touch, std::uint32_t step) const;

private:
    struct Moment {
        std::vector<std::pair<std::uint32_t, Vec2>> groups, characters;  // By id, ascending.
    };
    void observeTouches(const World& world);

    std::map<std::uint32_t, Moment> moments_;  // By step.
    // Steps in which fingers come down, and which group each of them took.
    std::map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::uint32_t>>> downs_;
    std::map<std::pair<std::uint32_t, std::pair<std::uint32_t, std::uint32_t>>, GroupId> holders_;
};

}  // namespace muster
