#include "studio/session/history/commands_between.h"

#include <algorithm>
#include <utility>

#include "engine/world/inspect.h"
#include "studio/session/history/group_fields.h"
#include "studio/session/history/member_moves.h"
#include "studio/session/inbox/received_commands.h"

namespace muster {
namespace {

bool contains(const std::vector<std::uint32_t>& names, std::uint32_t name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether fingers of others hold the mesh of a group.
bool othersHold(const GroupView& group, std::uint32_t client) {
    return std::any_of(group.controls.begin(), group.controls.end(), [&](const Control& control) {
        return control.client != client && std::any_of(control.points.begin(), control.points.end(),
                                                       [](const ControlPoint& point) { return point.down; });
    });
}

class Between {
public:
    Between(Difference& difference, const Leading& leading, const Scene& scene)
        : difference_(difference), leading_(leading), scene_(scene) {}

    LeadingBatch take() {
        for (const PartChange& part : difference_.parts) {
            if (part.key.subject.kind != SubjectKind::Group || !isPresence(part.key)) continue;
            const bool isThere = now(part).has_value();
            if (isThere && !part.after) moves_.go.push_back(part.key.subject.name);
            if (!isThere && part.after && !part.before) moves_.come.push_back(part.key.subject.name);
        }
        for (PartChange& part : difference_.parts) {
            if (isStart(part))
                leadStart(part);
            else if (part.key.subject.kind != SubjectKind::Group)
                leadGround(part);
        }
        for (const FreshGroup& group : leading_.fresh) followGroup(group);
        leadMembers(difference_, scene_, moves_, batch_);
        for (PartChange& part : difference_.parts)
            if (part.key.subject.kind == SubjectKind::Group) leadGroup(part);
        for (QueueChange& queue : difference_.queues) leadQueue(queue);
        for (PartChange* pose : poses_) leadPose(*pose, nullptr);
        return std::move(batch_);
    }

private:
    static bool isStart(const PartChange& part) { return part.key.subject.kind == SubjectKind::Start; }
    std::optional<CommandBody> now(const PartChange& part) const {
        return presentPart(askedOf(part, scene_.names), isStart(part), scene_);
    }
    void give(CommandBody body) {
        scene_.names.toIds(body);
        batch_.bodies.push_back(std::move(body));
    }
    GroupId idOf(std::uint32_t group) const { return GroupId{scene_.names.idOf(SubjectKind::Group, group)}; }
    std::optional<std::size_t> indexOf(std::uint32_t group) const {
        return inspect::indexOfGroup(scene_.world, idOf(group));
    }
    /// The group that it is about; 0 for none.
    static std::uint32_t groupOf(const CommandBody& said) {
        const auto* put = std::get_if<PutThing>(&said);
        return put == nullptr ? 0 : put->group.value;
    }

    void leadStart(PartChange& part) {
        const std::optional<CommandBody> is = now(part);
        if (part.passed || !part.after || !is) return;
        if (!samePart(is, part.after)) scene_.names.toIds(batch_.starts.emplace_back(*part.after));
        part.before = is;
    }

    void leadGround(PartChange& part) {
        if (part.passed) return;
        const std::optional<CommandBody> is = now(part);
        const bool comes = !is && part.after && !part.before && isPresence(part.key);
        const std::uint32_t group = part.after ? groupOf(*part.after) : 0;
        if (group != 0 && !indexOf(group)) {
            batch_.follows = batch_.follows || contains(moves_.come, group);
        } else if (comes) {
            batch_.births.push_back({batch_.bodies.size(), part.key.subject.kind, {part.key.subject.name}});
            give(adding(*part.after));
        } else if (is && !part.after) {
            batch_.bodies.push_back(
                removing(*is, scene_.names.idOf(part.key.subject.kind, part.key.subject.name)));
        } else if (is && !samePart(is, part.after)) {
            give(*part.after);
        }
        if (is || comes) part.before = is;
    }

    /// What names the group by the id that it had before names it by that which it has now.
    void followGroup(const FreshGroup& group) {
        const World& world = scene_.world;
        const auto named = [&](GroupId id) { return group.before && id == group.before; };
        const auto put = [&](std::uint32_t id) -> PutThing& {
            PutThing again;
            again.id = id;
            again.group = idOf(group.name);
            return std::get<PutThing>(batch_.bodies.emplace_back(again));
        };
        for (std::size_t a = 0; a < world.areaCount(); ++a)
            if (const AreaView area = world.area(a); named(area.group)) put(area.id.value).area = area.def;
        for (std::size_t c = 0; c < world.checkpoints().size(); ++c)
            if (named(world.checkpointGroups()[c]))
                put(world.checkpointIds()[c].value).checkpoint = world.checkpoints()[c];
    }

    void leadGroup(PartChange& part) {
        const std::uint32_t group = part.key.subject.name;
        if (part.passed) return;
        if (contains(moves_.come, group)) {
            if (!isPresence(part.key)) batch_.follows = true;
            return;
        }
        const std::optional<CommandBody> is = now(part);
        const bool wanted = is && part.after && !isPresence(part.key);
        if (wanted && isMeshPose(*is)) {
            poses_.push_back(&part);
            return;
        }
        const bool shaped = is && (changesField(*is, &ChangeGroup::formation) ||
                                   changesField(*is, &ChangeGroup::demands));
        if (wanted && shaped && contains(moves_.divided, group))
            batch_.follows = true;
        else if (wanted && (!samePart(is, part.after) || isShapedAgain(*part.after, group)))
            giveTo(group, *part.after);
        if (!is) return;
        if (!isPresence(part.key)) part.before = is;
        for (Crew& crew : difference_.crews) {
            if (!isPresence(part.key) || crew.group != group) continue;
            part.before = is;
            const PlaceGroupDef* start = scene_.place.group(idOf(group));
            crew.start = start == nullptr ? std::nullopt : std::optional(start->def);
        }
    }

    void giveTo(std::uint32_t group, const CommandBody& said) {
        if (std::holds_alternative<SetPose>(said)) placed_.push_back(group);
        give(said);
    }

    /// True where the formation becomes another one because others belong to the group.
    bool isShapedAgain(const CommandBody& said, std::uint32_t group) const {
        const auto g = indexOf(group);
        if (!g || !contains(moves_.changed, group)) return false;
        const auto* change = std::get_if<ChangeGroup>(&said);
        if (change == nullptr) return false;
        if (change->demands) return !change->demands->empty();
        // Not where it has one for a while, from an order that it carries out.
        return change->formation &&
               inspect::ownFormation(scene_.world, *g) == inspect::groupDef(scene_.world, *g).formation;
    }

    void leadQueue(QueueChange& change) {
        if (contains(moves_.come, change.group) || contains(moves_.divided, change.group)) {
            batch_.follows = true;
            return;
        }
        const auto g = indexOf(change.group);
        if (!g || contains(moves_.go, change.group)) return;
        QueueState is = queueOf(scene_.world.group(*g)), from = change.before, to = change.after;
        toIds(from, scene_.names);
        toIds(to, scene_.names);
        const bool fresh = std::any_of(leading_.fresh.begin(), leading_.fresh.end(),
                                       [&](const FreshGroup& one) { return one.name == change.group; });
        if (fresh && sameOrders(is, to)) {
            for (std::size_t k = 0; k < is.orders.size(); ++k)
                scene_.names.bind(SubjectKind::Order, change.after.orders[k].id, is.orders[k].id);
            to.orders = is.orders;
        }
        QueueState wanted = fresh ? to : merged(is, from, to);
        const QueueState before = is;
        const auto pose = std::find_if(poses_.begin(), poses_.end(), [&](const PartChange* part) {
            return part->key.subject.name == change.group;
        });
        if (pose != poses_.end()) {
            if (leadPose(**pose, &wanted)) is = {};
            poses_.erase(pose);
        }
        if (contains(placed_, change.group)) is = {};
        lead(idOf(change.group), is, wanted, scene_.names, batch_);
        forgetDone(change, before);
    }

    /// Orders that have left the queue by themselves do not come back.
    void forgetDone(QueueChange& change, const QueueState& now) {
        std::erase_if(change.before.orders, [&](const QueuedOrder& order) {
            const auto has = [&](const std::vector<QueuedOrder>& orders, std::uint32_t id) {
                return std::any_of(orders.begin(), orders.end(),
                                   [&](const QueuedOrder& one) { return one.id == id; });
            };
            return !has(now.orders, scene_.names.idOf(SubjectKind::Order, order.id)) &&
                   !has(change.after.orders, order.id);
        });
    }

    /// The mesh is put where it is to stand, unless orders that stay lead it elsewhere. True where it is.
    bool leadPose(PartChange& part, const QueueState* wanted) {
        const GroupView group = scene_.world.group(*indexOf(part.key.subject.name));
        const std::optional<CommandBody> is = now(part);
        const auto stays = [&](const QueuedOrder& order) {
            return wanted == nullptr ||
                   std::any_of(wanted->orders.begin(), wanted->orders.end(),
                               [&](const QueuedOrder& one) { return one.id == order.id; });
        };
        const bool ordered = std::any_of(group.orders.begin(), group.orders.end(), stays);
        const bool moves = !ordered && !othersHold(group, leading_.client) && !samePart(is, part.after);
        if (moves) give(*part.after);
        part.before = is;
        return moves;
    }

    Difference& difference_;
    const Leading& leading_;
    const Scene& scene_;
    LeadingBatch batch_;
    MemberMoves moves_;
    std::vector<PartChange*> poses_;
    std::vector<std::uint32_t> placed_;  // Groups that are put elsewhere, which ends their orders.
};

}  // namespace

LeadingBatch commandsBetween(Difference& difference, const Leading& leading, const Scene& scene) {
    return Between(difference, leading, scene).take();
}

}  // namespace muster
