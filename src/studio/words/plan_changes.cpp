// What is no order: shapes, splits, names, bodies, queues.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/world/inspect.h"
#include "muster/views.h"
#include "studio/words/planner.h"

namespace muster::words {
namespace {

constexpr double kMostParts = 20.0;
constexpr double kMostAdded = 10000.0;

}  // namespace

void Planner::queue(QueueEdit edit, All crews, const char* verb, const char* rest) {
    for (const Crew& crew : crews) {
        commandsFor(crew).push_back(EditQueue{crew.address, edit, {}});
        say(crew, verb, rest);
    }
}

FormationDef Planner::reshape(const Act& act, const Crew& crew) {
    FormationDef made = formationOf(act, crew);
    ChangeGroup change;
    change.group = crew.address;
    change.formation = made;
    commandsFor(crew).emplace_back(std::move(change));
    return made;
}

void Planner::form(const Act& act, All crews) {
    if (!changesShape(act)) {
        if (act.facing) return face(act, crews);
        return fail(
            "Which shape? Say “form a ring”, a line, a column, a square, a wedge, a circle or a crescent.");
    }
    for (const Crew& crew : crews) {
        const FormationDef made = reshape(act, crew);
        std::string rest = "up " + formWord(made.kind);
        if (act.spacing) rest += ", " + numberText(made.spacing) + " m apart";
        say(crew, "take", std::move(rest));
    }
    if (act.facing) face(act, crews);
}

void Planner::space(const Act& act, All crews) {
    for (const Crew& crew : crews) say(crew, "stand", numberText(reshape(act, crew).spacing) + " m apart");
}

void Planner::split(const Act& act, All crews) {
    for (const Crew& crew : crews) {
        if (!crew.whole) {
            say(crew, "become", "a group of their own");
            continue;
        }
        const double parts = act.number.value_or(2.0);
        if (parts < 2.0 || parts > kMostParts || parts != std::floor(parts))
            return fail("Say a number of parts from 2 to 20.");
        if (parts > crew.count())
            return fail(crew.label + " has only " + std::to_string(crew.count()) + " people.");
        SplitGroup split;
        split.group = crew.address;
        split.by = SplitBy::Shares;
        split.shares.assign(static_cast<std::size_t>(parts), 1.0);
        split.abreast = true;
        orders_.emplace_back(std::move(split));
        say(crew, "become", numberText(parts) + " groups");
    }
}

void Planner::merge(const Act& act, All crews) {
    std::vector<GroupId> groups = act.others;
    for (const Crew& crew : crews) {
        if (!crew.whole) return fail("Only whole groups can be joined.");
        if (std::find(groups.begin(), groups.end(), crew.address) == groups.end())
            groups.push_back(crew.address);
    }
    if (groups.size() < 2) return fail("Join whom? Say “South joins North”.");
    MergeGroups merge;
    merge.groups = groups;
    orders_.emplace_back(std::move(merge));
    const std::string into = names_.nameOf(groups.front());
    for (std::size_t k = 1; k < groups.size(); ++k) say(crews_.whole(groups[k]), "join", into);
}

void Planner::rename(const Act& act, All crews) {
    if (crews.size() != 1 || !crews.front().whole) return fail("Name one group at a time.");
    if (act.name.empty() || act.name.size() > 60) return fail("Say a name of at most 60 letters.");
    ChangeGroup change;
    change.group = crews.front().address;
    change.name = act.name;
    result_.edits.emplace_back(std::move(change));
    result_.sentences.push_back(crews.front().label + " is called " + act.name + " from now on.");
}

void Planner::colour(const Act& act, All crews) {
    if (!act.colour)
        return fail("Which colour? Say red, orange, yellow, green, cyan, blue, purple, pink or grey.");
    for (const Crew& crew : crews) {
        if (!crew.whole) return fail("Only whole groups have a colour.");
        ChangeGroup change;
        change.group = crew.address;
        change.colour = GroupColour{act.colour};
        result_.edits.emplace_back(std::move(change));
        say(crew, "get", "another colour");
    }
}

void Planner::hurry(double factor, All crews) {
    const CharactersView people = scene_.world.characters();
    for (const Crew& crew : crews) {
        ChangeCharacters change;
        change.bodies.emplace();
        for (std::size_t i = 0; i < people.size(); ++i) {
            if (!std::binary_search(crew.ids.begin(), crew.ids.end(), people.id[i])) continue;
            Body body = people.body[i];
            if (body.maxSpeed == 0.0) body.maxSpeed = scene_.world.parameters().character.maxSpeed;
            body.maxSpeed = std::clamp(body.maxSpeed * factor, 0.1, 12.0);
            change.ids.push_back(people.id[i]);
            change.bodies->push_back(body);
        }
        orders_.emplace_back(std::move(change));
        say(crew, "get", factor > 1.0 ? "faster by a third" : "slower by a quarter");
    }
}

void Planner::add(const Act& act, All crews) {
    const double more = act.number.value_or(0.0);
    if (crews.size() != 1 || !crews.front().whole) return fail("Say the group: “add 10 people to North”.");
    if (more < 1.0 || more > kMostAdded || more != std::floor(more))
        return fail("Say a number of people from 1 to 10,000.");
    const Crew& crew = crews.front();
    ChangeGroup change;
    change.group = crew.address;
    change.count = crew.count() + static_cast<std::int32_t>(more);
    orders_.emplace_back(std::move(change));
    say(crew, "get", numberText(more) + " more people");
}

void Planner::skip(All crews) {
    for (const Crew& crew : crews) {
        const auto g = inspect::indexOfGroup(scene_.world, crew.group);
        const auto orders = scene_.world.group(*g).orders;
        if (orders.empty()) return fail(crew.label + " has no order to skip.");
        orders_.push_back(EditQueue{crew.address, QueueEdit::Cancel, orders.front().id});
        say(crew, "skip", "what is under way");
    }
}

}  // namespace muster::words
