// Answers to questions: would orders arrive, by which way and when; where would everybody stand, and who
// could not get there?
#pragma once

#include "muster/session.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// The answers to a message's questions. Those about a group or an order that is gone are left out. Fails,
/// naming what is wrong, where a question is malformed or beyond a limit.
Result<protocol::Forecasts> answerForecasts(const World& world, const protocol::AskForecasts& message,
                                            const SessionLimits& limits);

/// The answers to a message's questions. Those about a group that is gone are left out; a formation that
/// cannot be made is answered by its problem. Fails, naming what is wrong, where a question is malformed or
/// beyond a limit.
Result<protocol::Places> answerPlaces(const World& world, const protocol::AskPlaces& message,
                                      const SessionLimits& limits);

/// A forecast of a group, of no order in its queue.
protocol::ForecastFrame forecastFrame(GroupId group, const OrderForecast& forecast);
/// Places with what keeps a group from each; only the problem where they could not be made.
protocol::PlacesFrame placesFrame(const World& world, GroupId group, const Result<std::vector<Vec2>>& places);

/// Who cannot be in its place, and why.
protocol::Standings answerStandings(const World& world, const protocol::AskStandings& message);

}  // namespace muster
