// The fields of a ChangeGroup and of a group's definition.
#pragma once

#include <cstddef>
#include <vector>

#include "muster/command.h"

namespace muster {

/// The numbers of the fields that the change gives, counted from 0, ascending.
std::vector<std::size_t> givenFields(ChangeGroup change);
/// Sets what the change gives and nothing else follows from: all but formation, number and people.
void setPlainFields(GroupDef& def, const ChangeGroup& change);
/// A change that gives all that the definition says.
ChangeGroup wholeChange(GroupId group, const GroupDef& def);

}  // namespace muster
