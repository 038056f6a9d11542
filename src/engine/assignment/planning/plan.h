// Plans: the assignment of characters to places, and the guidance towards them (SPEC A1-A3, A6).
#pragma once

#include <cstddef>
#include <memory>

#include "base/archive.h"
#include "engine/assignment/planning/assigner.h"
#include "engine/assignment/planning/navigator.h"

namespace muster {

/// A plan of one group: the assignment to places, and the guidance by the last finished assignment.
class Plan : public Assigner, public Navigator {
public:
    /// Name of the method: "exact" or "fast".
    virtual const char* name() const = 0;
    /// Allocates memory for a group of this size, so that its first plan need not. Must be called before the
    /// first start(); changes no result.
    virtual void reserve(std::size_t /*characters*/, std::size_t /*places*/, PlanCosts&) {}

    /// Forgets pending and finished assignments, because characters or places have other numbers now. Results
    /// that follow from the ground stay.
    virtual void forget() = 0;

    /// True while it goes on from places that it did not choose, after forget(); that takes some steps, and
    /// nobody changes places meanwhile.
    virtual bool starting() const { return false; }

    /// Writes all data that can influence later results: frozen inputs and progress, never the cost fields.
    virtual void save(Writer& archive) const = 0;
    /// Reads the data of save(), and solves the cost fields again. False where it does not fit.
    virtual bool load(Reader& archive, ThreadPool& pool) = 0;
    /// Takes over the fields of another plan of the same method that are still true. Call after load();
    /// changes no result. `before` becomes useless.
    virtual void keepFieldsOf(Plan& /*before*/) {}
    /// Sets the ground of the fields that load() named: that of the archive, before any edit. Call after
    /// load() and keepFieldsOf().
    virtual void bind(PlanCosts& /*costs*/) {}
    /// True where the pending and the last finished plan are for these numbers of characters and places on
    /// this ground.
    virtual bool suits(std::size_t characters, std::size_t places, const Grid& grid) const = 0;
    /// Adds the data of save() to a hash, except the cells of unit costs, which follow from the state that
    /// was hashed at the step of start().
    virtual void hash(Hasher& archive) const = 0;
};

/// The reference plan: one cost field per place, exact assignment (docs/method/exact-plan.md).
std::unique_ptr<Plan> makeExactPlan();
/// A plan of the same objective within a fraction of a percent, at a cost that grows about linearly with the
/// crowd: geodesics interpolated between landmark fields, and dynamic assignment on a sparse graph
/// (docs/method/fast-plan.md). Supplies and demands other than one unit each are solved by a network simplex
/// whose tree stays from step to step (docs/method/roles.md).
std::unique_ptr<Plan> makeFastPlan();

}  // namespace muster
