#include "studio/session/inbox/received_commands.h"

#include <cmath>
#include <string>
#include <utility>

#include "engine/state/command_archive.h"
#include "engine/state/command_checks.h"
#include "studio/session/inbox/generated/command_traits.h"

namespace muster {
namespace {

/// A kind of message with commands.
struct CommandUse {
    bool CommandTraits::*allows;  // What is true of the commands that it may have.
    const char* expected;         // The same for people.
};

constexpr CommandUse kDirectionUse{&CommandTraits::directs, "an order or a change of units"};
constexpr CommandUse kEditUse{&CommandTraits::edits, "a change of the place"};

Status beyondLimit(const char* what, std::size_t found, std::size_t most) {
    return {StatusCode::LimitExceeded,
            "found " + std::to_string(found) + " " + what + ", expected at most " + std::to_string(most)};
}

/// The most characters that a command gives one group.
std::size_t charactersIn(const CommandBody& body) {
    if (const auto* join = std::get_if<AddCharacters>(&body)) return join->positions.size();
    if (const auto* group = std::get_if<AddGroup>(&body)) return static_cast<std::size_t>(group->group.count);
    if (const auto* change = std::get_if<ChangeGroup>(&body))
        return static_cast<std::size_t>(change->count.value_or(0));
    return 0;
}

Status check(CommandBody& body, const SessionLimits& limits, const CommandUse& use, const StampTime& stamp) {
    if (!(traitsOf(body).*use.allows))
        return {StatusCode::InvalidArgument,
                std::string("found a command of another kind, expected ") + use.expected};
    if (auto* add = std::get_if<AddControl>(&body)) {
        if (!std::isfinite(add->time)) return {StatusCode::InvalidArgument, "a time that is not finite"};
        if (add->touches.size() > limits.pointsPerControl)
            return beyondLimit("points", add->touches.size(), limits.pointsPerControl);
        add->time = stamp(add->time);
    }
    if (Status valid = validateCommand({0, 0, 0, body}); !valid.ok()) return valid;
    const auto most = static_cast<std::size_t>(limits.charactersPerGroup);
    const std::size_t found = charactersIn(body);
    return found > most ? beyondLimit("characters", found, most) : Status();
}

Result<std::vector<CommandBody>> read(std::span<const std::uint8_t> bytes, const SessionLimits& limits,
                                      const CommandUse& use, const StampTime& stamp) {
    if (bytes.size() > limits.commandBytes)
        return beyondLimit("bytes of commands", bytes.size(), limits.commandBytes);
    Reader reader(bytes);
    std::vector<CommandBody> bodies;
    while (reader.remaining() > 0) {
        if (bodies.size() == limits.commandsPerMessage)
            return Status(StatusCode::LimitExceeded,
                          "found more than " + std::to_string(limits.commandsPerMessage) + " commands");
        const std::string where = "commands[" + std::to_string(bodies.size()) + "]";
        auto body = decodeBody(reader);
        if (!body.ok()) return body.status().within(where);
        if (Status good = check(body.value(), limits, use, stamp); !good.ok()) return good.within(where);
        bodies.push_back(std::move(body).value());
    }
    return bodies;
}

}  // namespace

Result<std::vector<CommandBody>> readDirections(std::span<const std::uint8_t> bytes,
                                                const SessionLimits& limits, const StampTime& stamp) {
    return read(bytes, limits, kDirectionUse, stamp);
}

Result<std::vector<CommandBody>> readEdits(std::span<const std::uint8_t> bytes, const SessionLimits& limits) {
    return read(bytes, limits, kEditUse, [](double time) { return time; });
}

}  // namespace muster
