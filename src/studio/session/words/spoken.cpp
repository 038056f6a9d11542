#include "studio/session/words/spoken.h"

#include <algorithm>
#include <utility>

#include "base/maths.h"
#include "engine/world/inspect.h"
#include "engine/world/studio_access.h"
#include "muster/views.h"
#include "studio/session/inbox/answers.h"

namespace muster {
namespace {

/// The group in which somebody is; none for who has left.
GroupId groupOf(const World& world, std::uint32_t character) {
    const CharactersView people = world.characters();
    const auto at = std::find(people.id.begin(), people.id.end(), character);
    if (at == people.id.end()) return {};
    return world.group(people.group[static_cast<std::size_t>(at - people.id.begin())]).id;
}

bool isAbout(const CommandBody& body, GroupId group) {
    CommandBody other = body;
    replaceStandIn(other, group, GroupId{});
    return encodeCommand({0, 0, 0, body}) != encodeCommand({0, 0, 0, other});
}

Vec2 middleOf(const World& world, const std::vector<std::uint32_t>& ids) {
    const CharactersView people = world.characters();
    Vec2 sum;
    double count = 0.0;
    for (std::size_t i = 0; i < people.size(); ++i)
        if (std::binary_search(ids.begin(), ids.end(), people.id[i])) sum += people.position[i], count += 1.0;
    return count > 0.0 ? sum / count : sum;
}

/// Where the front is at the end of a way.
Rotation frontAt(const Order& order, const OrderForecast& forecast, Rotation now) {
    if (order.facing) return {cosine(*order.facing), sine(*order.facing)};
    if (forecast.way.size() < 2) return now;
    const Vec2 last = forecast.way.back() - forecast.way[forecast.way.size() - 2];
    const Vec2 along = normalized(last, {now.c, now.s});
    return {along.x, along.y};
}

}  // namespace

std::vector<CommandBody> commandsOf(const SpokenRest& rest, const World& world) {
    std::vector<CommandBody> bodies = rest.followers;
    for (const WordsPart& part : rest.parts) {
        const GroupId now = groupOf(world, part.character);
        if (!now || now == part.from)
            std::erase_if(bodies, [&](const CommandBody& body) { return isAbout(body, part.standIn); });
        for (CommandBody& body : bodies) replaceStandIn(body, part.standIn, now);
    }
    return bodies;
}

void addPreviews(protocol::Said& said, const Understood& understood, const World& world) {
    for (const WordsPreview& preview : understood.previews) {
        const auto g = inspect::indexOfGroup(world, preview.group);
        if (!g) continue;
        const GroupView view = world.group(*g);
        const Pose from{middleOf(world, preview.ids), view.pose.rotation};
        const OrderForecast forecast = preview.ids.empty()
                                           ? world.forecast(preview.group, preview.order)
                                           : forecastFrom(world, preview.group, preview.order, from);
        said.forecasts.push_back(forecastFrame(preview.group, forecast));
        if (preview.order.kind != OrderKind::Move) continue;
        const auto count = static_cast<std::int32_t>(preview.ids.empty() ? view.members.size()
                                                                         : preview.ids.size());
        const FormationDef& formation = preview.order.formation ? *preview.order.formation
                                                                : inspect::ownFormation(world, *g);
        const Pose at{forecast.end, frontAt(preview.order, forecast, view.pose.rotation)};
        said.places.push_back(placesFrame(world, preview.group, placesAt(formation, count, at)));
    }
}

}  // namespace muster
