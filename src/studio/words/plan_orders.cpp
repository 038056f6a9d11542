// Orders: where to go, whom to follow, what to guard.
#include <algorithm>
#include <cmath>
#include <utility>

#include "base/maths.h"
#include "engine/world/inspect.h"
#include "muster/views.h"
#include "studio/words/lexicon.h"
#include "studio/words/planner.h"

namespace muster::words {
namespace {

constexpr double kFollowGap = 2.0;  // Behind whom they follow [m].
constexpr double kGuardGap = 1.5;   // Round what they guard [m].
constexpr double kBeyond = 2.0;     // What they have crossed [m].
constexpr double kGuardHalf = 2.0;  // Round a mere point [m].

std::string metres(double value) {
    return numberText(value) + " m";
}

/// "to Fountain", "10 m north", "beside South".
std::string whereTo(const Spot& spot) {
    const std::string heading(nameOf(spot.heading));
    if (spot.kind == SpotKind::Shift) return metres(spot.metres.value_or(10.0)) + " " + heading;
    if (spot.kind == SpotKind::Point)
        return "to " + numberText(spot.point.x) + ", " + numberText(spot.point.y);
    if (spot.kind == SpotKind::Between) return spot.words;
    if (spot.beside == Beside::Off)
        return (spot.metres ? metres(*spot.metres) + " " : "") + heading + " of " + spot.words;
    if (spot.beside == Beside::InFront) return "in front of " + spot.words;
    if (spot.beside == Beside::Behind) return "behind " + spot.words;
    if (spot.beside == Beside::Around) return "round " + spot.words;
    return (spot.kind == SpotKind::Group || spot.beside == Beside::Near ? "beside " : "to ") + spot.words;
}

Vec2 halfSizeOf(const ThingSpot& thing) {
    return {std::max(thing.reach({1, 0}), thing.reach({-1, 0})) + kGuardGap,
            std::max(thing.reach({0, 1}), thing.reach({0, -1})) + kGuardGap};
}

/// "Fountain and there".
std::string placesText(const std::vector<Spot>& places) {
    std::string text;
    for (const Spot& spot : places)
        text += (text.empty() ? "" : " and ") + (spot.words.empty() ? "there" : spot.words);
    return text;
}

/// Where a way leads through something, and in which direction.
struct Crossing {
    Vec2 middle;         ///< [m]
    Vec2 direction;      ///< Of length 1.
    double depth = 0.0;  ///< From the middle to the far side [m].
};

/// Across the longest side of the thing, away from where they come.
Vec2 directionAcross(const ThingSpot& thing, Vec2 middle, Vec2 from) {
    Vec2 side = {-(middle - from).y, (middle - from).x};
    double longest = 0.0;
    for (std::size_t k = 0; k < thing.outline.size(); ++k) {
        const Vec2 one = thing.outline[(k + 1) % thing.outline.size()] - thing.outline[k];
        if (length(one) > longest) side = one, longest = length(one);
    }
    if (length(side) < 1e-9) return {1, 0};
    const Vec2 across = Vec2{-side.y, side.x} / length(side);
    return dot(middle - from, across) < 0.0 ? -across : across;
}

/// A gate is gone through; other ground is crossed where it is said so.
std::optional<Crossing> crossingAt(const Spot& spot, Vec2 from) {
    if (spot.kind != SpotKind::Thing || spot.beside != Beside::At) return std::nullopt;
    const ThingSpot& thing = nearestOf(spot.things, from);
    if (!thing.doorway && !spot.crossed) return std::nullopt;
    const Vec2 middle = thing.doorway.value_or(thing.centre);
    const Vec2 direction = directionAcross(thing, middle, from);
    return Crossing{middle, direction, thing.doorway ? 0.0 : thing.reach(direction)};
}

/// Where those stand who have crossed it.
Vec2 beyond(const Crossing& crossing, const Crew& crew, const FormationDef& formation) {
    const double far = crossing.depth + extentOf(formation, crew.count()).farthest() + kBeyond;
    return crossing.middle + crossing.direction * far;
}

}  // namespace

Vec2 Planner::whereIs(const Crew& crew) const {
    const auto found = bound_.find(crew.address);
    return found == bound_.end() ? crew.middle : found->second;
}

void Planner::give(const Crew& crew, Order order, bool then) {
    const bool appends = ordered_.contains(crew.address) || then;
    const bool first = ordered_.insert(crew.address).second;
    if (first)
        result_.previews.push_back({crew.group, crew.all ? std::vector<std::uint32_t>{} : crew.ids, order});
    bound_[crew.address] = order.kind == OrderKind::Move ? order.target : whereIs(crew);
    GiveOrder command;
    command.group = crew.address;
    command.mode = appends ? QueueMode::Append : QueueMode::Replace;
    command.order = std::move(order);
    commandsFor(crew).emplace_back(std::move(command));
}

std::optional<double> Planner::facingOf(const Facing& facing, const Crew& crew, Vec2 from) const {
    if (facing.turn) return crew.heading() + *facing.turn;
    if (facing.heading) {
        const Vec2 d = directionOf(*facing.heading, crew.front);
        return arcTangent2(d.y, d.x);
    }
    const Vec2 to = pointOf(*facing.at, scene_.world, crew) - from;
    if (length(to) < 1e-6) return std::nullopt;
    return facing.away ? arcTangent2(-to.y, -to.x) : arcTangent2(to.y, to.x);
}

std::vector<Vec2> Planner::routeOf(const Act& act, const Crew& crew, Vec2 target) const {
    std::vector<Vec2> route;
    if (act.via.empty()) return route;
    Crew walker = crew;
    route.push_back(whereIs(crew));
    for (const Spot& spot : act.via) {
        walker.middle = route.back();
        const auto crossing = crossingAt(spot, walker.middle);
        const FormationDef formation = formationOf(act, crew);
        // Other things are passed beside.
        route.push_back(crossing ? crossing->middle
                                 : standsAt(spot, scene_.world, {walker}, {formation})[0].target);
    }
    route.push_back(target);
    return route;
}

void Planner::move(const Act& act, All crews) {
    if (!act.to && act.via.empty()) {
        if (changesShape(act)) return form(act, crews);
        if (act.facing) return face(act, crews);
        if (act.verb == Verb::Face)
            return fail("Where to? Say “face north”, “face the middle” or “turn left”.");
        if (act.verb == Verb::Form)
            return fail(
                "Which shape? Say “form a ring”, a line, a column, a square, a wedge, a circle or a "
                "crescent.");
        return fail("Where to? Say a thing, as “to the middle”, a point, as “to 5, 3”, or “10 m north”.");
    }
    Spot spot = act.to ? *act.to : act.via.back();
    if (spot.kind == SpotKind::Thing) {
        const ThingSpot& first = spot.things.front();
        if (first.kind == NamedKind::Area && first.area != AreaKind::Source && spot.beside == Beside::At &&
            act.via.empty()) {
            if (first.area == AreaKind::Exit) return leave(act, crews);
            return goToArea(act, crews, first);
        }
    }
    if (act.verb == Verb::Wait && act.seconds > 0.0)
        return fail("They can wait for a time only in a waiting area.");
    moveTo(act, crews, spot);
}

void Planner::moveTo(const Act& act, All crews, const Spot& spot) {
    if (!does(act, "go", kTo | kVia | kStand | kPace | kFreely)) return;
    for (const Spot& one : act.via)
        if (one.crossed && one.things.front().kind != NamedKind::Patch && !one.things.front().doorway)
            return fail("Nobody can go over or through " + one.words + ". Say “past " + one.words + "”.");
    std::vector<FormationDef> formations;
    std::vector<Crew> from;
    for (const Crew& crew : crews) {
        formations.push_back(formationOf(act, crew));
        from.push_back(crew);
        from.back().middle = whereIs(crew);
    }
    const std::vector<Stand> stands = standsAt(spot, scene_.world, from, formations);
    for (std::size_t k = 0; k < crews.size(); ++k) {
        const Crew& crew = crews[k];
        const auto crossing = act.to ? std::nullopt : crossingAt(spot, from[k].middle);
        Order order = crossing ? Order::move(beyond(*crossing, from[k], formations[k]))
                               : Order::move(stands[k].target, stands[k].facing);
        if (act.facing) order.facing = facingOf(*act.facing, crew, order.target);
        if (stands[k].spacing && changesSpacing(act))
            return fail("A ring round " + spot.words + " has to be wider than that: leave the spacing out.");
        if (stands[k].spacing) formations[k].spacing = *stands[k].spacing;
        if (!crew.whole || formations[k] != crew.formation) order.formation = formations[k];
        order.route = routeOf(act, from[k], order.target);
        if (act.freely) order.manner = Manner::Free;
        if (act.pace)
            order.pace = *act.pace;
        else if (act.haste < 1.0)
            order.pace = scene_.world.parameters().character.maxSpeed * act.haste;
        std::string rest = act.to ? whereTo(spot) : "";
        if (act.form) rest += " in " + formWord(formations[k].kind);
        if (changesSpacing(act)) rest += ", " + numberText(formations[k].spacing) + " m apart";
        if (!act.via.empty()) rest += " by way of " + placesText(act.via);
        if (act.facing) rest += ", facing " + act.facing->words;
        if (act.freely) rest += ", each by a way of their own,";
        if (order.pace > 0.0) rest += " at " + numberText(order.pace) + " m/s";
        give(crew, std::move(order), act.then && fresh_);
        say(crew, "go", std::move(rest));
    }
}

void Planner::goToArea(const Act& act, All crews, const ThingSpot& area) {
    if (!does(act, "wait in an area", kTo | kTime)) return;
    for (const Crew& crew : crews) {
        give(crew, Order::wait(AreaId{area.id}, act.seconds), act.then && fresh_);
        say(crew, "wait",
            "in " + area.name + (act.seconds > 0 ? " for " + numberText(act.seconds) + " s" : ""));
    }
}

void Planner::face(const Act& act, All crews) {
    if (!does(act, "face", kStand)) return;
    for (const Crew& crew : crews) {
        const auto angle = facingOf(*act.facing, crew, whereIs(crew));
        if (!angle) return fail(crew.label + " is there already.");
        give(crew, Order::face(*angle), act.then && fresh_);
        say(crew, act.facing->turn ? "turn" : "face",
            (act.facing->away ? "away from " : "") + act.facing->words);
    }
}

void Planner::follow(const Act& act, All crews) {
    if (!does(act, "follow", kOthers)) return;
    if (act.others.empty()) return fail("Follow whom? Say the name of a group.");
    if (act.others.size() > 1) return fail("Follow which of them? Say the name of one group.");
    const GroupId leader = act.others.front();
    const Crew ahead = crews_.whole(leader);
    double behind = extentOf(ahead.formation, ahead.count()).rear + kFollowGap;
    bool any = false;
    for (const Crew& crew : crews) {
        if (crew.address == leader) continue;
        const Extent own = extentOf(crew.formation, crew.count());
        give(crew, Order::follow(leader, {-behind - own.front, 0.0}), act.then && fresh_);
        say(crew, "follow", ahead.label);
        behind += own.front + own.rear + kFollowGap;
        any = true;
    }
    if (!any) fail("A group cannot follow itself.");
}

void Planner::guard(const Act& act, All crews) {
    if (!does(act, "guard", kTo)) return;
    if (!act.to) return fail("Guard what? Say the name of a thing or a group.");
    const Spot& spot = *act.to;
    for (const Crew& crew : crews) {
        Order order = Order::guard(pointOf(spot, scene_.world, crew), {kGuardHalf, kGuardHalf}, 0.0);
        if (spot.kind == SpotKind::Thing) order.halfSize = halfSizeOf(nearestOf(spot.things, crew.middle));
        if (spot.kind == SpotKind::Group) {
            if (spot.group == crew.address) return fail("A group cannot guard itself.");
            const Crew other = crews_.whole(spot.group);
            const Extent extent = extentOf(other.formation, other.count());
            order.group = spot.group;
            order.halfSize = {std::max(extent.front, extent.rear) + kGuardGap, extent.side + kGuardGap};
        }
        give(crew, std::move(order), act.then && fresh_);
        say(crew, "guard", spot.words.empty() ? "that point" : spot.words);
    }
}

void Planner::leave(const Act& act, All crews) {
    if (!does(act, "leave", kTo)) return;
    const std::vector<ThingSpot> exits = names_.areas(AreaKind::Exit);
    if (exits.empty()) return fail("There is no exit here to leave by.");
    std::vector<AreaId> by;
    std::string words = "by the quickest exit";
    if (act.to && act.to->kind == SpotKind::Thing && act.to->things.front().kind == NamedKind::Area) {
        const ThingSpot& exit = act.to->things.front();
        if (exit.area != AreaKind::Exit) return fail(exit.name + " is no exit.");
        if (act.to->words == exit.name) by = {AreaId{exit.id}}, words = "by " + exit.name;
    } else if (act.to) {
        return fail("They can leave by an exit only, as “" + exits.front().name + "”.");
    }
    for (const Crew& crew : crews) {
        give(crew, Order::leave(by), act.then && fresh_);
        say(crew, "leave", words);
    }
}

void Planner::walk(const Act& act, All crews) {
    if (act.to && (act.to->kind != SpotKind::Shift || act.to->metres)) return move(act, crews);
    if (!does(act, "keep walking", kTo)) return;
    for (const Crew& crew : crews) {
        double angle = crew.heading();
        std::string words = "where it faces";
        if (act.to && act.to->kind == SpotKind::Shift) {
            const Vec2 d = directionOf(act.to->heading, crew.front);
            angle = arcTangent2(d.y, d.x);
            words = std::string(nameOf(act.to->heading));
        }
        give(crew, Order::walk(angle), act.then && fresh_);
        say(crew, "walk", "on " + words + " without end");
    }
}

void Planner::patrol(const Act& act, All crews) {
    if (!doesNow(act, "patrol", act.via.empty() ? kTo : kVia)) return;
    if (act.via.empty()) {
        if (act.to) return fail("Say two places: “patrol between ... and ...”.");
        return queue(act, QueueEdit::Patrol, crews, "patrol", "along the orders");
    }
    for (const Crew& crew : crews) {
        Crew walker = crew;
        std::vector<Vec2> corners;
        std::string words = placesText(act.via);
        for (const Spot& spot : act.via) {
            const Stand stand = standsAt(spot, scene_.world, {walker}, {crew.formation}).front();
            corners.push_back(stand.target);
            walker.middle = stand.target;
        }
        if (corners.size() == 1) corners.push_back(whereIs(crew)), words += " and here";
        for (const Vec2 corner : corners) give(crew, Order::move(corner), false);
        commandsFor(crew).push_back(EditQueue{crew.address, QueueEdit::Patrol, {}});
        say(crew, "patrol", "between " + words);
    }
}

void Planner::swap(const Act& act, All crews) {
    if (!does(act, "swap", kOthers)) return;
    std::vector<Crew> pair = crews;
    for (const GroupId other : act.others) pair.push_back(crews_.whole(other));
    if (pair.size() != 2) return fail("Two groups can change places: say “North and South swap places”.");
    for (std::size_t k = 0; k < 2; ++k) {
        give(pair[k], Order::move(pair[1 - k].middle, pair[k].heading()), act.then && fresh_);
        say(pair[k], "go", "to where " + pair[1 - k].label + " stands");
    }
}

}  // namespace muster::words
