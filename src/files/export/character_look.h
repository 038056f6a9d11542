// The look of a character in exported files, by its id and group: the same as in the studio.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include "muster/world.h"
#include "people/bodies/body_mesh.h"

namespace muster {

inline constexpr std::uint32_t kAccents = 6;    ///< Number of shirt colours.
inline constexpr std::uint32_t kSkinTones = 5;  ///< Number of skin colours and of hair colours.

/// Indices of a character's colours.
struct CharacterLook {
    BodyKind body = BodyKind::Broad;
    std::uint32_t skin = 0;               ///< Below kSkinTones.
    std::uint32_t hair = 0;               ///< Below kSkinTones.
    std::uint32_t accent = 0;             ///< Below kAccents.
    std::optional<std::uint32_t> chosen;  ///< Shirt, 0xRRGGBB, where the group has a colour of its own.

    friend bool operator==(const CharacterLook&, const CharacterLook&) = default;
    /// Orders looks, to keep them in a map.
    friend bool operator<(const CharacterLook& a, const CharacterLook& b) {
        return std::tie(a.body, a.skin, a.hair, a.accent, a.chosen) <
               std::tie(b.body, b.skin, b.hair, b.accent, b.chosen);
    }
};

/// The look of the character with that id, in the group of that index.
CharacterLook characterLook(std::uint32_t id, std::uint32_t group, const World& world);

/// A colour as 0xRRGGBB, and its name.
struct NamedColour {
    std::string name;
    std::uint32_t colour;
};
/// The colour of a part of that character's body.
NamedColour regionColour(BodyRegion region, const CharacterLook& look);

}  // namespace muster
