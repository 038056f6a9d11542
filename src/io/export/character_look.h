// What a character looks like in files, by its id and group: as the studio shows it.
#pragma once

#include <cstdint>

#include "character/bodies/body.h"
#include "muster/world.h"

namespace muster {

inline constexpr std::uint32_t kAccents = 6;    ///< Colours of shirts.
inline constexpr std::uint32_t kSkinTones = 5;  ///< Colours of skins, and of hairs.

/// Indices of colours.
struct CharacterLook {
    BodyKind body = BodyKind::Broad;
    std::uint32_t skin = 0;    ///< Below kSkinTones.
    std::uint32_t hair = 0;    ///< Below kSkinTones.
    std::uint32_t accent = 0;  ///< Below kAccents.

    friend auto operator<=>(const CharacterLook&, const CharacterLook&) = default;
};

/// Of the character with that id, in the group of that index.
CharacterLook characterLook(std::uint32_t id, std::uint32_t group, const World& world);

/// A colour as 0xRRGGBB, and what to call it.
struct NamedColour {
    const char* name;
    std::uint32_t colour;
};
NamedColour regionColour(BodyRegion region, const CharacterLook& look);  ///< Of a part of that character.

}  // namespace muster
