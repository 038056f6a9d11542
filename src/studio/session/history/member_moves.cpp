#include "studio/session/history/member_moves.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/world/inspect.h"

namespace muster {
namespace {

using List = std::vector<std::uint32_t>;

bool isIn(const List& names, std::uint32_t name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void putIn(List& names, std::uint32_t name) {
    if (!isIn(names, name)) names.push_back(name);
}

class Moving {
public:
    Moving(Difference& difference, const Scene& scene, MemberMoves& moves, LeadingBatch& batch)
        : difference_(difference), scene_(scene), moves_(moves), batch_(batch) {}

    void take() {
        for (MemberChange& member : difference_.members) sort(member);
        for (const std::uint32_t group : moves_.come) bring(group);
        unite();
        transfer();
        join();
        if (!leaving_.empty()) batch_.bodies.push_back(TransferCharacters{std::move(leaving_), {}});
        for (const std::uint32_t group : ending_) batch_.bodies.push_back(RemoveGroup{idOf(group)});
        if (!bodied_.empty())
            batch_.bodies.push_back(ChangeCharacters{std::move(bodied_), std::move(bodies_), {}});
    }

private:
    struct Newcomers {
        AddCharacters add;
        List names;
    };

    GroupId idOf(std::uint32_t group) const { return GroupId{scene_.names.idOf(SubjectKind::Group, group)}; }
    bool isThere(std::uint32_t group) const {
        return inspect::indexOfGroup(scene_.world, idOf(group)).has_value();
    }
    std::size_t sizeOf(std::uint32_t group) const {
        const auto g = inspect::indexOfGroup(scene_.world, idOf(group));
        return g ? scene_.world.group(*g).members.size() : 0;
    }

    /// Notes what is to become of a character, and what it is now.
    void sort(MemberChange& member) {
        const std::uint32_t id = scene_.names.idOf(SubjectKind::Character, member.character);
        const MemberState now = presentMember(id, scene_.world, scene_.names);
        const bool stays = member.before.group == member.after.group;
        const bool sameBodies = member.before.body == member.after.body;
        if (now.group != 0) {
            member.before.position = now.position;
            if (sameBodies)
                member.before.body = member.after.body = now.body;
            else if (member.after.group != 0 && !(now.body == member.after.body))
                bodied_.push_back(id), bodies_.push_back(member.after.body);
            if (!sameBodies) member.before.body = now.body;
        }
        if (stays || member.passed) return;
        const std::uint32_t to = member.after.group;
        if (now.group == 0) {
            // Who was taken away by others stays away.
            if (member.before.group != 0 || (!isThere(to) && !isIn(moves_.come, to))) return;
            Newcomers& newcomers = newcomers_[to];
            newcomers.add.positions.push_back(member.after.position);
            newcomers.add.bodies.push_back(member.after.body);
            newcomers.names.push_back(member.character);
        } else if (to == 0) {
            leaving_.push_back(id);
            putIn(moves_.changed, now.group);
        } else if (now.group != to && (isThere(to) || isIn(moves_.come, to))) {
            going_[to][now.group].push_back(id);
        }
    }

    /// A group comes: out of the one in which most of its people are, or with people of its own.
    void bring(std::uint32_t group) {
        std::map<std::uint32_t, List>& from = going_[group];
        const auto most = std::max_element(from.begin(), from.end(), [](const auto& a, const auto& b) {
            return a.second.size() < b.second.size();
        });
        if (most == from.end() || !divide(group, most->first, most->second)) {
            add(group, most == from.end() && !newcomers_.contains(group));
            batch_.follows = batch_.follows || most != from.end() || newcomers_.contains(group);
        } else {
            from.erase(most);
            batch_.follows = true;
        }
    }

    bool divide(std::uint32_t group, std::uint32_t from, const List& ids) {
        const auto left = left_.try_emplace(from, sizeOf(from)).first;
        if (ids.size() >= left->second) return false;
        left->second -= ids.size();
        const PartShape shape = isHeld(group) || isHeld(from) ? PartShape::AsHeld : PartShape::Smaller;
        batch_.births.push_back({batch_.bodies.size(), SubjectKind::Group, {group}});
        batch_.bodies.push_back(SplitGroup{idOf(from), SplitBy::Ids, ids, {}, {}, false, shape});
        putIn(moves_.divided, from);
        return true;
    }

    /// The formation that a group is to have; null where it keeps its own.
    const FormationDef* wantedShape(std::uint32_t group) const {
        for (const PartChange& part : difference_.parts) {
            const bool isOf = part.key.subject == Subject{SubjectKind::Group, group};
            const auto* change = isOf && part.after ? std::get_if<ChangeGroup>(&*part.after) : nullptr;
            if (change != nullptr && change->formation) return &*change->formation;
        }
        return nullptr;
    }
    bool isHeld(std::uint32_t group) const {
        const FormationDef* shape = wantedShape(group);
        return shape != nullptr && shape->kind == FormationKind::Points;
    }

    void add(std::uint32_t group, bool withPeople) {
        for (const PartChange& part : difference_.parts) {
            const auto* said = part.key.subject == Subject{SubjectKind::Group, group} && part.after
                                   ? std::get_if<AddGroup>(&*part.after)
                                   : nullptr;
            if (said == nullptr) continue;
            CommandBody body = *said;
            GroupDef& def = std::get<AddGroup>(body).group;
            Birth birth{batch_.bodies.size(), SubjectKind::Group, {group}};
            if (!withPeople) def.count = 0, def.starts.clear(), def.demands.clear();
            for (const Crew& crew : difference_.crews)
                if (crew.group == group && std::cmp_equal(crew.characters.size(), def.count) &&
                    birth.names.size() == 1)
                    birth.names.insert(birth.names.end(), crew.characters.begin(), crew.characters.end());
            scene_.names.toIds(body);
            batch_.births.push_back(std::move(birth));
            batch_.bodies.push_back(std::move(body));
            return;
        }
    }

    /// Groups end: their people go to the group that most of them go to, or leave with them.
    void unite() {
        std::map<std::uint32_t, List> into;
        for (const std::uint32_t group : moves_.go) {
            const std::uint32_t to = targetOf(group);
            if (to != 0 && isIn(moves_.come, to)) {
                batch_.follows = true;
            } else if (to == 0) {
                ending_.push_back(group);
            } else {
                going_[to].erase(group);
                into[to].push_back(group);
            }
        }
        for (const auto& [to, groups] : into) {
            MergeGroups merge{{idOf(to)}, isHeld(to) ? PartShape::AsHeld : PartShape::Smaller};
            for (const std::uint32_t group : groups) merge.groups.push_back(idOf(group));
            merges_.push_back(std::move(merge));
            putIn(moves_.changed, to);
        }
    }

    std::uint32_t targetOf(std::uint32_t group) const {
        std::uint32_t best = 0;
        std::size_t most = 0;
        for (const auto& [to, from] : going_) {
            const auto found = from.find(group);
            if (found == from.end() || found->second.size() <= most) continue;
            best = to;
            most = found->second.size();
        }
        if (best != 0) return best;
        const bool ownPeople = std::any_of(difference_.crews.begin(), difference_.crews.end(),
                                           [&](const Crew& crew) { return crew.group == group; });
        // Nobody is left of those with whom it came: whoever is in it now goes where these came from.
        for (const MemberChange& member : difference_.members)
            if (!ownPeople && member.before.group == group && isThere(member.after.group))
                return member.after.group;
        return 0;
    }

    void transfer() {
        for (auto& [to, from] : going_) {
            TransferCharacters transfer{{}, idOf(to)};
            for (const auto& [group, ids] : from) {
                transfer.ids.insert(transfer.ids.end(), ids.begin(), ids.end());
                putIn(moves_.changed, group);
            }
            if (transfer.ids.empty() || isIn(moves_.come, to)) continue;
            putIn(moves_.changed, to);
            batch_.bodies.push_back(std::move(transfer));
        }
        for (MergeGroups& merge : merges_) batch_.bodies.push_back(std::move(merge));
    }

    void join() {
        for (auto& [to, newcomers] : newcomers_) {
            if (isIn(moves_.come, to)) continue;
            newcomers.add.group = idOf(to);
            putIn(moves_.changed, to);
            batch_.births.push_back(
                {batch_.bodies.size(), SubjectKind::Character, std::move(newcomers.names)});
            batch_.bodies.push_back(std::move(newcomers.add));
        }
    }

    Difference& difference_;
    const Scene& scene_;
    MemberMoves& moves_;
    LeadingBatch& batch_;
    std::map<std::uint32_t, std::map<std::uint32_t, List>> going_;  // Ids, by groups to and from.
    std::map<std::uint32_t, Newcomers> newcomers_;                  // By group.
    std::map<std::uint32_t, std::size_t> left_;                     // Members after splits, by group.
    List leaving_, ending_;
    std::vector<MergeGroups> merges_;
    List bodied_;  // Ids of those who get other bodies.
    std::vector<Body> bodies_;
};

}  // namespace

void leadMembers(Difference& difference, const Scene& scene, MemberMoves& moves, LeadingBatch& batch) {
    Moving(difference, scene, moves, batch).take();
}

}  // namespace muster
