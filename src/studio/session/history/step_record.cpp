#include "studio/session/history/step_record.h"

#include <algorithm>
#include <utility>

#include "engine/world/inspect.h"
#include "studio/session/history/group_fields.h"

namespace muster {

/// The difference that the commands of one act make.
class StepRecord::Change {
public:
    Change(StepRecord& record, const Scene& scene, StepBirths& births)
        : record_(record), scene_(scene), births_(births) {}

    void add(const CommandBody& body, const Concern& concern) {
        const std::vector<std::uint32_t> ids = births_.of(body, scene_.world);
        for (const CommandBody& single : singleFields(body)) {
            if (setsPart(single)) say(single, ids);
            if (concern.place) look(single, false, true);
        }
        if (const GroupId group = queueChangedBy(body)) order(group, body, ids);
        if (const auto* remove = std::get_if<RemoveGroup>(&body)) {
            remember(remove->group, concern.characters);
            difference_.crews.back().start = concern.start;
            return lookAtQueue(remove->group);
        }
        if (std::holds_alternative<AddGroup>(body)) return crew(ids);
        for (const Concern::Part& part : concern.parts) look(part.asked, part.stays);
        for (const GroupId group : concern.queues) lookAtQueue(group);
        for (const std::uint32_t id : concern.characters) lookAtMember(id);
        for (const GroupId group : concern.joined)
            for (const std::uint32_t id : births_.newMembers(group, scene_.world)) lookAtMember(id);
        if (std::holds_alternative<AddCharacters>(body))
            for (const std::uint32_t id : ids) lookAtMember(id);
        if (std::holds_alternative<SplitGroup>(body))
            for (const std::uint32_t id : ids) lookAtPart(GroupId{id});
    }

    Difference take() {
        std::stable_sort(members_.begin(), members_.end(), [](const MemberChange& a, const MemberChange& b) {
            return a.character < b.character;
        });
        Difference whole;
        join(whole, std::move(difference_));
        // One that was looked at for two commands is what it was before the first of them.
        for (MemberChange& member : members_) {
            if (!whole.members.empty() && whole.members.back().character == member.character)
                whole.members.back().after = member.after;
            else
                whole.members.push_back(member);
        }
        dropEqual(whole);
        for (PartChange& part : whole.parts)
            for (auto* said : {&part.before, &part.after})
                if (auto* add = *said ? std::get_if<AddGroup>(&**said) : nullptr;
                    add && !hasCrew(whole, part))
                    empty(add->group);
        return whole;
    }

private:
    static bool hasCrew(const Difference& whole, const PartChange& part) {
        return std::any_of(whole.crews.begin(), whole.crews.end(),
                           [&](const Crew& crew) { return crew.group == part.key.subject.name; });
    }
    /// Its people come from other groups.
    static void empty(GroupDef& def) {
        def.count = 0;
        def.starts.clear();
        def.bodies.clear();
        def.demands.clear();
        def.orders.clear();
        def.patrols = false;
    }

    std::uint32_t groupName(GroupId group) const {
        return scene_.names.nameOf(SubjectKind::Group, group.value);
    }

    void put(const PartKey& key, std::optional<CommandBody> after, bool stays) {
        std::optional<CommandBody>& now = record_.parts_[key];
        Difference one;
        one.parts.push_back({key, now, after, stays});
        join(difference_, std::move(one));
        now = std::move(after);
    }

    /// The command says what the property is.
    void say(const CommandBody& body, const std::vector<std::uint32_t>& ids) {
        PartKey key = keyOf(body, scene_.names);
        if (key.subject.name == 0) {
            if (ids.empty()) return;
            key.subject.name = scene_.names.nameOf(key.subject.kind, ids.front());
        }
        std::optional<CommandBody> said = saidBy(body, ids.empty() ? 0 : ids.front());
        if (said) scene_.names.toNames(*said);
        put(key, std::move(said), false);
    }

    /// The world says it, or of how a group starts the place.
    void look(const CommandBody& asked, bool stays, bool start = false) {
        const PartKey key = keyOf(asked, scene_.names, start);
        if (key.subject.name != 0) put(key, presentPart(asked, start, scene_), stays);
    }

    void putQueue(std::uint32_t group, QueueState after, bool stays) {
        QueueState& now = record_.queues_[group];
        Difference one;
        one.queues.push_back({group, now, after, stays});
        join(difference_, std::move(one));
        now = std::move(after);
    }

    // The queue is what the command makes of it, whatever is done of it in the same step.
    void order(GroupId group, CommandBody body, const std::vector<std::uint32_t>& ids) {
        scene_.names.toNames(body);
        QueueState after = record_.queues_[groupName(group)];
        apply(after, body, ids.empty() ? 0 : scene_.names.nameOf(SubjectKind::Order, ids.front()));
        putQueue(groupName(group), std::move(after), false);
    }

    void lookAtQueue(GroupId group) {
        QueueState after;
        if (const auto g = inspect::indexOfGroup(scene_.world, group))
            after = queueOf(scene_.world.group(*g));
        toNames(after, scene_.names);
        putQueue(groupName(group), std::move(after), true);
    }

    void lookAtMember(std::uint32_t id) {
        const std::uint32_t name = scene_.names.nameOf(SubjectKind::Character, id);
        MemberState& now = record_.members_[name];
        const MemberState after = presentMember(id, scene_.world, scene_.names);
        if (after.group == 0 && births_.cameOrLeft(id)) return;
        members_.push_back({name, now, after});
        now = after;
    }

    /// A group that has come by a split.
    void lookAtPart(GroupId part) {
        look(RemoveGroup{part}, false);
        for (const CommandBody& asked : propertiesOf(part)) look(asked, false);
        lookAtQueue(part);
    }

    void crew(const std::vector<std::uint32_t>& ids) {
        if (ids.empty()) return;
        remember(GroupId{ids.front()}, births_.newMembers(GroupId{ids.front()}, scene_.world));
        lookAtQueue(GroupId{ids.front()});
    }

    void remember(GroupId group, const std::vector<std::uint32_t>& ids) {
        Crew crew{groupName(group), {}, {}};
        for (const std::uint32_t id : ids)
            crew.characters.push_back(scene_.names.nameOf(SubjectKind::Character, id));
        difference_.crews.push_back(std::move(crew));
    }

    StepRecord& record_;
    const Scene& scene_;
    StepBirths& births_;
    Difference difference_;
    std::vector<MemberChange> members_;
};

void StepRecord::readPart(const CommandBody& asked, bool start, const Scene& scene) {
    const PartKey key = keyOf(asked, scene.names, start);
    if (key.subject.name == 0 || parts_.contains(key)) return;
    parts_.emplace(key, presentPart(asked, start, scene));
}

void StepRecord::readQueue(GroupId group, const Scene& scene) {
    const auto g = inspect::indexOfGroup(scene.world, group);
    if (!g) return;
    const auto [at, isNew] = queues_.try_emplace(scene.names.nameOf(SubjectKind::Group, group.value));
    if (!isNew) return;
    at->second = queueOf(scene.world.group(*g));
    toNames(at->second, scene.names);
}

Concern StepRecord::read(const CommandBody& body, const Scene& scene, bool place) {
    Concern concern = concernOf(body, scene.world, place);
    for (const CommandBody& single : singleFields(body)) {
        if (setsPart(single)) readPart(single, false, scene);
        if (place) readPart(single, true, scene);
    }
    for (const Concern::Part& part : concern.parts) readPart(part.asked, false, scene);
    if (const GroupId group = queueChangedBy(body)) readQueue(group, scene);
    for (const GroupId group : concern.queues) readQueue(group, scene);
    if (const auto* remove = std::get_if<RemoveGroup>(&body)) {
        if (const PlaceGroupDef* start = scene.place.group(remove->group)) concern.start = start->def;
        return concern;
    }
    for (const std::uint32_t id : concern.characters) {
        const auto [at, isNew] = members_.try_emplace(scene.names.nameOf(SubjectKind::Character, id));
        if (isNew) at->second = presentMember(id, scene.world, scene.names);
    }
    return concern;
}

Difference StepRecord::changed(const std::vector<CommandBody>& bodies, const std::vector<Concern>& concerns,
                               const Scene& scene, StepBirths& births) {
    Change change(*this, scene, births);
    for (std::size_t k = 0; k < bodies.size(); ++k) change.add(bodies[k], concerns[k]);
    return change.take();
}

void StepRecord::assume(const Difference& difference) {
    for (const PartChange& part : difference.parts)
        if (!part.passed) parts_[part.key] = part.after;
}

void StepRecord::clear() {
    parts_.clear();
    queues_.clear();
    members_.clear();
}

}  // namespace muster
