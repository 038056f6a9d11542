// Characters that have to go through a passage.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/held_spot.h"
#include "engine/state/world_state.h"
#include "engine/systems/passages/way_fields.h"

namespace muster {

/// Number of turns of a character that gets nowhere by its way: until the next command it goes without a
/// passage.
inline constexpr std::uint32_t kGaveUp = 1000;

/// The characters that have to go through a passage, and the times by each passage. Tables hold an entry per
/// character and used passage, those of the first character first.
class Crossers {
public:
    /// Finds all crossers, and keeps the passages with the shortest routes.
    void gather(const WorldState& state, const WayFields& fields);
    /// True where agents hold their ground in a passage so that no member of a group comes through; both by
    /// index, after gather().
    bool isHeld(std::size_t group, std::size_t passage) const {
        return !held_.empty() && held_[group * passages_ + passage] != 0;
    }

    /// Closes for each character that has a passage the passages that lie behind another one, whose waiting
    /// crowd it would have to cross. `way` holds an index in used() for each, -1 for none.
    void shutPast(const WorldState& state, const WayFields& fields, std::span<const std::int32_t> way);

    const std::vector<std::int32_t>& characters() const { return characters_; }  ///< Crossers, by index.
    /// Characters whose route leads past all passages: where routes round a passage that stands alone are
    /// equally long on both sides, its two sides meet and nothing parts them.
    const std::vector<std::int32_t>& past() const { return past_; }
    const std::vector<std::int32_t>& pool() const { return pool_; }  ///< The group of each crosser.
    const std::vector<std::int32_t>& used() const { return used_; }  ///< Passages of the tables, ascending.
    const std::vector<double>& arrival() const { return arrival_; }  ///< Times to the passages [s].
    const std::vector<double>& onward() const { return onward_; }    ///< Times from there to the goals [s].
    /// The way of a crosser, by its index here, through a passage, by its index in used().
    std::int32_t wayOf(std::size_t crosser, std::size_t used) const;

private:
    void findHeld(const WorldState& state);
    void gatherMember(const WorldState& state, const WayFields& fields, const Group& group, std::int32_t pool,
                      std::int32_t character);
    bool needsNone(const WorldState& state, const WayFields& fields, const Group& group,
                   std::int32_t character, Vec2 goal, double byPassage) const;
    void keepNearest(std::size_t all);
    void measureBetween(const WorldState& state, const WayFields& fields);

    std::vector<std::int32_t> characters_, past_, pool_, used_;
    std::vector<double> arrival_, onward_;
    std::vector<std::int8_t> side_;  // Side of the passage on which the character is.
    std::vector<double> least_;      // Per passage: time of the shortest route [s].
    // Per used passage, side (right, left) and used passage: time of the walk from there [s].
    std::vector<double> between_;
    std::vector<double> arrivalBefore_;  // Times of one character.
    std::size_t passages_ = 0;           // Number of all known passages.
    std::vector<std::uint8_t> held_;     // Per group and passage; empty where nobody holds its ground.
    std::vector<HeldSpot> spots_;        // Agents that hold their ground, as one group sees them.
};

}  // namespace muster
