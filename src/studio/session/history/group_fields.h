// The fields of commands that change groups, each of which is a property of its own.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "muster/command.h"

namespace muster {

/// True where the command changes that field of a group.
template <class Value>
bool changesField(const CommandBody& body, std::optional<Value> ChangeGroup::*field) {
    const auto* change = std::get_if<ChangeGroup>(&body);
    return change != nullptr && change->*field;
}

/// The number of the first field that the change gives, counted from 0.
std::size_t firstField(const ChangeGroup& change);
/// What `whole` says of the fields that `asked` gives.
ChangeGroup sameFields(ChangeGroup whole, const ChangeGroup& asked);
/// One command for each field of a ChangeGroup; any other command as it is.
std::vector<CommandBody> singleFields(const CommandBody& body);

}  // namespace muster
