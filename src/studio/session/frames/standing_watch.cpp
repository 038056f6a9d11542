#include "studio/session/frames/standing_watch.h"

#include <algorithm>
#include <string>

#include "engine/ground/environment/environment.h"
#include "engine/systems/events/standing.h"
#include "engine/world/inspect.h"

namespace muster {
namespace {

constexpr std::uint32_t kLookPeriod = 15;  // Steps between two looks.
constexpr std::int32_t kRestLooks = 4;     // Looks without a change after which people have come to rest.

/// The middle of those members of a group who cannot be in their places; there must be some.
Vec2 middleOfBarred(const World& world, std::size_t group, const std::vector<StandingReport>& reports) {
    Vec2 sum;
    double number = 0.0;
    for (const std::int32_t i : world.group(group).members) {
        if (!isBarred(reports[i].standing)) continue;
        sum += world.characters().position[i];
        number += 1.0;
    }
    return sum / number;
}

/// True while a finger holds the mesh: whoever bends it sees where it lies.
bool isInHand(const GroupView& group) {
    return std::any_of(group.controls.begin(), group.controls.end(), [](const Control& control) {
        return std::any_of(control.points.begin(), control.points.end(),
                           [](const ControlPoint& point) { return point.down; });
    });
}

/// True where people may have come into obstacles.
bool anybodyCame(const World& world) {
    return std::any_of(world.events().begin(), world.events().end(), [](const Event& event) {
        return event.kind == EventKind::GroupAdded || event.kind == EventKind::Joined;
    });
}

}  // namespace

// A place to which no way leads is announced when the order is given: there is no need to repeat it.
void StandingWatch::heed(const World& world) {
    for (const Event& event : world.events()) {
        if (event.kind == EventKind::NoPath || event.kind == EventKind::Partial ||
            event.kind == EventKind::Blocked)
            groups_[event.subject].without = event.value;
        if (event.kind == EventKind::Free) groups_[event.subject].without = 0;
    }
}

void StandingWatch::look(const World& world, std::vector<EventNotice>& notices) {
    const std::vector<StandingReport> reports = inspect::standings(world);
    const std::vector<StandingCounts> all = countStandings(world, reports);
    for (std::size_t g = 0; g < all.size(); ++g) {
        const GroupView group = world.group(g);
        Known& known = groups_[group.id.value];
        const StandingCounts& counts = all[g];
        const bool rests = counts == known.counts && numberOf(counts, Standing::OnTheWay) == 0 &&
                           !isInHand(group);
        known.rests = rests ? known.rests + 1 : 0;
        known.counts = counts;
        // Most of the group set out again: what is found next is news.
        if (2 * numberOf(counts, Standing::OnTheWay) > static_cast<std::uint32_t>(group.count))
            known.announced = 0;
        if (known.rests < kRestLooks) continue;
        const std::uint32_t barred = barredOf(counts);
        const bool isKnown = barred == std::min(known.without, numberOf(counts, Standing::NoWay)) ||
                             barred == numberOf(counts, Standing::Stuck);
        if (barred > known.announced && !isKnown)
            notices.push_back({protocol::NoticeLevel::Warning, "standing",
                               groupTitle(group) + ": " + standingSentence(counts),
                               middleOfBarred(world, g, reports)});
        known.announced = barred;
    }
}

// Who stands in an obstacle that was put there walks out of it.
void StandingWatch::findBuried(const World& world, std::vector<EventNotice>& notices) {
    const Environment& environment = inspect::environment(world);
    Vec2 sum;
    std::uint32_t number = 0;
    for (const Vec2 p : world.characters().position) {
        if (environment.distanceToObstacle(p, 0.0) >= 0.0) continue;
        ++number;
        sum += p;
    }
    if (number == 0) return;
    const bool one = number == 1;
    notices.push_back({protocol::NoticeLevel::Warning, "buried",
                       std::to_string(number) + (one ? " person stands" : " people stand") +
                           " inside an obstacle; " + (one ? "it walks" : "they walk") + " out.",
                       sum / number});
}

void StandingWatch::observe(const World& world, std::vector<EventNotice>& notices) {
    const std::uint64_t ground = inspect::environment(world).staticVersion();
    if (ground_ != ground || anybodyCame(world)) findBuried(world, notices);
    ground_ = ground;
    heed(world);
    if (world.stepCount() % kLookPeriod == 0) look(world, notices);
}

}  // namespace muster
