#include "muster/scenario.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "base/emplace_index.h"
#include "base/text_file.h"
#include "files/scenario/generated/command_fields.h"

namespace muster {
namespace {

constexpr const char* kGesturesFormat = "muster-gestures";
constexpr std::size_t kMaxEvents = 1000000;
constexpr const char* kLeave = "leave";

/// An event of the file: a command with its time.
struct Event {
    double time = 0.0;  ///< `t` [s].
    Command command;
};

/// What files call a command.
std::string kindOf(const CommandBody& body) {
    const auto* give = std::get_if<GiveOrder>(&body);
    return give != nullptr ? kOrderKindWords[static_cast<std::size_t>(give->order.kind)]
                           : kCommandWords[body.index()];
}

/// Index of a word in a list of them; none where it is not there.
template <class Words>
std::optional<std::size_t> indexOfWord(const Words& words, const std::string& word) {
    const auto at = std::find(words.begin(), words.end(), word);
    if (at == words.end()) return std::nullopt;
    return static_cast<std::size_t>(at - words.begin());
}

std::uint32_t stepAt(double time, double stepTime) {
    return static_cast<std::uint32_t>(std::min(4e9, std::floor(time / stepTime + 1e-9)));
}

/// The former command that a kind stands for; none for others. Fingers moved and characters left, and groups
/// are ordered to.
std::optional<std::size_t> formerKind(FieldReader& v, const std::string& kind) {
    const bool moves = kind == kOrderKindWords.front();
    if (moves && !v.has("touch") && !v.has("group"))
        v.fail({}, "neither \"touch\" nor \"group\"", "a finger or a group to move");
    const bool isOrder = (moves && !v.has("touch")) || (kind == kLeave && !v.has("ids"));
    return isOrder ? std::nullopt : indexOfWord(kFormerWords, kind);
}

/// Makes the command that a kind stands for.
void makeBody(CommandBody& body, const std::string& kind) {
    if (const auto order = indexOfWord(kOrderKindWords, kind))
        body.emplace<GiveOrder>().order.kind = static_cast<OrderKind>(*order);
    else
        emplaceIndex<CommandKinds>(body, *indexOfWord(kCommandWords, kind));
}

/// Reads the fields of a command by a name that it had, as the command that says the same.
CommandBody readFormer(FieldReader& v, std::size_t index, double& time) {
    FormerKinds kind;
    emplaceIndex(kind, index);
    BodyFields<FieldReader> fields{v, time};
    std::visit(fields, kind);
    return std::visit([](const auto& old) { return converted(old); }, kind);
}

/// All words for kinds.
std::vector<std::string> allKinds() {
    std::vector<std::string> kinds;
    for (std::size_t index = 0; index < kCommandWords.size(); ++index)
        if (index != CommandBody(GiveOrder{}).index()) kinds.emplace_back(kCommandWords[index]);
    for (const char* const kind : kFormerWords) kinds.emplace_back(kind);
    for (const std::string kind : kOrderKindWords)  // Fingers move, too, and characters left.
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
    return kinds;
}

/// One event. The step is written only where the time does not determine it.
template <class Visitor>
void describeEvent(Visitor& v, Event& event, double stepTime, Need timed) {
    static const std::vector<std::string> kinds = allKinds();
    Command& command = event.command;
    v.number("t", event.time, kTime, "When.", timed);
    std::string kind = kindOf(command.body);
    v.choice("kind", kind, Visitor::kSchema ? std::vector{kind} : kinds, "What.", Need::Required);
    if constexpr (Visitor::kReading) command.client = 1;
    if (takesPart<Visitor>(command.client != 1)) v.whole("client", command.client, kId, "Who.");
    if constexpr (Visitor::kReading) {
        if (v.failed()) return;
        command.step = stepAt(event.time, stepTime);
    }
    if (takesPart<Visitor>(command.step != stepAt(event.time, stepTime)))
        v.whole("step", command.step, kId, "Step at which it applies; left out: by its time.");
    if constexpr (Visitor::kReading) {
        if (const auto index = formerKind(v, kind)) {
            command.body = readFormer(v, *index, event.time);
            return;
        }
        if (v.failed()) return;
        makeBody(command.body, kind);
    }
    BodyFields<Visitor> fields{v, event.time};
    std::visit(fields, command.body);
}

/// The schema of an event: that of one kind of command.
Json eventSchema() {
    Json kinds = Json::array();
    const auto add = [&](Event event) {
        event.command.client = 1;
        FieldSchema schema(kinds.push({}));
        describeEvent(schema, event, 1.0, Need::Required);
    };
    for (std::size_t index = 0; index < kCommandWords.size(); ++index) {
        Event event;
        emplaceIndex<CommandKinds>(event.command.body, index);
        auto* const give = std::get_if<GiveOrder>(&event.command.body);
        for (std::size_t order = 0; order < (give != nullptr ? kOrderKindWords.size() : 1); ++order) {
            if (give != nullptr) give->order.kind = static_cast<OrderKind>(order);
            add(event);
        }
    }
    return {{"anyOf", std::move(kinds)}};
}

template <class Visitor>
void describeFile(Visitor& v, std::vector<Event>& events, double stepTime) {
    std::string format = kGesturesFormat;
    std::int32_t version = 1;
    v.choice("format", format, {kGesturesFormat}, "What this file is.", Need::Required);
    v.whole("version", version, {1.0, 1.0}, "Of the format.", Need::Required);
    if constexpr (Visitor::kReading || Visitor::kSchema) {
        std::string schema;
        v.text("$schema", schema, "Where editors find this schema.");
    }
    const char* const about = "Those of one step and client apply in this order.";
    if constexpr (Visitor::kSchema) {
        v.set("events", {{"type", "array"}, {"maxItems", kMaxEvents}, {"items", eventSchema()}}, about,
              Need::Required);
    } else {
        v.list(
            "events", events, kMaxEvents, about,
            [&](auto& item, Event& event) { describeEvent(item, event, stepTime, Need::Required); },
            Need::Required);
    }
}

/// The time stamp of a command that has one; otherwise the start of its step.
double timeOf(const Command& command, double stepTime) {
    if (touchOf(command.body, TouchPhase::Cancel) != nullptr) return command.step * stepTime;
    return std::visit(
        [&](const auto& body) {
            if constexpr (requires { body.time; }) {
                return body.time;
            } else {
                return command.step * stepTime;
            }
        },
        command.body);
}

/// The commands of events, in the order in which they apply. `path` leads to the events.
Result<std::vector<Command>> numbered(std::vector<Event> events, const std::string& path) {
    for (std::size_t i = 0; i < events.size(); ++i) {
        Command& command = events[i].command;
        command.sequence = static_cast<std::uint32_t>(i);
        if (const Status valid = validateCommand(command); !valid.ok())
            return valid.within(path + "[" + std::to_string(i) + "]");
    }
    std::stable_sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
        return std::tuple(a.command.step, a.command.client) < std::tuple(b.command.step, b.command.client);
    });
    std::vector<Command> commands;
    std::map<std::uint32_t, std::uint32_t> next;  // The next sequence number of each client.
    for (Event& event : events) {
        event.command.sequence = next[event.command.client]++;
        commands.push_back(std::move(event.command));
    }
    return commands;
}

}  // namespace

Result<std::vector<Command>> loadGestures(const std::string& path, double stepTime) {
    const auto text = readTextFile(path);
    if (!text.ok()) return text.status();
    return parseGestures(*text, path, stepTime);
}

Result<std::vector<Command>> parseGestures(std::string_view text, const std::string& sourceName,
                                           double stepTime) {
    const auto json = parseJson(text, sourceName);
    if (!json.ok()) return json.status();
    std::vector<Event> events;
    std::string failure;
    FieldReader reader(*json, "$", failure);
    if (failure.empty()) describeFile(reader, events, stepTime);
    reader.finish();
    if (!failure.empty()) return Status(StatusCode::ParseError, sourceName + ": " + failure);
    return numbered(std::move(events), sourceName + ": $.events");
}

Result<std::vector<Command>> parseCommands(std::string_view text, const std::string& sourceName,
                                           double stepTime) {
    auto json = parseJson(text, sourceName);
    if (!json.ok()) return json.status();
    if (json->isObject()) json = Json::array({std::move(json).value()});
    if (!json->isArray() || json->size() > kMaxEvents) {
        return Status(StatusCode::ParseError, sourceName + ": $: found " + describeJson(*json) +
                                                  ", expected an event or an array of at most " +
                                                  std::to_string(kMaxEvents));
    }
    std::vector<Event> events(json->size());
    std::string failure;
    for (std::size_t i = 0; i < events.size() && failure.empty(); ++i) {
        FieldReader reader((*json)[i], "$[" + std::to_string(i) + "]", failure);
        if (failure.empty()) describeEvent(reader, events[i], stepTime, Need::Optional);
        reader.finish();
    }
    if (!failure.empty()) return Status(StatusCode::ParseError, sourceName + ": " + failure);
    return numbered(std::move(events), sourceName + ": $");
}

std::string writeGestures(std::span<const Command> commands, double stepTime) {
    std::vector<Event> events;
    for (const Command& command : commands) events.push_back({timeOf(command, stepTime), command});
    Json json;
    FieldWriter writer(json);
    describeFile(writer, events, stepTime);
    return printJson(json);
}

std::string gesturesSchema() {
    Json body;
    FieldSchema schema(body);
    std::vector<Event> events;
    describeFile(schema, events, 1.0);
    return titledSchema("Muster gestures", body);
}

Status saveGestures(std::span<const Command> commands, double stepTime, const std::string& path) {
    return writeTextFile(path, writeGestures(commands, stepTime));
}

}  // namespace muster
