// Answers to questions about orders: would they arrive, by which way, when?
#pragma once

#include "muster/session.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// The answers to a message's questions. Those about a group or an order that is gone are left out. Fails,
/// naming what is wrong, where a question is malformed or beyond a limit.
Result<protocol::Forecasts> answerForecasts(const World& world, const protocol::AskForecasts& message,
                                            const SessionLimits& limits);

}  // namespace muster
