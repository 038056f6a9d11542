// Raw inputs and marks of control schemes as messages.
#pragma once

#include "muster/session.h"
#include "studio/gestures/control_scheme.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

/// The message as an input that happens at `time`, in world time [s].
InputEvent inputOf(const protocol::RawInput& raw, double time);
/// The message as a view. Fails where it holds no nine numbers, or none that can be inverted.
Result<GroundView> groundViewOf(const protocol::SetView& message);
/// Checks a message's number of inputs and their times.
Status checkInputs(const protocol::Inputs& message, const SessionLimits& limits);
/// What is to be shown of a scheme of that name.
protocol::Marks marksOf(std::string name, const SchemeMarks& marks);
/// The scheme for a list to choose from.
protocol::SchemeInfo infoOf(const NamedScheme& scheme);
/// x, y of each.
std::vector<float> pairsOf(const std::vector<Vec2>& points);

}  // namespace muster
