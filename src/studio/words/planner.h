// From clauses to commands, with a sentence for each group.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "studio/words/crews.h"
#include "studio/words/stands.h"

namespace muster::words {

class Planner {
public:
    Planner(const WordsScene& scene, const KnownNames& names)
        : scene_(scene), names_(names), crews_(scene, names) {}

    /// Plans all clauses; the problem of the first that cannot be.
    Understood plan(const std::vector<Clause>& clauses);

private:
    using All = const std::vector<Crew>&;

    // One clause (planner.cpp).
    void planClause(const Clause& clause);
    void planAct(const Act& act, All crews);
    bool planDeed(const Clause& clause);
    const Spot* nearOf(const std::vector<Act>& acts) const;
    void fail(std::string problem);
    /// False, with a problem, where an act says what its verb does not do; also where it is to be later.
    bool does(const Act& act, const char* verb, unsigned parts);
    bool doesNow(const Act& act, const char* verb, unsigned parts);

    // Orders (plan_orders.cpp).
    void move(const Act& act, All crews);
    void moveTo(const Act& act, All crews, const Spot& spot);
    void goToArea(const Act& act, All crews, const ThingSpot& area);
    void face(const Act& act, All crews);
    void follow(const Act& act, All crews);
    void guard(const Act& act, All crews);
    void leave(const Act& act, All crews);
    void patrol(const Act& act, All crews);
    void walk(const Act& act, All crews);
    void swap(const Act& act, All crews);
    void give(const Crew& crew, Order order, bool then);
    std::vector<Vec2> routeOf(const Act& act, const Crew& crew, Vec2 target) const;
    std::optional<double> facingOf(const Facing& facing, const Crew& crew, Vec2 from) const;
    Vec2 whereIs(const Crew& crew) const;

    // Other changes (plan_changes.cpp).
    void queue(const Act& act, QueueEdit edit, All crews, const char* verb, const char* rest);
    void reverse(const Act& act, All crews);
    /// Gives a crew the formation that is wanted, which it returns.
    FormationDef reshape(const Act& act, const Crew& crew);
    void form(const Act& act, All crews);
    void formLater(const Act& act, All crews);
    void split(const Act& act, All crews);
    void merge(const Act& act, All crews);
    void rename(const Act& act, All crews);
    void colour(const Act& act, All crews);
    void hurry(const Act& act, double factor, All crews);
    void add(const Act& act, All crews);
    void skip(const Act& act, All crews);

    FormationDef formationOf(const Act& act, const Crew& crew) const;
    bool changesSpacing(const Act& act) const { return act.spacing || act.spread != 1.0; }
    bool changesShape(const Act& act) const { return act.form || changesSpacing(act); }
    /// Commands about a part follow once it is a group.
    std::vector<CommandBody>& commandsFor(const Crew& crew);
    void say(const Crew& crew, const char* verb, std::string rest);
    void finish();

    const WordsScene& scene_;
    const KnownNames& names_;
    Crews crews_;
    Understood result_;
    std::vector<CommandBody> orders_;  // Of groups that stay what they are.
    std::map<GroupId, Vec2> bound_;    // Where crews will be after their orders so far.
    std::set<GroupId> ordered_;        // To whom orders were given.
    bool fresh_ = true;                // The act is the first of its clause.

    /// What is said of a crew; those of whom the same is said share a sentence.
    struct Saying {
        std::vector<std::string> who;
        bool several = false;
        std::string verb;
        std::string rest;
    };
    std::vector<Saying> sayings_;
};

/// "square", "ring" as people call a shape.
std::string formWord(FormationKind kind);
/// A number with at most one digit behind the point.
std::string numberText(double value);

}  // namespace muster::words
