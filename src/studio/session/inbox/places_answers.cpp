#include "studio/session/inbox/answers.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/maths.h"
#include "engine/state/validation.h"
#include "engine/systems/events/standing.h"
#include "engine/world/inspect.h"
#include "engine/world/standings.h"
#include "engine/world/studio_access.h"
#include "muster/views.h"

namespace muster {
namespace {

constexpr double kMostAskedFacing = 1e4;  // Of a question [rad].

bool isGroup(const World& world, std::uint32_t id) {
    return inspect::indexOfGroup(world, GroupId{id}).has_value();
}

bool isPlace(double value) {
    return std::fabs(value) <= kMaxCoordinate;
}

/// InvalidArgument or LimitExceeded where a question makes no sense.
Status check(const protocol::PlacesAsk& ask, const SessionLimits& limits) {
    if (!isPlace(ask.x) || !isPlace(ask.y) || !(std::fabs(ask.facing) <= kMostAskedFacing))
        return {StatusCode::InvalidArgument, "places about a centre that is not finite"};
    if (ask.places.size() % 2 != 0 || !std::all_of(ask.places.begin(), ask.places.end(), isPlace))
        return {StatusCode::InvalidArgument, "places that are not finite pairs"};
    const auto most = static_cast<std::size_t>(limits.charactersPerGroup);
    if (const std::size_t asked = std::max<std::size_t>(ask.places.size() / 2, ask.count); asked > most)
        return {StatusCode::LimitExceeded,
                "found " + std::to_string(asked) + " places, expected at most " + std::to_string(most)};
    return {};
}

/// The places of the formation that a question asks for.
Result<std::vector<Vec2>> standOf(const World& world, const protocol::PlacesAsk& ask) {
    if (Status valid = validate(*ask.formation); !valid.ok()) return valid;
    const Pose at{{ask.x, ask.y}, {cosine(ask.facing), sine(ask.facing)}};
    return placesAt(world, GroupId{ask.group}, *ask.formation, at, static_cast<int>(ask.count));
}

std::vector<Vec2> given(const protocol::PlacesAsk& ask) {
    std::vector<Vec2> places;
    for (std::size_t i = 0; i + 1 < ask.places.size(); i += 2)
        places.push_back({ask.places[i], ask.places[i + 1]});
    return places;
}

}  // namespace

protocol::PlacesFrame placesFrame(const World& world, GroupId group,
                                  const Result<std::vector<Vec2>>& places) {
    protocol::PlacesFrame frame;
    frame.group = group.value;
    if (!places.ok()) {
        frame.problem = places.status().message();
        return frame;
    }
    for (const Vec2 p : places.value()) {
        frame.places.push_back(static_cast<float>(p.x));
        frame.places.push_back(static_cast<float>(p.y));
    }
    for (const Standing bar : barsOf(world, group, places.value()))
        frame.unfit.push_back(static_cast<std::uint8_t>(bar));
    return frame;
}

Result<protocol::Places> answerPlaces(const World& world, const protocol::AskPlaces& message,
                                      const SessionLimits& limits) {
    if (message.asks.size() > limits.forecastsPerMessage)
        return Status(StatusCode::LimitExceeded, "found " + std::to_string(message.asks.size()) +
                                                     " questions about places, expected at most " +
                                                     std::to_string(limits.forecastsPerMessage));
    protocol::Places answers;
    answers.number = message.number;
    for (const protocol::PlacesAsk& ask : message.asks) {
        if (Status status = check(ask, limits); !status.ok()) return status;
        if (!isGroup(world, ask.group)) continue;
        answers.answers.push_back(
            placesFrame(world, GroupId{ask.group},
                        ask.formation ? standOf(world, ask) : Result<std::vector<Vec2>>(given(ask))));
    }
    return answers;
}

protocol::Standings answerStandings(const World& world, const protocol::AskStandings& message) {
    protocol::Standings answer;
    answer.number = message.number;
    const CharactersView characters = world.characters();
    const std::vector<StandingReport> reports = inspect::standings(world);
    for (std::size_t i = 0; i < reports.size(); ++i)
        if (isBarred(reports[i].standing))
            answer.people.push_back({characters.id[i], reports[i].standing,
                                     static_cast<float>(reports[i].wanted.x),
                                     static_cast<float>(reports[i].wanted.y)});
    return answer;
}

}  // namespace muster
