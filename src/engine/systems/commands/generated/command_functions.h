// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// How each kind of command is applied: the one function that is written for it.
#pragma once

#include "engine/systems/commands/command_context.h"

namespace muster {

Status apply(CommandContext& context, const Touch& c);
Status apply(CommandContext& context, const AddControl& c);
Status apply(CommandContext& context, const EditControl& c);
Status apply(CommandContext& context, const ReleaseClient& c);
Status apply(CommandContext& context, const ChangeGroup& c);
Status apply(CommandContext& context, const SetPose& c);
Status apply(CommandContext& context, const AddGroup& c);
Status apply(CommandContext& context, const RemoveGroup& c);
Status apply(CommandContext& context, const PutThing& c);
Status apply(CommandContext& context, const RemoveThing& c);
Status apply(CommandContext& context, const SetParameter& c);
Status apply(CommandContext& context, const GiveOrder& c);
Status apply(CommandContext& context, const EditQueue& c);
Status apply(CommandContext& context, const AddCharacters& c);
Status apply(CommandContext& context, const TransferCharacters& c);
Status apply(CommandContext& context, const SplitGroup& c);
Status apply(CommandContext& context, const MergeGroups& c);
Status apply(CommandContext& context, const ChangeCharacters& c);
Status apply(CommandContext& context, const WriteMotion& c);
Status apply(CommandContext& context, const ReverseQueue& c);

}  // namespace muster
