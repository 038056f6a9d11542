#include "session/command_text.h"

#include <string>
#include <utility>
#include <variant>

#include "muster/scenario.h"

namespace muster {
namespace {

constexpr const char* kSource = "commands";

template <class... Allowed>
bool isOneOf(const CommandBody& body) {
    return (std::holds_alternative<Allowed>(body) || ...);
}

bool allowed(const CommandBody& body) {
    return isOneOf<GiveOrder, EditQueue, SetConduct, AddCharacters, RemoveCharacters, TransferCharacters,
                   SplitGroup, MergeGroups, SetBodies, SetRoles, SetDemands, SetFormation, SetPose, AddGroup>(
        body);
}

Status beyondLimit(const char* what, std::size_t found, std::size_t most) {
    return {StatusCode::LimitExceeded,
            "found " + std::to_string(found) + " " + what + ", expected at most " + std::to_string(most)};
}

}  // namespace

Result<std::vector<CommandBody>> parseCommandText(std::string_view text, const SessionLimits& limits) {
    if (text.size() > limits.commandBytes)
        return beyondLimit("bytes of commands", text.size(), limits.commandBytes);
    auto commands = parseCommands(text, kSource, 1.0);
    if (!commands.ok()) return commands.status();
    if (commands->size() > limits.commandsPerMessage)
        return beyondLimit("commands", commands->size(), limits.commandsPerMessage);
    std::vector<CommandBody> bodies;
    for (Command& command : *commands) {
        const std::string where = std::string(kSource) + ": $[" + std::to_string(bodies.size()) + "]: ";
        if (!allowed(command.body))
            return Status(StatusCode::InvalidArgument,
                          where + "found a command of another kind, expected an order or a change of units");
        const auto* join = std::get_if<AddCharacters>(&command.body);
        const auto most = static_cast<std::size_t>(limits.charactersPerGroup);
        if (join != nullptr && join->positions.size() > most)
            return beyondLimit("characters", join->positions.size(), most);
        const auto* group = std::get_if<AddGroup>(&command.body);
        if (group != nullptr && group->group.count > limits.charactersPerGroup)
            return beyondLimit("characters", static_cast<std::size_t>(group->group.count), most);
        bodies.push_back(std::move(command.body));
    }
    return bodies;
}

}  // namespace muster
