#include "studio/words/planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/world/inspect.h"
#include "muster/views.h"

namespace muster::words {
namespace {

constexpr const char* kNothingToDo = "What are they to do? Say it like “North go to the middle”.";

bool isOrder(Verb verb) {
    return verb == Verb::Move || verb == Verb::None;
}

/// How somebody stands at the end of a way belongs to the order to go there.
std::vector<Act> folded(const std::vector<Act>& acts) {
    std::vector<Act> all;
    for (const Act& act : acts) {
        const bool leads = isOrder(act.verb) && partsOf(act) == kNone;
        if (leads && &act != &acts.back()) continue;  // “Take them and put them there” is one order.
        Act* const before = all.empty() ? nullptr : &all.back();
        const bool goes = before != nullptr && before->to &&
                          (isOrder(before->verb) || before->verb == Verb::Form);
        const bool stays = act.verb == Verb::Hold || act.verb == Verb::Stop ||
                           (act.verb == Verb::Wait && !act.to);
        if (goes && stays && partsOf(act) == kNone) continue;
        const bool stands = act.verb == Verb::Face || act.verb == Verb::Form || act.verb == Verb::Space;
        const unsigned said = partsOf(act);
        const bool first = before != nullptr && (said & partsOf(*before)) == kNone;
        if (goes && !act.then && stands && (said & ~kStand) == kNone && first) {
            if (act.facing) before->facing = act.facing;
            if (act.form) before->form = act.form, before->files = act.files;
            if (act.spacing) before->spacing = act.spacing;
            before->spread *= act.spread;
            continue;
        }
        all.push_back(act);
    }
    return all;
}

std::string withS(const std::string& verb) {
    const bool es = verb.ends_with("o") || verb.ends_with("sh") || verb.ends_with("ch") ||
                    verb.ends_with("ss");
    return verb + (es ? "es" : "s");
}

std::string listed(const std::vector<std::string>& all) {
    std::string text;
    for (std::size_t k = 0; k < all.size(); ++k)
        text += (k == 0 ? "" : k + 1 == all.size() ? " and " : ", ") + all[k];
    return text;
}

}  // namespace

std::string formWord(FormationKind kind) {
    switch (kind) {
        case FormationKind::Square:
            return "a square";
        case FormationKind::Line:
            return "a line";
        case FormationKind::Column:
            return "a column";
        case FormationKind::Wedge:
            return "a wedge";
        case FormationKind::Ring:
            return "a ring";
        case FormationKind::Circle:
            return "a circle";
        case FormationKind::Crescent:
            return "a crescent";
        case FormationKind::Pacman:
            return "a disc with a mouth";
        default:
            return "their shape";
    }
}

std::string numberText(double value) {
    const auto tenths = static_cast<std::int64_t>(std::floor(std::fabs(value) * 10.0 + 0.5));
    std::string text = value < 0.0 && tenths > 0 ? "-" : "";
    text += std::to_string(tenths / 10);
    if (tenths % 10 != 0) text += "." + std::to_string(tenths % 10);
    return text;
}

Understood Planner::plan(const std::vector<Clause>& clauses) {
    for (const Clause& clause : clauses) {
        planClause(clause);
        if (!result_.problem.empty()) break;
    }
    finish();
    if (result_.problem.empty() && result_.sentences.empty()) result_.problem = kNothingToDo;
    return std::move(result_);
}

void Planner::fail(std::string problem) {
    if (result_.problem.empty()) result_.problem = std::move(problem);
}

bool Planner::planDeed(const Clause& clause) {
    if (clause.who || clause.acts.size() != 1) return false;
    const Act& act = clause.acts.front();
    const auto deed = [&](WordsDeed done, const char* sentence) {
        if (!doesNow(act, "this", kNone)) return true;
        result_.deed = done;
        result_.sentences.emplace_back(sentence);
        return true;
    };
    switch (act.verb) {
        case Verb::Play:
            return deed(WordsDeed::Play, "The world goes on.");
        case Verb::Pause:
            return deed(WordsDeed::Pause, "The world pauses.");
        case Verb::Restart:
            return deed(WordsDeed::Restart, "Everything begins again.");
        case Verb::Undo:
            return deed(WordsDeed::Undo, "What you did last is taken back.");
        case Verb::Redo:
            return deed(WordsDeed::Redo, "What you took back is done again.");
        case Verb::Pace: {
            const double speed = act.number.value_or(1.0);
            if (!doesNow(act, "speed", kNumber)) return true;
            if (speed < 0.1 || speed > 8.0) return fail("Say a speed of 0.1 to 8."), true;
            result_.speed = speed;
            result_.sentences.push_back("Time goes " + numberText(speed) + " times as fast as in life.");
            return true;
        }
        default:
            return false;
    }
}

/// Towards which of its spots the people of a part are chosen.
const Spot* Planner::nearOf(const std::vector<Act>& acts) const {
    for (const Act& act : acts) {
        if (act.to && act.to->kind != SpotKind::Shift) return &*act.to;
        if (!act.via.empty()) return &act.via.front();
    }
    return nullptr;
}

void Planner::planClause(const Clause& clause) {
    if (planDeed(clause)) return;
    if (clause.acts.empty()) return fail(kNothingToDo);
    const std::vector<Act> acts = folded(clause.acts);
    const Spot* near = clause.who && clause.who->nearest ? &*clause.who->nearest : nearOf(acts);
    Vec2 point;
    if (near != nullptr && scene_.world.groupCount() > 0) {
        GroupId seen = scene_.world.group(0).id;
        if (clause.who && !clause.who->groups.empty()) seen = clause.who->groups.front();
        if (!inspect::indexOfGroup(scene_.world, seen)) return fail("That group is gone.");
        point = pointOf(*near, scene_.world, crews_.whole(seen));
    }
    const Result<std::vector<Crew>> crews = crews_.of(clause.who, near != nullptr ? &point : nullptr);
    if (!crews.ok()) return fail(crews.status().message());
    fresh_ = true;
    for (const Act& act : acts) {
        planAct(act, *crews);
        if (!result_.problem.empty()) return;
        fresh_ = false;
    }
}

void Planner::planAct(const Act& act, All crews) {
    switch (act.verb) {
        case Verb::None:
        case Verb::Move:
        case Verb::Face:
        case Verb::Cross:
        case Verb::Form:
        case Verb::Space:
            return move(act, crews);
        case Verb::Follow:
            return follow(act, crews);
        case Verb::Guard:
            return guard(act, crews);
        case Verb::Leave:
            return leave(act, crews);
        case Verb::Wait:
            return act.to ? move(act, crews) : queue(act, QueueEdit::Hold, crews, "hold", "");
        case Verb::Walk:
            return walk(act, crews);
        case Verb::Stop:
            return queue(act, QueueEdit::Stop, crews, "stop", "");
        case Verb::Hold:
            return queue(act, QueueEdit::Hold, crews, "hold", "");
        case Verb::Resume:
            return queue(act, QueueEdit::Resume, crews, "go", "on");
        case Verb::Patrol:
            return patrol(act, crews);
        case Verb::EndPatrol:
            return queue(act, QueueEdit::EndPatrol, crews, "end", "the patrol");
        case Verb::Split:
            return split(act, crews);
        case Verb::Merge:
            return merge(act, crews);
        case Verb::Swap:
            return swap(act, crews);
        case Verb::Name:
            return rename(act, crews);
        case Verb::Colour:
            return colour(act, crews);
        case Verb::Faster:
            return hurry(act, 4.0 / 3.0, crews);
        case Verb::Slower:
            return hurry(act, 0.75, crews);
        case Verb::Add:
            return add(act, crews);
        case Verb::Reverse:
            return reverse(act, crews);
        case Verb::Skip:
            return skip(act, crews);
        default:
            return fail("Say that in a sentence of its own.");
    }
}

FormationDef Planner::formationOf(const Act& act, const Crew& crew) const {
    FormationDef formation = crew.formation;
    const bool own = formation.kind == FormationKind::Points || formation.kind == FormationKind::Outline;
    if (act.form) {
        const bool circle = *act.form == FormationKind::Circle;
        const bool ring = circle && act.to && act.to->beside == Beside::Around;
        formation = {.kind = ring ? FormationKind::Ring : *act.form, .spacing = formation.spacing};
        formation.files = act.files;
    } else if (own && !crew.whole) {
        formation = {.kind = FormationKind::Square, .spacing = formation.spacing};
    } else if (act.to && act.to->beside == Beside::Around && !changesShape(act)) {
        formation = {.kind = FormationKind::Ring, .spacing = formation.spacing};
    }
    const double factor = act.spacing ? *act.spacing / std::max(0.05, formation.spacing) : act.spread;
    formation.spacing = std::clamp(formation.spacing * factor, 0.3, 20.0);
    if (formation.kind == FormationKind::Points)
        for (Vec2& point : formation.points) point = point * factor;
    return formation;
}

std::vector<CommandBody>& Planner::commandsFor(const Crew& crew) {
    return crew.whole ? orders_ : result_.followers;
}

void Planner::say(const Crew& crew, const char* verb, std::string rest) {
    const bool several = !crew.whole && crew.count() > 1;
    for (Saying& saying : sayings_)
        if (saying.verb == verb && saying.rest == rest) {
            saying.who.push_back(crew.label);
            saying.several = true;
            return;
        }
    sayings_.push_back({{crew.label}, several, verb, std::move(rest)});
}

void Planner::finish() {
    for (const Saying& saying : sayings_) {
        std::string text = listed(saying.who) + " " + (saying.several ? saying.verb : withS(saying.verb)) +
                           (saying.rest.empty() ? "" : " " + saying.rest) + ".";
        if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
        result_.sentences.push_back(std::move(text));
    }
    result_.commands.insert(result_.commands.end(), crews_.splits().begin(), crews_.splits().end());
    result_.commands.insert(result_.commands.end(), orders_.begin(), orders_.end());
    result_.parts = crews_.parts();
}

}  // namespace muster::words
