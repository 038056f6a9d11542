// What directors do to groups, in words for people.
#pragma once

#include <span>
#include <string>

#include "muster/command.h"
#include "muster/world.h"

namespace muster {

/// True where the command can be taken back. Fingers cannot: what they move is moved.
bool canTakeBack(const CommandBody& body);
/// What the commands of one message do: "Move", "Change shape".
std::string actLabel(std::span<const CommandBody> bodies, const World& world);
/// True for what a slider sends, again and again.
bool isContinuous(const CommandBody& body);

}  // namespace muster
