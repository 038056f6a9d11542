// The fields of a ChangeGroup and of a group's definition.
#pragma once

#include "muster/command.h"

namespace muster {

/// Sets what the change gives and nothing else follows from: all but formation, number and people.
void setPlainFields(GroupDef& def, const ChangeGroup& change);
/// A change that gives all that the definition says.
ChangeGroup wholeChange(GroupId group, const GroupDef& def);

}  // namespace muster
