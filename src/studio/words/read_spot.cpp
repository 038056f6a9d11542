// Where: points, things, groups, directions and distances.
#include <utility>

#include "base/maths.h"
#include "studio/words/reader.h"

namespace muster::words {
namespace {

constexpr double kMostMetres = 1e5;

}  // namespace

/// True where the name of a group comes next, and not “the south edge”.
bool Reader::isGroupHere() const {
    std::size_t skip = 0;
    while (isOneOf({"to", "at", "the"}, skip)) ++skip;
    const auto found = names_.startOf(rest(skip), true);
    return !found.empty() &&
           !isOneOf({"side", "edge", "end", "corner", "wall", "of"}, skip + found.front()->words.size());
}

// True where a thing's name comes next, as “North gate”, and not “north”.
bool Reader::isThingHere() const {
    const bool to = isOneOf({"to", "at"});
    std::size_t skip = 0;
    while (isOneOf({"to", "at", "in", "into", "on", "the"}, skip)) ++skip;
    const auto found = names_.startOf(rest(skip), false);
    return !found.empty() && (to || found.front()->words.size() > 1);
}

std::optional<Spot> Reader::readSpot(bool named) {
    const std::size_t before = at_;
    if (auto spot = readPoint()) return spot;
    if (auto spot = readBetween()) return spot;
    const bool group = (named || isOneOf({"to", "at"})) && isGroupHere();
    const bool thing = isThingHere();
    if (!group && !thing)
        if (auto spot = readShift()) return spot;
    at_ = before;
    Beside beside = Beside::At;
    if (takePhrase("next to") || take({"beside", "near", "by", "alongside", "against"}) ||
        takePhrase("close to") || takePhrase("nearer to") || takePhrase("closer to"))
        beside = Beside::Near;
    else if (take({"around", "round", "about", "surrounding"}))
        beside = Beside::Around;
    else if (takePhrase("in front of"))
        beside = Beside::InFront;
    else if (take({"behind"}) || takePhrase("the back of"))
        beside = Beside::Behind;
    else
        take({"at", "in", "into", "inside", "on", "onto", "to"});
    if (!group && !thing)
        if (auto spot = readEdge()) return spot;
    auto spot = readNamed();
    if (!spot) {
        at_ = before;
        return std::nullopt;
    }
    if (beside != Beside::At) spot->beside = beside;
    return spot;
}

// The middle, a thing, a group.
std::optional<Spot> Reader::readNamed() {
    skipArticles();
    if (isOneOf({"middle", "centre", "center"})) {
        ++at_;
        if (take({"of"})) {
            skipArticles();
            if (take({"map", "place", "ground", "square", "room", "field", "stage", "scene", "screen",
                      "floor"})) {
            } else if (auto thing = readThing())
                return thing;
        }
        Spot spot;
        spot.kind = SpotKind::Middle;
        spot.words = "the middle";
        return spot;
    }
    if (auto thing = readThing()) return thing;
    const std::vector<GroupId> groups = readGroup();
    if (groups.empty()) return std::nullopt;
    Spot spot;
    spot.kind = SpotKind::Group;
    spot.group = groups.front();
    spot.words = names_.nameOf(spot.group);
    return spot;
}

// "5, -8", "(5, 8)", "x 5 y -8"
std::optional<Spot> Reader::readPoint() {
    const std::size_t before = at_;
    take({"to", "at"});
    take({"point", "position", "coordinates"});
    take({"("});
    take({"x"});
    if (const auto x = number(); x && (tokens_[at_].digits)) {
        ++at_;
        const bool comma = take({","});
        const bool named = take({"y"});
        const auto y = number();
        const bool unit = metresOf(word(1)).has_value();
        if (y && tokens_[at_].digits && (comma || named) && !unit) {
            ++at_;
            take({")"});
            Spot spot;
            spot.point = {*x, *y};
            spot.words = tokens_[at_ - 1].text;
            if (std::fabs(*x) > kMostMetres || std::fabs(*y) > kMostMetres)
                fail("That point is too far away: say at most 100,000 metres.");
            return spot;
        }
    }
    at_ = before;
    return std::nullopt;
}

std::optional<Spot> Reader::readBetween() {
    if (!take({"between"})) return std::nullopt;
    Spot spot;
    spot.kind = SpotKind::Between;
    for (int k = 0; k < 2; ++k) {
        if (k == 1) take({"and"});
        const auto one = readNamed();
        if (!one || one->kind != SpotKind::Thing) return failAtWord(), std::nullopt;
        spot.things.push_back(one->things.front());
    }
    spot.words = "between " + spot.things[0].name + " and " + spot.things[1].name;
    return spot;
}

std::optional<Heading> Reader::readHeading() {
    const std::size_t before = at_;
    take({"to", "towards", "toward", "due"});
    take({"the"});
    const auto heading = headingOf(word());
    if (!heading) return at_ = before, std::nullopt;
    ++at_;
    if (take({"-", "and"})) {
        const auto second = headingOf(word());
        const bool vertical = *heading == Heading::North || *heading == Heading::South;
        if (second && vertical && (*second == Heading::East || *second == Heading::West)) {
            ++at_;
            const bool north = *heading == Heading::North, east = *second == Heading::East;
            return north ? (east ? Heading::NorthEast : Heading::NorthWest)
                         : (east ? Heading::SouthEast : Heading::SouthWest);
        }
        --at_;
    }
    if (isCompass(*heading) && headingOf(word()) && isCompass(*headingOf(word()))) {  // "north east"
        const std::string joined = std::string(nameOf(*heading)) + std::string(word());
        if (const auto both = headingOf(joined)) return ++at_, both;
    }
    return heading;
}

// "5 metres east", "left 5 m", "10 m north of the fountain", "north"
std::optional<Spot> Reader::readShift() {
    const std::size_t before = at_;
    Spot spot;
    spot.kind = SpotKind::Shift;
    take({"another", "by", "about"});
    const auto readMetres = [&] {
        if (!number() || !metresOf(word(1))) return;
        spot.metres = *number() * *metresOf(word(1));
        at_ += 2;
    };
    readMetres();
    take({"farther", "further", "more", "to"});
    auto heading = readHeading();
    if (!heading && spot.metres && take({"from", "away"})) {
        take({"from"});
        heading = Heading::Back;
    }
    if (!heading && spot.metres && take({"behind"})) heading = Heading::Back, --at_;
    if (!heading && spot.metres && takePhrase("in front of")) heading = Heading::Forward, at_ -= 1;
    if (!heading) return at_ = before, std::nullopt;
    spot.heading = *heading;
    take({"by", "for", "about"});
    if (!spot.metres) readMetres();
    if (spot.metres && (*spot.metres > kMostMetres || *spot.metres < 0.0))
        fail("Say a distance of 0 to 100,000 metres.");
    if (isOneOf({"side", "edge", "end", "corner", "wall", "border"})) return at_ = before, std::nullopt;
    if (isOneOf({"of", "behind", "from"})) {
        ++at_;
        auto from = readNamed();
        if (!from) return at_ = before, std::nullopt;
        from->beside = Beside::Off;
        from->heading = spot.heading;
        from->metres = spot.metres;
        return from;
    }
    spot.words = std::string(nameOf(spot.heading));
    return spot;
}

// "the north edge", "the south-east corner"
std::optional<Spot> Reader::readEdge() {
    const std::size_t before = at_;
    skipArticles();
    const auto heading = readHeading();
    if (!heading || !take({"side", "edge", "end", "corner", "wall", "border"}))
        return at_ = before, std::nullopt;
    Spot spot;
    spot.kind = SpotKind::Edge;
    spot.heading = *heading;
    spot.words = "the " + std::string(nameOf(*heading)) + " " + tokens_[at_ - 1].text;
    if (take({"of"})) {
        skipArticles();
        if (!take({"map", "place", "ground", "square", "room", "field", "stage", "screen", "floor"})) --at_;
    }
    return spot;
}

// A thing by its name, or any exit, any waiting area.
std::optional<Spot> Reader::readThing() {
    const std::size_t before = at_;
    skipArticles();
    take({"nearest", "closest"});
    Spot spot;
    spot.kind = SpotKind::Thing;
    if (const auto found = names_.startOf(rest(), false); !found.empty()) {
        at_ += found.front()->words.size();
        for (const Named* one : found) spot.things.push_back(names_.thing(one->kind, one->id));
        spot.words = found.front()->name;
        return spot;
    }
    const bool door = isOneOf({"door", "doors"});
    if (door || isOneOf({"exit", "exits"})) {
        spot.things = names_.areas(AreaKind::Exit);
        spot.words = "the nearest exit";
    }
    if (isOneOf({"gate", "gates"}) || (door && spot.things.empty())) {
        spot.things = names_.gates();
        spot.words = "the nearest gate";
    } else if (isOneOf({"waiting"})) {
        spot.things = names_.areas(AreaKind::Waiting);
        spot.words = "the waiting area";
    }
    if (spot.things.empty()) return at_ = before, std::nullopt;
    ++at_;
    take({"area", "room", "zone"});
    return spot;
}

// "north", "the fountain", "left", "round", "90 degrees left", "away from the fountain", "each other"
std::optional<Facing> Reader::readFacing() {
    const std::size_t before = at_;
    Facing facing;
    if (number() && isOneOf({"degrees", "degree", "°"}, 1)) {
        const double angle = *number() * kPi / 180.0;
        at_ += 2;
        take({"to", "the"});
        take({"the"});
        const bool right = isOneOf({"right", "clockwise"});
        take({"left", "right", "clockwise", "counterclockwise", "anticlockwise"});
        facing.turn = right ? -angle : angle;
        facing.words = right ? "right" : "left";
        return facing;
    }
    take({"around", "round"});
    if (at_ > before && isEndOfClause()) {
        facing.turn = kPi;
        facing.words = "round";
        return facing;
    }
    facing.away = takePhrase("away from");
    take({"to", "towards", "toward", "at"});
    const std::size_t behind = at_;
    if (const auto heading = readHeading(); heading && !isOneOf({"side", "edge", "corner", "end"})) {
        facing.heading = heading;
        facing.words = std::string(nameOf(*heading));
        if (isGroupWord(word())) ++at_;
        return facing;
    }
    at_ = behind;
    facing.at = readSpot();
    if (!facing.at) return at_ = before, std::nullopt;
    facing.words = facing.at->words;
    return facing;
}

}  // namespace muster::words
