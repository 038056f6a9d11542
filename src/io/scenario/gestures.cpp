#include "muster/scenario.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "base/text_file.h"
#include "io/scenario/describe.h"

namespace muster {
namespace {

constexpr const char* kGesturesFormat = "muster-gestures";
constexpr std::size_t kMaxEvents = 1000000;
constexpr NumberRange kNumber{0.0, 4294967295.0};
constexpr const char* kKinds[] = {
    "down",           "move",           "up",    "cancel",      "control",     "pin",         "remove",
    "release",        "formation",      "count", "pose",        "group",       "removeGroup", "obstacle",
    "changeObstacle", "removeObstacle", "patch", "changePatch", "removePatch", "parameter",
    "order", "queue", "conduct", "join", "leave", "transfer", "split", "merge", "bodies", "roles", "demands",
    "driver", "motion"};
static_assert(std::size(kKinds) == std::variant_size_v<CommandBody>);

/// An event of the file: a command with its time.
struct Event {
    double time = 0.0;  ///< `t` [s].
    Command command;
};

/// The fields of each kind of command, except t, kind and client.
template <class Visitor>
struct BodyFields {
    Visitor& v;
    double& time;

    void finger(std::uint32_t& touch) { v.whole("touch", touch, kNumber, "Finger.", Need::Required); }
    void spot(Vec2& p) {
        v.number("x", p.x, {-1e6, 1e6, "m"}, "World coordinate.", Need::Required);
        v.number("y", p.y, {-1e6, 1e6, "m"}, "World coordinate.", Need::Required);
    }
    template <class Tag>
    void id(const char* key, Id<Tag>& value) {
        v.whole(key, value.value, kNumber, "Id.", Need::Required);
    }
    void operator()(TouchDown& c) {
        finger(c.touch);
        spot(c.position);
        if (Visitor::kReading || c.group)
            v.whole("group", c.group.value, kNumber, "Group; left out: the nearest mesh.");
        c.time = time;
    }
    void operator()(TouchMove& c) {
        finger(c.touch);
        spot(c.position);
        c.time = time;
    }
    void operator()(TouchUp& c) {
        finger(c.touch);
        c.time = time;
    }
    void operator()(TouchCancel& c) { finger(c.touch); }
    void operator()(AddControl& c) {
        static const std::vector<std::string> names{"point", "line", "area"};
        std::string control = names[static_cast<std::size_t>(c.kind)];
        id("group", c.group);
        v.choice("control", control, names, "Kind of control.", Need::Required);
        c.kind = static_cast<ControlKind>(std::find(names.begin(), names.end(), control) - names.begin());
        std::vector<std::pair<std::uint32_t, Vec2>> points;
        for (std::size_t i = 0; i < c.positions.size(); ++i)
            points.emplace_back(c.touches[i], c.positions[i]);
        v.list(
            "points", points, 64, "Its fingers.",
            [](auto& item, std::pair<std::uint32_t, Vec2>& point) {
                BodyFields<std::remove_reference_t<decltype(item)>> inner{item, point.second.x};
                inner.finger(point.first);
                inner.spot(point.second);
            },
            Need::Required);
        c.touches.clear();
        c.positions.clear();
        for (const auto& [touch, position] : points) {
            c.touches.push_back(touch);
            c.positions.push_back(position);
        }
        c.time = time;
    }
    void operator()(PinControl& c) {
        id("group", c.group);
        id("control", c.control);
        v.flag("pinned", c.pinned, "False lets it go.");
    }
    void operator()(RemoveControl& c) {
        id("group", c.group);
        id("control", c.control);
    }
    void operator()(ReleaseClient&) {}
    void operator()(SetFormation& c) {
        id("group", c.group);
        v.objectOrKind(
            "formation", "", [&](auto& inner) { describeFormation(inner, c.formation); }, Need::Required);
    }
    void operator()(SetCount& c) {
        id("group", c.group);
        v.whole("count", c.count, {1.0, kMaxCharacters}, "Characters.", Need::Required);
    }
    void operator()(SetPose& c) {
        id("group", c.group);
        spot(c.position);
        v.number("angle", c.angle, kAngle, "Where it faces.");
    }
    void operator()(AddGroup& c) {
        v.object(
            "definition", "", [&](auto& inner) { describeGroup(inner, c.group); }, Need::Required);
    }
    void operator()(RemoveGroup& c) { id("group", c.group); }
    void operator()(AddObstacle& c) { obstacle(c.obstacle); }
    void operator()(ChangeObstacle& c) {
        id("id", c.id);
        obstacle(c.obstacle);
    }
    void operator()(RemoveObstacle& c) { id("id", c.id); }
    void operator()(AddPatch& c) { patch(c.patch); }
    void operator()(ChangePatch& c) {
        id("id", c.id);
        patch(c.patch);
    }
    void operator()(RemovePatch& c) { id("id", c.id); }
    void operator()(SetParameter& c) {
        v.text("name", c.name, "Parameter.", Need::Required);
        v.number("value", c.value, {-1e9, 1e9}, "Its new value.", Need::Required);
    }
    template <class Other>
    void operator()(Other&) {}
    void obstacle(ObstacleDef& def) {
        v.object(
            "definition", "", [&](auto& inner) { describeObstacle(inner, def); }, Need::Required);
    }
    void patch(PatchDef& def) {
        v.object(
            "definition", "", [&](auto& inner) { describePatch(inner, def, {}); }, Need::Required);
    }
};

/// Makes the variant's alternative of that index.
template <std::size_t Index = 0>
void emplaceBody(CommandBody& body, std::size_t index) {
    if constexpr (Index < std::variant_size_v<CommandBody>) {
        if (index == Index) {
            body.emplace<Index>();
        } else {
            emplaceBody<Index + 1>(body, index);
        }
    }
}

std::uint32_t stepAt(double time, double stepTime) {
    return static_cast<std::uint32_t>(std::min(4e9, std::floor(time / stepTime + 1e-9)));
}

/// One event. The step is written only where the time does not determine it.
template <class Visitor>
void describeEvent(Visitor& v, Event& event, double stepTime) {
    static const std::vector<std::string> kinds(std::begin(kKinds), std::end(kKinds));
    Command& command = event.command;
    v.number("t", event.time, kTime, "When.", Need::Required);
    std::string kind = kinds[command.body.index()];
    v.choice("kind", kind, kinds, "What.", Need::Required);
    if constexpr (Visitor::kReading) command.client = 1;
    if (Visitor::kReading || command.client != 1) v.whole("client", command.client, kNumber, "Who.");
    if constexpr (Visitor::kReading) {
        if (v.failed()) return;
        const auto index = std::find(kinds.begin(), kinds.end(), kind) - kinds.begin();
        emplaceBody(command.body, static_cast<std::size_t>(index));
        command.step = stepAt(event.time, stepTime);
    }
    if (Visitor::kReading || command.step != stepAt(event.time, stepTime)) {
        v.whole("step", command.step, kNumber, "Step at which it applies; left out: by its time.");
    }
    BodyFields<Visitor> fields{v, event.time};
    std::visit(fields, command.body);
}

template <class Visitor>
void describeFile(Visitor& v, std::vector<Event>& events, double stepTime) {
    std::string format = kGesturesFormat;
    std::int32_t version = 1;
    v.choice("format", format, {kGesturesFormat}, "What this file is.", Need::Required);
    v.whole("version", version, {1.0, 1.0}, "Of the format.", Need::Required);
    v.list(
        "events", events, kMaxEvents, "Those of one step and client apply in this order.",
        [&](auto& item, Event& event) { describeEvent(item, event, stepTime); }, Need::Required);
}

/// The time stamp of a command that has one; otherwise the start of its step.
double timeOf(const Command& command, double stepTime) {
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
    for (std::size_t i = 0; i < events.size(); ++i) {
        Command& command = events[i].command;
        command.sequence = static_cast<std::uint32_t>(i);
        if (const Status valid = validateCommand(command); !valid.ok()) {
            return valid.within(sourceName + ": $.events[" + std::to_string(i) + "]");
        }
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

std::string writeGestures(std::span<const Command> commands, double stepTime) {
    std::vector<Event> events;
    for (const Command& command : commands) events.push_back({timeOf(command, stepTime), command});
    Json json;
    FieldWriter writer(json);
    describeFile(writer, events, stepTime);
    return printJson(json);
}

Status saveGestures(std::span<const Command> commands, double stepTime, const std::string& path) {
    return writeTextFile(path, writeGestures(commands, stepTime));
}

}  // namespace muster
