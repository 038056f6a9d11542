// The names that a sentence may use: groups by name, number and colour, and things.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/world.h"
#include "studio/words/tokens.h"

namespace muster::words {

/// What a name is of.
enum class NamedKind : std::uint8_t { Group, Obstacle, Patch, Area };

/// A group or a thing that has a name.
struct Named {
    NamedKind kind = NamedKind::Group;
    std::uint32_t id = 0;
    std::string name;                ///< As people see it.
    std::vector<std::string> words;  ///< In small letters.
};

/// A thing on the ground.
struct ThingSpot {
    std::string name;  ///< "Fountain".
    NamedKind kind = NamedKind::Obstacle;
    std::uint32_t id = 0;
    Vec2 centre;                ///< [m]
    std::vector<Vec2> outline;  ///< Corners [m]; empty for a disc.
    double radius = 0.0;        ///< Of a disc [m].
    AreaKind area = AreaKind::Exit;
    std::optional<Vec2> doorway;  ///< Of a gate: the middle of the gap that it shuts [m].

    /// How far it reaches from its centre in a direction [m].
    double reach(Vec2 direction) const;
};

/// All names of a world.
class KnownNames {
public:
    explicit KnownNames(const World& world);

    /// The longest name of that kind, or of any where none is given, with which the tokens begin. Several
    /// things of one name: all of them.
    std::vector<const Named*> startOf(std::span<const Token> tokens, bool groups) const;
    /// The groups of a colour; empty where the word is no colour or no group has it.
    std::vector<GroupId> ofColour(std::string_view word) const;
    const std::vector<Named>& all() const { return names_; }
    std::string nameOf(GroupId group) const;
    ThingSpot thing(NamedKind kind, std::uint32_t id) const;
    std::vector<ThingSpot> gates() const;
    std::vector<ThingSpot> areas(AreaKind kind) const;

private:
    const World& world_;
    std::vector<Named> names_;
};

/// 0xRRGGBB of a colour's name; none for other words.
std::optional<std::uint32_t> colourOf(std::string_view word);

}  // namespace muster::words
