#include "studio/session/history/definition.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/maths.h"
#include "muster/parameter_table.h"
#include "studio/session/history/group_fields.h"
#include "studio/session/inbox/received_commands.h"

namespace muster {
namespace {

constexpr double kSamePlace = 0.01;  // Between poses that count as one, also of unit vectors [m].
constexpr double kRounding = 1e-9;

template <class Kind>
std::size_t indexOfKind() {
    static const std::size_t index = CommandBody(Kind{}).index();
    return index;
}

template <class Kind>
PartKey keyFor(SubjectKind kind, std::uint32_t name) {
    return {{kind, name}, indexOfKind<Kind>(), 0};
}

std::uint32_t parameterIndex(std::string_view name) {
    const auto all = parameterTable();
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const ParameterInfo& info) { return info.name == name; });
    return static_cast<std::uint32_t>(at - all.begin()) + 1;
}

/// One function for each kind of command that sets a property.
struct Key {
    Names& names;

    template <class Kind, class AnyId>
    PartKey of(SubjectKind kind, AnyId id) const {
        return keyFor<Kind>(kind, names.nameOf(kind, id.value));
    }
    PartKey operator()(const PutThing& c) const { return ofThing(thingOf(c), c.id); }
    PartKey operator()(const RemoveThing& c) const { return ofThing(c.thing, c.id); }
    PartKey operator()(const AddGroup&) const { return keyFor<AddGroup>(SubjectKind::Group, 0); }
    PartKey operator()(const RemoveGroup& c) const { return of<AddGroup>(SubjectKind::Group, c.group); }
    PartKey operator()(const SetParameter& c) const {
        return keyFor<SetParameter>(SubjectKind::Parameter, parameterIndex(c.name));
    }
    PartKey operator()(const EditControl& c) const {
        PartKey key = of<EditControl>(SubjectKind::Group, c.group);
        key.part = c.control.value;
        return key;
    }
    PartKey operator()(const ChangeGroup& c) const {
        PartKey key = of<ChangeGroup>(SubjectKind::Group, c.group);
        key.part = static_cast<std::uint32_t>(firstField(c));
        return key;
    }
    PartKey operator()(const SetPose& c) const {
        PartKey key = of<SetPose>(SubjectKind::Group, c.group);
        key.part = c.characters ? 1 : 0;
        return key;
    }
    template <class Other>
    PartKey operator()(const Other& c) const {
        if constexpr (requires { c.group.value; }) return of<Other>(SubjectKind::Group, c.group);
        return {};
    }

private:
    PartKey ofThing(std::optional<ThingKind> thing, std::uint32_t id) const {
        if (!thing) return {};
        return keyFor<PutThing>(subjectOf(*thing), names.nameOf(subjectOf(*thing), id));
    }
};

bool samePose(const SetPose& a, const SetPose& b) {
    const double most = a.characters ? kRounding : kSamePlace;
    const Vec2 to{cosine(a.angle) - cosine(b.angle), sine(a.angle) - sine(b.angle)};
    return distance(a.position, b.position) < most && length(to) < most;
}

bool byName(const MemberChange& a, const MemberChange& b) {
    return a.character < b.character;
}

/// True where the property is another one, and the thing was there before and after.
bool changes(const PartChange& part) {
    return part.before && part.after;
}

}  // namespace

bool setsPart(const CommandBody& body) {
    if (changesField(body, &ChangeGroup::count)) return false;  // It follows from who comes and leaves.
    return isOneOf<PutThing, RemoveThing, AddGroup, RemoveGroup, ChangeGroup, SetPose, EditControl,
                   SetParameter>(body);
}

PartKey keyOf(const CommandBody& body, Names& names, bool start) {
    PartKey key = std::visit(Key{names}, body);
    if (start) key.subject.kind = SubjectKind::Start;
    return key;
}

bool isMeshPose(const CommandBody& body) {
    const auto* pose = std::get_if<SetPose>(&body);
    return pose != nullptr && !pose->characters;
}

bool isPresence(const PartKey& key) {
    return key.said == indexOfKind<AddGroup>() || key.said == indexOfKind<PutThing>();
}

std::optional<CommandBody> saidBy(const CommandBody& body, std::uint32_t id) {
    if (isOneOf<RemoveThing, RemoveGroup>(body)) return std::nullopt;
    CommandBody said = body;
    if (auto* put = std::get_if<PutThing>(&said); put != nullptr && put->id == 0) put->id = id;
    return said;
}

CommandBody adding(const CommandBody& said) {
    CommandBody add = said;
    if (auto* put = std::get_if<PutThing>(&add)) put->id = 0;
    return add;
}

CommandBody removing(const CommandBody& said, std::uint32_t id) {
    if (const auto* put = std::get_if<PutThing>(&said)) return RemoveThing{*thingOf(*put), id};
    return RemoveGroup{GroupId{id}};
}

CommandBody askedOf(const PartChange& part, const Names& names) {
    CommandBody asked = part.before ? *part.before : *part.after;
    const std::uint32_t id = names.idOf(part.key.subject.kind, part.key.subject.name);
    if (isPresence(part.key)) return removing(asked, id);
    names.toIds(asked);
    return asked;
}

bool samePart(const std::optional<CommandBody>& a, const std::optional<CommandBody>& b) {
    if (!a || !b) return !a == !b;
    if (a->index() != b->index()) return false;
    if (const auto* pose = std::get_if<SetPose>(&*a)) return samePose(*pose, std::get<SetPose>(*b));
    return std::holds_alternative<AddGroup>(*a) || sameBody(*a, *b);
}

bool Difference::empty() const {
    return members.empty() &&
           std::all_of(parts.begin(), parts.end(),
                       [](const PartChange& part) { return samePart(part.before, part.after); }) &&
           std::all_of(queues.begin(), queues.end(),
                       [](const QueueChange& queue) { return sameQueue(queue.before, queue.after); });
}

Difference reversed(Difference difference) {
    for (PartChange& part : difference.parts) std::swap(part.before, part.after);
    for (QueueChange& queue : difference.queues) std::swap(queue.before, queue.after);
    for (MemberChange& member : difference.members) std::swap(member.before, member.after);
    return difference;
}

void join(Difference& difference, Difference later) {
    const auto put = [](auto& all, auto& one, auto same) {
        const auto at = std::find_if(all.begin(), all.end(), same);
        if (at == all.end())
            all.push_back(std::move(one));
        else
            at->after = std::move(one.after), at->stays = at->stays || one.stays;
    };
    for (PartChange& part : later.parts)
        put(difference.parts, part, [&](const PartChange& one) { return one.key == part.key; });
    for (QueueChange& queue : later.queues)
        put(difference.queues, queue, [&](const QueueChange& one) { return one.group == queue.group; });
    std::vector<MemberChange>& members = difference.members;
    const auto known = static_cast<std::ptrdiff_t>(members.size());
    for (MemberChange& member : later.members) {
        const auto end = members.begin() + known;
        const auto at = std::lower_bound(members.begin(), end, member, byName);
        if (at != end && at->character == member.character)
            at->after = member.after;
        else
            members.push_back(member);
    }
    std::sort(members.begin(), members.end(), byName);
    for (Crew& crew : later.crews) difference.crews.push_back(std::move(crew));
}

void dropEqual(Difference& difference) {
    std::erase_if(difference.parts,
                  [](const PartChange& part) { return !part.stays && samePart(part.before, part.after); });
    std::erase_if(difference.queues, [](const QueueChange& queue) {
        return !queue.stays && sameQueue(queue.before, queue.after);
    });
    std::erase_if(difference.members, [](const MemberChange& member) {
        return member.before.group == member.after.group && member.before.body == member.after.body;
    });
}

void takeOut(Difference& difference, Difference& later) {
    for (PartChange& part : difference.parts) {
        const auto at = std::find_if(later.parts.begin(), later.parts.end(),
                                     [&](const PartChange& one) { return one.key == part.key; });
        if (at == later.parts.end() || !changes(part)) continue;
        if (samePart(at->before, part.after)) at->before = part.before;
        part.passed = true;
    }
    for (const QueueChange& queue : difference.queues)
        for (QueueChange& one : later.queues) {
            if (one.group != queue.group) continue;
            one.before = merged(one.before, queue.after, queue.before);
            one.after = merged(one.after, queue.after, queue.before);
        }
    for (MemberChange& member : difference.members) {
        const std::uint32_t from = member.before.group, to = member.after.group;
        const auto at = std::lower_bound(later.members.begin(), later.members.end(), member, byName);
        if (at == later.members.end() || at->character != member.character) continue;
        if (from == 0 || to == 0 || from == to || at->before.group != to || at->after.group == to) continue;
        at->before.group = from;
        member.passed = true;
    }
}

std::vector<Subject> subjectsOf(const Difference& difference) {
    std::vector<Subject> things;
    for (const PartChange& part : difference.parts) things.push_back(part.key.subject);
    for (const QueueChange& queue : difference.queues) things.push_back({SubjectKind::Group, queue.group});
    for (const MemberChange& member : difference.members)
        for (const std::uint32_t group : {member.before.group, member.after.group})
            if (const Subject thing{SubjectKind::Group, group};
                group != 0 && (things.empty() || !(things.back() == thing)))
                things.push_back(thing);
    std::sort(things.begin(), things.end());
    things.erase(std::unique(things.begin(), things.end()), things.end());
    return things;
}

std::size_t bytesOf(const Difference& difference) {
    std::size_t bytes = difference.members.size() * sizeof(MemberChange);
    for (const PartChange& part : difference.parts) {
        bytes += sizeof(PartChange);
        for (const auto* said : {&part.before, &part.after})
            if (*said) bytes += encodeCommand({0, 0, 0, **said}).size();
    }
    for (const QueueChange& queue : difference.queues)
        bytes += sizeof(QueueChange) + bytesOf(queue.before) + bytesOf(queue.after);
    for (const Crew& crew : difference.crews) bytes += crew.characters.size() * sizeof(std::uint32_t);
    return bytes;
}

}  // namespace muster
