#include "studio/session/inbox/command_text.h"

#include <string>
#include <utility>
#include <variant>

#include "muster/scenario.h"
#include "studio/session/inbox/generated/command_traits.h"

namespace muster {
namespace {

constexpr const char* kSource = "commands";

bool directs(const CommandBody& body) {
    return traitsOf(body).directs;
}

bool editsPlace(const CommandBody& body) {
    return traitsOf(body).edits;
}

Status beyondLimit(const char* what, std::size_t found, std::size_t most) {
    return {StatusCode::LimitExceeded,
            "found " + std::to_string(found) + " " + what + ", expected at most " + std::to_string(most)};
}

/// The most characters that a command gives one group.
std::size_t charactersIn(const CommandBody& body) {
    if (const auto* join = std::get_if<AddCharacters>(&body)) return join->positions.size();
    if (const auto* group = std::get_if<AddGroup>(&body)) return static_cast<std::size_t>(group->group.count);
    if (const auto* set = std::get_if<SetCount>(&body)) return static_cast<std::size_t>(set->count);
    return 0;
}

Result<std::vector<CommandBody>> parse(std::string_view text, const SessionLimits& limits,
                                       bool (*allowed)(const CommandBody&), const char* expected) {
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
                          where + "found a command of another kind, expected " + expected);
        const auto most = static_cast<std::size_t>(limits.charactersPerGroup);
        if (const std::size_t found = charactersIn(command.body); found > most)
            return beyondLimit("characters", found, most);
        bodies.push_back(std::move(command.body));
    }
    return bodies;
}

}  // namespace

Result<std::vector<CommandBody>> parseCommandText(std::string_view text, const SessionLimits& limits) {
    return parse(text, limits, directs, "an order or a change of units");
}

Result<std::vector<CommandBody>> parseEditText(std::string_view text, const SessionLimits& limits) {
    return parse(text, limits, editsPlace, "a change of the place");
}

}  // namespace muster
