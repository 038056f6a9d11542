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

void Planner::queue(const Act& act, QueueEdit edit, All crews, const char* verb, const char* rest) {
    if (!doesNow(act, verb, kNone)) return;
    for (const Crew& crew : crews) {
        commandsFor(crew).push_back(EditQueue{crew.address, edit, {}});
        say(crew, verb, rest);
    }
}

void Planner::reverse(const Act& act, All crews) {
    if (!doesNow(act, "reverse", kNone)) return;
    for (const Crew& crew : crews) {
        commandsFor(crew).push_back(ReverseQueue{crew.address});
        say(crew, "go", "through the orders from the last to the first");
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
    const bool later = act.then && !fresh_ && !ordered_.empty();
    if (!(later ? does(act, "form", kStand) : doesNow(act, "form", kStand))) return;
    if (later) return formLater(act, crews);
    for (const Crew& crew : crews) {
        const FormationDef made = reshape(act, crew);
        const std::string apart = numberText(made.spacing) + " m apart";
        if (!act.form)
            say(crew, "stand", apart);
        else
            say(crew, "take", "up " + formWord(made.kind) + (changesSpacing(act) ? ", " + apart : ""));
    }
    if (act.facing) face(act, crews);
}

// After the order before it: an order to where that one ends.
void Planner::formLater(const Act& act, All crews) {
    for (const Crew& crew : crews) {
        Order order = Order::move(whereIs(crew));
        order.formation = formationOf(act, crew);
        if (act.facing) order.facing = facingOf(*act.facing, crew, order.target);
        std::string rest = "up " + formWord(order.formation->kind) + " there";
        if (changesSpacing(act)) rest += ", " + numberText(order.formation->spacing) + " m apart";
        if (act.facing) rest += ", facing " + act.facing->words;
        give(crew, std::move(order), true);
        say(crew, "take", std::move(rest));
    }
}

void Planner::split(const Act& act, All crews) {
    if (!doesNow(act, "split", kNumber)) return;
    for (const Crew& crew : crews) {
        if (!crew.whole) {
            if (act.number) return fail("Only whole groups can be divided into parts.");
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
    if (!doesNow(act, "join", kOthers)) return;
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
    if (!doesNow(act, "rename", kName)) return;
    if (crews.size() != 1 || !crews.front().whole) return fail("Name one group at a time.");
    if (act.name.empty() || act.name.size() > 60) return fail("Say a name of at most 60 letters.");
    ChangeGroup change;
    change.group = crews.front().address;
    change.name = act.name;
    result_.edits.emplace_back(std::move(change));
    result_.sentences.push_back(crews.front().label + " is called " + act.name + " from now on.");
}

void Planner::colour(const Act& act, All crews) {
    if (!doesNow(act, "colour", kColour)) return;
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

void Planner::hurry(const Act& act, double factor, All crews) {
    if (!doesNow(act, factor > 1.0 ? "faster" : "slower", kNone)) return;
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
    if (!doesNow(act, "add", kNumber)) return;
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

void Planner::skip(const Act& act, All crews) {
    if (!doesNow(act, "skip", kNone)) return;
    for (const Crew& crew : crews) {
        const auto g = inspect::indexOfGroup(scene_.world, crew.group);
        const auto orders = scene_.world.group(*g).orders;
        if (orders.empty()) return fail(crew.label + " has no order to skip.");
        orders_.push_back(EditQueue{crew.address, QueueEdit::Cancel, orders.front().id});
        say(crew, "skip", "what is under way");
    }
}

}  // namespace muster::words
