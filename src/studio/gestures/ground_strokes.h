// Strokes on free ground: a cut divides formations, a loop joins or takes out (SPEC B2).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "studio/gestures/control_scheme.h"

namespace muster {

/// What a finished stroke does. Appends its commands; returns what it missed, in one sentence, or nothing.
/// A stroke that comes back to where it began is a loop: round two or more formations it joins them, round a
/// part of one it takes that part out. Another one divides every formation that it crosses from side to side.
std::string finishStroke(const World& world, std::span<const Vec2> stroke,
                         std::vector<CommandBody>& commands);

}  // namespace muster
