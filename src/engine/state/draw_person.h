// What each new member of a group is, drawn by the sorts of persons of the group and the seed of the world.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/generated/world_definitions.h"
#include "muster/people.h"

namespace muster {

/// What a random share of a person decides. Its number goes into the hash: new ones come last.
enum class Drawn : std::uint32_t { Sort, Speed, Radius, Headway, Premovement, Age };

/// A random number in (0, 1) by the seed of the world, the id of a character and what it decides, and by
/// nothing else: no number of a person moves where others are drawn, or other persons are.
double randomShare(std::uint64_t seed, std::uint32_t character, Drawn what);

/// A person of this sort: the numbers that the sort draws, and for those that it leaves those of `body`.
/// Left are distributions that are constantly 0, a class of 0 and shares of stairs of 0, and what sorts do
/// not know: acceleration, mass and supply.
Body drawPerson(const PeopleDef& sort, Body body, std::uint64_t seed, std::uint32_t character);

/// The member of a group with this index, the character with this id, who comes alone, as by a source: its
/// sort is drawn, each by its share. Where the group has no sorts it is as `bodies` say.
Body drawMember(const GroupDef& def, std::size_t index, std::uint64_t seed, std::uint32_t character);

/// The first members of a group, who come at once; their ids begin with `first`. Of each sort there are as
/// many as its share says, by largest remainders (of equal ones the former), at random ranks.
std::vector<Body> drawMembers(const GroupDef& def, std::uint64_t seed, std::uint32_t first);

/// Draws all of these at once by the sorts: of each there are as many as its share says, at random ranks.
/// `bodies` are theirs, in the order of `ids`, and keep the numbers that their sort leaves. Without sorts
/// nothing happens.
void drawAll(const std::vector<PeopleDef>& people, std::uint64_t seed, std::span<const std::uint32_t> ids,
             std::span<Body> bodies);

/// The body of the member with this index, where each number that a sort of its group draws is that of
/// GroupDef::bodies again.
Body withoutSorts(const GroupDef& def, std::size_t index, Body body);

}  // namespace muster
