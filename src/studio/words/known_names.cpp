#include "studio/words/known_names.h"

#include <algorithm>
#include <array>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/world/inspect.h"
#include "muster/views.h"

namespace muster::words {
namespace {

/// Colours of groups that have chosen none, by their ids in turn.
constexpr std::array<std::string_view, 6> kAccents{"blue", "orange", "green", "purple", "yellow", "grey"};

struct ColourWord {
    std::string_view word;
    std::string_view means;  ///< The word of `kHues`.
};
constexpr std::array kColourWords{
    ColourWord{"ember", "orange"}, ColourWord{"plum", "purple"}, ColourWord{"violet", "purple"},
    ColourWord{"ochre", "yellow"}, ColourWord{"gold", "yellow"}, ColourWord{"brown", "orange"},
    ColourWord{"slate", "grey"},   ColourWord{"gray", "grey"},
};
struct Hue {
    std::string_view word;
    std::uint32_t colour;
};
constexpr std::array kHues{
    Hue{"red", 0xC62828},   Hue{"orange", 0xE66A00}, Hue{"yellow", 0xE0B000}, Hue{"green", 0x1E8E3E},
    Hue{"cyan", 0x0097A7},  Hue{"blue", 0x1D5FD1},   Hue{"purple", 0x8E44AD}, Hue{"pink", 0xE573A5},
    Hue{"white", 0xF5F5F5}, Hue{"grey", 0x808890},   Hue{"black", 0x202020},
};

std::string_view plainColour(std::string_view word) {
    if (word.size() > 1 && word.back() == 's' && !colourOf(word)) word.remove_suffix(1);  // "the reds"
    for (const ColourWord& other : kColourWords)
        if (other.word == word) return other.means;
    return word;
}

/// The hue that is nearest by the sum of squares.
std::string_view hueOf(std::uint32_t colour) {
    std::string_view nearest;
    std::int64_t least = -1;
    for (const Hue& hue : kHues) {
        std::int64_t sum = 0;
        for (const int shift : {0, 8, 16}) {
            const std::int64_t by = static_cast<std::int64_t>(colour >> shift & 255u) -
                                    static_cast<std::int64_t>(hue.colour >> shift & 255u);
            sum += by * by;
        }
        if (least >= 0 && sum >= least) continue;
        least = sum;
        nearest = hue.word;
    }
    return nearest;
}

/// Gates slide aside and back, and their paths end with the world [s].
constexpr double kWorldEnd = 1e7;
bool isGate(const ObstacleDef& def) {
    const std::vector<Waypoint>& points = def.path.waypoints;
    return !def.polygon.empty() && !points.empty() && !def.path.loop && points.back().time == kWorldEnd;
}

bool begins(std::span<const Token> tokens, const std::vector<std::string>& words) {
    if (words.empty() || tokens.size() < words.size()) return false;
    for (std::size_t k = 0; k < words.size(); ++k)
        if (tokens[k].text != words[k]) return false;
    return true;
}

}  // namespace

double ThingSpot::reach(Vec2 direction) const {
    double most = radius;
    for (const Vec2 p : outline) most = std::max(most, dot(p - centre, direction));
    return most;
}

std::optional<std::uint32_t> colourOf(std::string_view word) {
    for (const Hue& hue : kHues)
        if (hue.word == word) return hue.colour;
    for (const ColourWord& other : kColourWords)
        if (other.word == word) return colourOf(other.means);
    return std::nullopt;
}

KnownNames::KnownNames(const World& world) : world_(world) {
    const auto put = [&](NamedKind kind, std::uint32_t id, std::string_view name) {
        std::vector<std::string> words = wordsOfName(name);
        if (!words.empty()) names_.push_back({kind, id, std::string(name), std::move(words)});
    };
    for (std::size_t g = 0; g < world.groupCount(); ++g)
        put(NamedKind::Group, world.group(g).id.value, world.group(g).name);
    for (const ObstacleId id : world.obstacleIds())
        put(NamedKind::Obstacle, id.value, world.obstacle(id).def.name);
    for (const PatchId id : world.patchIds()) put(NamedKind::Patch, id.value, world.patch(id).def.name);
    for (std::size_t a = 0; a < world.areaCount(); ++a)
        put(NamedKind::Area, world.area(a).id.value, world.area(a).def.name);
}

std::vector<const Named*> KnownNames::startOf(std::span<const Token> tokens, bool groups) const {
    std::vector<const Named*> found;
    std::size_t longest = 0;
    for (const Named& named : names_) {
        if ((named.kind == NamedKind::Group) != groups || !begins(tokens, named.words)) continue;
        if (named.words.size() > longest) found.clear();
        longest = std::max(longest, named.words.size());
        if (named.words.size() == longest) found.push_back(&named);
    }
    return found;
}

std::vector<GroupId> KnownNames::ofColour(std::string_view word) const {
    const std::string_view colour = plainColour(word);
    std::vector<GroupId> groups;
    for (std::size_t g = 0; g < world_.groupCount(); ++g) {
        const GroupView view = world_.group(g);
        const std::string_view own = view.colour
                                         ? hueOf(*view.colour)
                                         : kAccents[(view.id.value + kAccents.size() - 1) % kAccents.size()];
        if (own == colour) groups.push_back(view.id);
    }
    return groups;
}

std::string KnownNames::nameOf(GroupId group) const {
    const auto g = inspect::indexOfGroup(world_, group);
    return g ? std::string(world_.group(*g).name) : std::string();
}

ThingSpot KnownNames::thing(NamedKind kind, std::uint32_t id) const {
    ThingSpot spot;
    spot.kind = kind;
    spot.id = id;
    if (kind == NamedKind::Obstacle) {
        const ObstacleView view = world_.obstacle(ObstacleId{id});
        spot.name = view.def.name;
        spot.outline = view.outline;
        spot.centre = view.centre;
        spot.radius = view.outline.empty() ? view.def.radius : 0.0;
        if (isGate(view.def)) spot.doorway = centroid(view.def.polygon);
    } else if (kind == NamedKind::Patch) {
        const PatchView view = world_.patch(PatchId{id});
        spot.name = view.def.name;
        spot.outline = view.outline;
    } else {
        for (std::size_t a = 0; a < world_.areaCount(); ++a) {
            if (world_.area(a).id.value != id) continue;
            const AreaView view = world_.area(a);
            spot.name = view.def.name;
            spot.outline = view.def.polygon;
            spot.area = view.def.kind;
        }
    }
    if (!spot.outline.empty()) spot.centre = centroid(spot.outline);
    return spot;
}

std::vector<ThingSpot> KnownNames::gates() const {
    std::vector<ThingSpot> gates;
    for (const ObstacleId id : world_.obstacleIds())
        if (isGate(world_.obstacle(id).def)) gates.push_back(thing(NamedKind::Obstacle, id.value));
    return gates;
}

std::vector<ThingSpot> KnownNames::areas(AreaKind kind) const {
    std::vector<ThingSpot> areas;
    for (std::size_t a = 0; a < world_.areaCount(); ++a)
        if (world_.area(a).def.kind == kind) areas.push_back(thing(NamedKind::Area, world_.area(a).id.value));
    return areas;
}

}  // namespace muster::words
