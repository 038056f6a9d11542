// How many of each group are in their places, and what keeps the others from theirs, as a sentence.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "muster/world.h"

namespace muster {

struct StandingReport;

/// People by Standing.
using StandingCounts = std::array<std::uint32_t, kCountOf<Standing>>;

/// True where somebody neither is in its place, nor on its way, nor held.
constexpr bool isBarred(Standing standing) {
    return standing >= Standing::Stuck;
}

/// The name of a group in sentences.
std::string groupTitle(const GroupView& group);
/// How many stand so.
constexpr std::uint32_t numberOf(const StandingCounts& counts, Standing standing) {
    return counts[static_cast<std::size_t>(standing)];
}
/// The counts of each group.
std::vector<StandingCounts> countStandings(const World& world);
/// The same of reports about all characters, in their order.
std::vector<StandingCounts> countStandings(const World& world, const std::vector<StandingReport>& reports);
/// How many cannot be in their places.
std::uint32_t barredOf(const StandingCounts& counts);
/// "37 of 49 are in place. 12 cannot be: their places lie outside the ground."
std::string standingSentence(const StandingCounts& counts);

}  // namespace muster
