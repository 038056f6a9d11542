// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// What the fields of a command have to be together: InvalidArgument where they are not.
#pragma once

#include "muster/command.h"

namespace muster {

Status relations(const AddControl& c);
Status relations(const ChangeGroup& c);
Status relations(const PutThing& c);
Status relations(const SetParameter& c);
Status relations(const AddCharacters& c);
Status relations(const SplitGroup& c);
Status relations(const MergeGroups& c);
Status relations(const ChangeCharacters& c);
Status relations(const WriteMotion& c);

}  // namespace muster
