#include "files/export/character_look.h"

#include <array>

#include "base/appearance_text.h"

namespace muster {
namespace {

struct PaletteColour {
    const char* name;
    std::uint32_t colour;
};

constexpr std::array<PaletteColour, kAccents> kShirt{{{"shirt blue", 0x1D5FD1},
                                                      {"shirt ember", 0xCB4A0E},
                                                      {"shirt green", 0x016553},
                                                      {"shirt plum", 0x87598B},
                                                      {"shirt ochre", 0x624A02},
                                                      {"shirt slate", 0x313C4B}}};
constexpr std::array<PaletteColour, kSkinTones> kSkin{{{"skin 1", 0xF1C9A5},
                                                       {"skin 2", 0xE0A97F},
                                                       {"skin 3", 0xB97A50},
                                                       {"skin 4", 0x8A5636},
                                                       {"skin 5", 0x5B3A28}}};
constexpr std::array<PaletteColour, kSkinTones> kHair{{{"hair 1", 0x15120F},
                                                       {"hair 2", 0x3A2618},
                                                       {"hair 3", 0x6B4A2B},
                                                       {"hair 4", 0x8F867C},
                                                       {"hair 5", 0x241A16}}};

NamedColour named(const PaletteColour& colour) {
    return {colour.name, colour.colour};
}

NamedColour shirt(const CharacterLook& look) {
    if (!look.chosen) return named(kShirt[look.accent]);
    return {"shirt " + colourText(*look.chosen).substr(1), *look.chosen};
}

}  // namespace

CharacterLook characterLook(std::uint32_t id, std::uint32_t group, const World& world) {
    CharacterLook look;
    // The finaliser of murmur3 mixes the id; the page uses the same function.
    std::uint32_t h = id;
    h = (h ^ (h >> 16)) * 0x85ebca6bu;
    h = (h ^ (h >> 13)) * 0xc2b2ae35u;
    h ^= h >> 16;
    std::uint32_t number = group + 1;
    look.body = static_cast<BodyKind>((h >> 25) % kBodyKindCount);
    if (group < world.groupCount()) {
        const GroupView view = world.group(group);
        number = view.id.value;
        look.chosen = view.colour;
        if (view.build) look.body = *view.build == BodyBuild::Broad ? BodyKind::Broad : BodyKind::Narrow;
    }
    look.skin = h % kSkinTones;
    look.hair = (h >> 8) % kSkinTones;
    look.accent = (number + kAccents - 1) % kAccents;
    return look;
}

NamedColour regionColour(BodyRegion region, const CharacterLook& look) {
    switch (region) {
        case BodyRegion::Skin:
            return named(kSkin[look.skin]);
        case BodyRegion::Hair:
            return named(kHair[look.hair]);
        case BodyRegion::Shirt:
            return shirt(look);
        case BodyRegion::Shoes:
            return {"shoes", 0xE9E5DE};
        case BodyRegion::Trousers:
        case BodyRegion::Count:
            break;
    }
    return {"trousers", 0x2F3B4C};
}

}  // namespace muster
