#include "muster/command.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/state/command_archive.h"
#include "engine/state/validation.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

constexpr std::size_t kMaxTouches = 64;    // Of one control.
constexpr std::int32_t kAnyMotion = 1000;  // Whether the world knows the motion shows when it is applied.

constexpr auto kNames = std::to_array<const char*>({"TouchDown",        "TouchMove",
                                                    "TouchUp",          "TouchCancel",
                                                    "AddControl",       "PinControl",
                                                    "RemoveControl",    "ReleaseClient",
                                                    "SetFormation",     "SetCount",
                                                    "SetPose",          "AddGroup",
                                                    "RemoveGroup",      "AddObstacle",
                                                    "ChangeObstacle",   "RemoveObstacle",
                                                    "AddPatch",         "ChangePatch",
                                                    "RemovePatch",      "SetParameter",
                                                    "GiveOrder",        "EditQueue",
                                                    "SetConduct",       "AddCharacters",
                                                    "RemoveCharacters", "TransferCharacters",
                                                    "SplitGroup",       "MergeGroups",
                                                    "SetBodies",        "SetRoles",
                                                    "SetDemands",       "SetDriver",
                                                    "WriteMotion",      "AddItem",
                                                    "ChangeItem",       "RemoveItem",
                                                    "AddCheckpoint",    "ChangeCheckpoint",
                                                    "RemoveCheckpoint", "PlaceGroup",
                                                    "NameGroup",        "ColourGroup",
                                                    "SetAppearance",    "PutArea",
                                                    "RemoveArea",       "SetPeople"});
static_assert(kNames.size() == std::variant_size_v<CommandKinds>);

/// Makes the alternative with that index; false where there is none.
template <std::size_t Index = 0>
bool emplaceBody(CommandBody& body, std::size_t index) {
    if constexpr (Index < std::variant_size_v<CommandKinds>) {
        if (index != Index) return emplaceBody<Index + 1>(body, index);
        body.emplace<Index>();
        return true;
    } else {
        return false;
    }
}

Status place(Vec2 p) {
    if (std::fabs(p.x) <= kMaxCoordinate && std::fabs(p.y) <= kMaxCoordinate) return {};
    return invalidArgument("position is not finite or farther than 1e6 m from the origin");
}

Status moment(double time) {
    if (time >= 0.0 && time <= 1e9) return {};
    return invalidArgument("time is not in [0, 1e9] s");
}

Status both(const Status& a, const Status& b) {
    return a.ok() ? b : a;
}

/// One check per kind of command.
struct Validator {
    Status operator()(const TouchDown& c) const { return both(place(c.position), moment(c.time)); }
    Status operator()(const TouchMove& c) const { return both(place(c.position), moment(c.time)); }
    Status operator()(const TouchUp& c) const { return moment(c.time); }
    Status operator()(const TouchCancel&) const { return {}; }
    Status operator()(const AddControl& c) const {
        const std::size_t n = c.positions.size();
        if (c.kind > ControlKind::Area) return invalidArgument("control kind is not known");
        if (c.touches.size() != n) return invalidArgument("touches and positions differ in number");
        if (n == 0 || n > kMaxTouches) return invalidArgument("a control has 1 to 64 points");
        if (std::min<std::size_t>(n, 3) != static_cast<std::size_t>(c.kind) + 1) {
            return invalidArgument("the number of points does not suit the kind of control");
        }
        for (Vec2 p : c.positions) {
            if (Status s = place(p); !s.ok()) return s;
        }
        return moment(c.time);
    }
    Status operator()(const PinControl&) const { return {}; }
    Status operator()(const RemoveControl&) const { return {}; }
    Status operator()(const ReleaseClient&) const { return {}; }
    Status operator()(const SetFormation& c) const { return validateFormation(c.formation); }
    Status operator()(const SetCount& c) const {
        if (c.count >= 1 && c.count <= kMaxCharacters) return {};
        return invalidArgument("count is " + std::to_string(c.count) + ", expected 1 to " +
                               std::to_string(kMaxCharacters));
    }
    Status operator()(const SetPose& c) const {
        return std::fabs(c.angle) <= 1e6 ? place(c.position)
                                         : invalidArgument("angle is not in [-1e6, 1e6] rad");
    }
    Status operator()(const AddGroup& c) const { return validateGroup(c.group); }
    Status operator()(const RemoveGroup&) const { return {}; }
    Status operator()(const AddObstacle& c) const { return validateObstacle(c.obstacle); }
    Status operator()(const ChangeObstacle& c) const { return validateObstacle(c.obstacle); }
    Status operator()(const RemoveObstacle&) const { return {}; }
    Status operator()(const AddPatch& c) const { return validatePatch(c.patch, kAnyMotion); }
    Status operator()(const ChangePatch& c) const { return validatePatch(c.patch, kAnyMotion); }
    Status operator()(const RemovePatch&) const { return {}; }
    Status operator()(const SetParameter& c) const {
        if (c.name == "time.step") return invalidArgument("time.step cannot change while a world runs");
        Parameters scratch;
        return setParameter(scratch, c.name, c.value);
    }
    Status operator()(const GiveOrder& c) const {
        if (c.mode > QueueMode::Insert) return invalidArgument("queue mode is not known");
        return validateOrder(c.order);
    }
    Status operator()(const EditQueue& c) const {
        return c.edit <= QueueEdit::Stop ? Status{} : invalidArgument("queue edit is not known");
    }
    Status operator()(const SetConduct& c) const { return validateConduct(c.conduct); }
    Status operator()(const AddCharacters& c) const {
        if (c.positions.empty()) return invalidArgument("positions are empty, expected at least one");
        if (Status s = places("positions", c.positions); !s.ok()) return s;
        return validateBodies(c.bodies, c.positions.size(), true);
    }
    Status operator()(const RemoveCharacters& c) const { return ids(c.ids); }
    Status operator()(const TransferCharacters& c) const { return ids(c.ids); }
    Status operator()(const SplitGroup& c) const { return validateSplit(c); }
    Status operator()(const MergeGroups& c) const {
        if (c.groups.size() < 2 || c.groups.size() > kMaxGroups)
            return invalidArgument("found " + std::to_string(c.groups.size()) +
                                   " groups, expected 2 or more");
        std::vector<GroupId> sorted = c.groups;
        std::sort(sorted.begin(), sorted.end());
        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
            return invalidArgument("a group is named twice");
        return c.shape <= PartShape::Smaller ? Status{} : invalidArgument("shape of parts is not known");
    }
    Status operator()(const SetBodies& c) const {
        return both(ids(c.ids), validateBodies(c.bodies, c.ids.size(), false));
    }
    Status operator()(const SetRoles& c) const { return validateRoles(c.roles); }
    Status operator()(const SetDemands& c) const { return validateDemands(c.demands); }
    Status operator()(const SetDriver& c) const {
        return both(ids(c.ids),
                    c.driver <= Driver::Outside ? Status{} : invalidArgument("driver is not known"));
    }
    Status operator()(const WriteMotion& c) const {
        if (c.positions.size() != c.ids.size() ||
            (!c.velocities.empty() && c.velocities.size() != c.ids.size()))
            return invalidArgument("ids, positions and velocities differ in number");
        if (Status s = ids(c.ids); !s.ok()) return s;
        if (Status s = places("velocities", c.velocities); !s.ok()) return s;
        return places("positions", c.positions);
    }
    Status operator()(const AddItem& c) const { return validateItem(c.item); }
    Status operator()(const ChangeItem& c) const { return validateItem(c.item); }
    Status operator()(const RemoveItem&) const { return {}; }
    Status operator()(const AddCheckpoint& c) const { return validateCheckpoint(c.checkpoint, kMaxGroups); }
    Status operator()(const ChangeCheckpoint& c) const {
        return validateCheckpoint(c.checkpoint, kMaxGroups);
    }
    Status operator()(const RemoveCheckpoint&) const { return {}; }
    Status operator()(const PlaceGroup& c) const {
        return std::fabs(c.angle) <= 1e6 ? place(c.position)
                                         : invalidArgument("angle is not in [-1e6, 1e6] rad");
    }
    Status operator()(const NameGroup& c) const { return validateName(c.name); }
    Status operator()(const ColourGroup& c) const { return validateColour(c.colour); }
    Status operator()(const PutArea& c) const { return validateArea(c.area); }
    Status operator()(const RemoveArea&) const { return {}; }
    Status operator()(const SetPeople& c) const { return validatePeople(c.people); }
    Status operator()(const SetAppearance& c) const { return validateAppearance(c.build, c.motions); }

private:
    static Status places(const char* what, const std::vector<Vec2>& points) {
        if (points.size() > static_cast<std::size_t>(kMaxCharacters))
            return {StatusCode::LimitExceeded,
                    std::string(what) + " are more than " + std::to_string(kMaxCharacters)};
        for (const Vec2 p : points)
            if (Status s = place(p); !s.ok()) return s.within(what);
        return {};
    }
    // Ids of characters, each once.
    static Status ids(const std::vector<std::uint32_t>& list) {
        if (list.empty() || list.size() > static_cast<std::size_t>(kMaxCharacters))
            return invalidArgument("found " + std::to_string(list.size()) + " ids, expected 1 to " +
                                   std::to_string(kMaxCharacters));
        std::vector<std::uint32_t> sorted = list;
        std::sort(sorted.begin(), sorted.end());
        const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
        if (twice != sorted.end()) return invalidArgument("id " + std::to_string(*twice) + " is named twice");
        return {};
    }
    static Status validateSplit(const SplitGroup& c) {
        if (c.by > SplitBy::Shares) return invalidArgument("way of splitting is not known");
        if (c.shape > PartShape::Smaller) return invalidArgument("shape of parts is not known");
        if (c.by == SplitBy::Ids) return ids(c.ids);
        if (c.by == SplitBy::Line && (c.points.size() != 2 || c.points[0] == c.points[1]))
            return invalidArgument("a line needs two different points");
        if (c.by == SplitBy::Lasso && (c.points.size() < 3 || c.points.size() > kMaxCorners))
            return invalidArgument("a lasso needs 3 to " + std::to_string(kMaxCorners) + " corners");
        if (c.by == SplitBy::Shares) {
            if (c.shares.size() < 2 || c.shares.size() > kMaxGroups)
                return invalidArgument("found " + std::to_string(c.shares.size()) +
                                       " shares, expected 2 or more");
            for (const double share : c.shares)
                if (!(share > 0.0 && share <= 1e6)) return invalidArgument("a share is not in (0, 1e6]");
        }
        return places("points", c.points);
    }
};

}  // namespace

void encodeCommand(Writer& writer, const Command& command) {
    const auto kind = static_cast<std::uint8_t>(command.body.index());
    writer(command.step, command.client, command.sequence, kind);
    std::visit([&](const auto& body) { writer(body); }, command.body);
}

Result<Command> decodeCommand(Reader& reader) {
    Command command;
    std::uint8_t kind = 0;
    reader(command.step, command.client, command.sequence, kind);
    if (!reader.ok()) return Status(StatusCode::ParseError, "command is cut short");
    if (!emplaceBody(command.body, kind)) {
        return Status(StatusCode::ParseError, "command kind " + std::to_string(kind) + " is not known");
    }
    std::visit([&](auto& body) { reader(body); }, command.body);
    if (!reader.ok()) {
        return Status(StatusCode::ParseError, std::string(commandName(command)) + " command is cut short");
    }
    const Status valid = validateCommand(command);
    if (!valid.ok()) return Status(StatusCode::ParseError, valid.message());
    return command;
}

CommandBody::CommandBody(const CommandBody& other) = default;
CommandBody::CommandBody(CommandBody&& other) noexcept = default;
CommandBody& CommandBody::operator=(const CommandBody& other) = default;
CommandBody& CommandBody::operator=(CommandBody&& other) noexcept = default;
CommandBody::~CommandBody() = default;

std::vector<std::uint8_t> encodeCommand(const Command& command) {
    Writer writer;
    encodeCommand(writer, command);
    return writer.take();
}

Result<Command> decodeCommand(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    Result<Command> command = decodeCommand(reader);
    if (command.ok() && reader.remaining() > 0)
        return Status(StatusCode::ParseError, "command is followed by other bytes");
    return command;
}

const char* commandName(const Command& command) {
    return kNames[command.body.index()];
}

Status validateCommand(const Command& command) {
    return std::visit(Validator(), command.body).within(commandName(command));
}

}  // namespace muster
