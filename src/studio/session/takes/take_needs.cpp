#include "studio/session/takes/take_needs.h"

#include <algorithm>
#include <array>
#include <map>

#include "studio/session/history/generated/command_ids.h"
#include "studio/session/takes/take_blocks.h"

namespace muster {
namespace {

enum class Made : std::uint8_t { Groups, People, Things, Orders, Controls };
constexpr std::array kMade{Made::Groups, Made::People, Made::Things, Made::Orders, Made::Controls};

bool makes(const CommandBody& body, Made made) {
    const bool addsGroup = std::holds_alternative<AddGroup>(body);
    const bool splits = std::holds_alternative<SplitGroup>(body);
    switch (made) {
        case Made::Groups:
            return addsGroup || splits;
        case Made::People: {
            const auto* change = std::get_if<ChangeGroup>(&body);
            return addsGroup || std::holds_alternative<AddCharacters>(body) || (change && change->count);
        }
        case Made::Things: {
            const auto* put = std::get_if<PutThing>(&body);
            return put != nullptr && put->id == 0;
        }
        case Made::Orders:
            return addsGroup || splits || std::holds_alternative<GiveOrder>(body) ||
                   std::holds_alternative<MergeGroups>(body);
        case Made::Controls:
            return std::holds_alternative<AddControl>(body) || touchOf(body, TouchPhase::Down) != nullptr;
    }
    return false;
}

/// What the commands of a take need.
class Needs {
public:
    Needs(const Take& take, const TakeNews& news) : take_(take), order_(inOrder(take.commands)) {
        for (const TakeNews::GroupTimes& group : news.groups()) comes_[group.id.value] = group.from;
        for (const GroupDef& group : take.def.groups)
            people_ += static_cast<std::uint32_t>(std::max(0, group.count));
        things_ = static_cast<std::uint32_t>(
            std::min({take.def.obstacles.size(), take.def.patches.size(), take.def.areas.size()}));
    }

    BrokenNeed broken(Made made, const std::vector<DraftCommand>& draft) {
        makers_.clear();
        std::vector<std::size_t> before(take_.commands.size());  // Makers before each command.
        for (const std::size_t index : order_) {
            before[index] = makers_.size();
            if (makes(take_.commands[index].body, made)) makers_.push_back(index);
        }
        std::size_t seen = 0,
                    kept = 0;  // Makers of the draft, and how many are the take's own in their order.
        std::size_t between = take_.commands.size();
        for (const DraftCommand& one : draft) {
            const std::size_t need = needed(one.command.body, made, before[one.origin]);
            if (need > kept) return {one.origin, between < take_.commands.size() ? between : makers_[kept]};
            if (!makes(one.command.body, made)) continue;
            const bool next = kept == seen && kept < makers_.size() && !one.copy &&
                              makers_[kept] == one.origin;
            if (next) ++kept;
            if (!next && between == take_.commands.size()) between = one.origin;
            ++seen;
        }
        return {take_.commands.size(), 0};
    }

private:
    /// How many makers a command needs before it.
    std::size_t needed(const CommandBody& of, Made made, std::size_t before) {
        CommandBody body = of;
        std::size_t most = 0;
        const auto need = [&](bool named) { most = named ? std::max(most, before) : most; };
        if (made == Made::Controls) need(std::holds_alternative<EditControl>(body));
        if (made == Made::Things) {
            if (const auto* put = std::get_if<PutThing>(&body)) need(put->id > things_);
            if (const auto* remove = std::get_if<RemoveThing>(&body)) need(remove->id > things_);
        }
        const auto visit = [&](SubjectKind kind, std::uint32_t id) {
            if (id == 0) return;
            if (made == Made::Groups && kind == SubjectKind::Group) most = std::max(most, makersOfGroup(id));
            if (made == Made::People && kind == SubjectKind::Character) need(id > people_);
            if (made == Made::Things && kind == SubjectKind::Area) need(id > take_.def.areas.size());
            if (made == Made::Orders && kind == SubjectKind::Order) need(true);
        };
        std::visit([&](auto& c) { visitIds(c, visit); }, body);
        return most;
    }
    /// Those up to the one that made it.
    std::size_t makersOfGroup(std::uint32_t id) const {
        if (id <= take_.def.groups.size()) return 0;
        const auto found = comes_.find(id);
        if (found == comes_.end()) return 0;
        return static_cast<std::size_t>(std::count_if(makers_.begin(), makers_.end(), [&](std::size_t index) {
            return take_.commands[index].step < found->second;
        }));
    }

    const Take& take_;
    std::vector<std::size_t> order_;
    std::vector<std::size_t> makers_;
    std::map<std::uint32_t, std::uint32_t> comes_;  // Steps, by group.
    std::uint32_t people_ = 0, things_ = 0;
};

}  // namespace

BrokenNeed brokenNeed(const Take& take, const TakeNews& news, const std::vector<DraftCommand>& draft) {
    Needs needs(take, news);
    for (const Made made : kMade)
        if (const BrokenNeed broken = needs.broken(made, draft); broken.needs < take.commands.size())
            return broken;
    return {take.commands.size(), 0};
}

}  // namespace muster
