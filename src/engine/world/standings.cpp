#include "engine/world/standings.h"

#include <numeric>
#include <utility>

#include "engine/systems/events/standing.h"
#include "engine/world/inspect.h"

namespace muster {
namespace {

/// What is said of those whom one cause bars: where it bars all who are barred, and only some of them; each
/// of several and of one.
struct BarWords {
    Standing standing;
    const char* all[2];
    const char* some[2];
};
constexpr BarWords kBars[] = {
    {Standing::Outside,
     {"their places lie outside the ground", "its place lies outside the ground"},
     {"have their places outside the ground", "has its place outside the ground"}},
    {Standing::Obstacle,
     {"their places lie in obstacles", "its place lies in an obstacle"},
     {"have their places in obstacles", "has its place in an obstacle"}},
    {Standing::Narrow,
     {"their places are too narrow", "its place is too narrow"},
     {"have places that are too narrow", "has a place that is too narrow"}},
    {Standing::NoWay,
     {"no way leads to their places", "no way leads to its place"},
     {"have no way to their places", "has no way to its place"}},
    {Standing::Crowded,
     {"others stand in the room there", "others stand in the room there"},
     {"make room for others", "makes room for others"}},
    {Standing::Stuck, {"they do not get on", "it does not get on"}, {"do not get on", "does not get on"}},
};

std::string isOrAre(std::uint32_t number) {
    return number == 1 ? " is" : " are";
}

/// Why people cannot be in their places.
std::string whyBarred(const StandingCounts& counts) {
    const std::uint32_t barred = barredOf(counts);
    std::string list;
    for (const BarWords& bar : kBars) {
        const std::uint32_t number = numberOf(counts, bar.standing);
        if (number == 0) continue;
        const std::size_t one = number == 1 ? 1 : 0;
        if (number == barred) return bar.all[one];
        list += (list.empty() ? "" : ", ") + std::to_string(number) + " " + bar.some[one];
    }
    return list;
}

}  // namespace

std::string groupTitle(const GroupView& group) {
    return group.name.empty() ? "Group " + std::to_string(group.id.value) : std::string(group.name);
}

std::vector<StandingCounts> countStandings(const World& world) {
    return countStandings(world, inspect::standings(world));
}

std::vector<StandingCounts> countStandings(const World& world, const std::vector<StandingReport>& reports) {
    std::vector<StandingCounts> counts(world.groupCount(), StandingCounts{});
    const CharactersView characters = world.characters();
    for (std::size_t i = 0; i < reports.size(); ++i)
        ++counts[characters.group[i]][static_cast<std::size_t>(reports[i].standing)];
    return counts;
}

std::uint32_t barredOf(const StandingCounts& counts) {
    std::uint32_t barred = 0;
    for (std::size_t k = 0; k < counts.size(); ++k)
        if (isBarred(static_cast<Standing>(k))) barred += counts[k];
    return barred;
}

std::string standingSentence(const StandingCounts& counts) {
    const std::uint32_t all = std::accumulate(counts.begin(), counts.end(), 0u);
    const std::uint32_t there = numberOf(counts, Standing::InPlace), barred = barredOf(counts);
    if (there == all) return "everybody is in place.";
    std::string text = there == 0 ? "nobody is in place."
                                  : std::to_string(there) + " of " + std::to_string(all) + isOrAre(there) +
                                        " in place.";
    const std::uint32_t walk = numberOf(counts, Standing::OnTheWay), held = numberOf(counts, Standing::Held);
    if (walk > 0) text += " " + std::to_string(walk) + isOrAre(walk) + " on the way.";
    if (held > 0) text += " " + std::to_string(held) + (held == 1 ? " waits." : " wait.");
    if (barred > 0) text += " " + std::to_string(barred) + " cannot be: " + whyBarred(counts) + ".";
    return text;
}

}  // namespace muster
