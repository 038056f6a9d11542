// One plan's frozen inputs, and the fields made of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.h"
#include "base/parallel.h"
#include "eikonal/eikonal_solver.h"
#include "planning/exact/ground_regions.h"
#include "planning/plan.h"

namespace muster {

/// Private working memory of a thread that solves fields.
struct FieldWorker {
    EikonalSolver solver;
    std::vector<Vec2> targets;
};

/// Refuses what start() must refuse.
Status checkPlan(const PlanDef& def, const PlanInput& input);

/// Inputs as they stood at start(), how many fields are solved, and as a cache of these the fields
/// themselves.
class PlanGeneration {
public:
    /// Copies the input (checked before). Fronts that had to go on in `former` do so from the start for some
    /// plans.
    void freeze(const PlanDef& def, const PlanInput& input, const PlanGeneration& former);
    /// Empties it, keeping memory.
    void clear() { valid_ = false; }
    /// Solves the fields of places [solved(), end).
    void solve(std::int32_t end, ThreadPool& pool, std::vector<FieldWorker>& workers);

    /// True where it is empty, or for so many characters and places on this ground.
    bool suits(std::size_t characters, std::size_t places, const Grid& grid) const {
        return !valid_ ||
               (characters_.size() == characters && places_.size() == places && cost_.grid == grid);
    }
    bool valid() const { return valid_; }        ///< Holds frozen inputs.
    const PlanDef& def() const { return def_; }  ///< As frozen.
    /// Number of them.
    std::int32_t characters() const { return static_cast<std::int32_t>(characters_.size()); }
    /// Number of them.
    std::int32_t places() const { return static_cast<std::int32_t>(places_.size()); }
    std::int32_t solved() const { return solved_; }             ///< Places whose fields are done.
    const UnitCost& cost() const { return cost_; }              ///< As frozen.
    std::span<const double> supply() const { return supply_; }  ///< Empty for 1 each.
    /// >= 0
    double supplyOf(std::int32_t character) const { return supply_.empty() ? 1.0 : supply_[character]; }
    /// What a place can take: 0 where nobody may take it.
    double demandOf(std::int32_t place) const {
        return usable(place) ? (demand_.empty() ? 1.0 : demand_[place]) : 0.0;
    }
    /// May be taken.
    bool usable(std::int32_t place) const { return usable_.empty() || usable_[place] != 0; }
    std::int32_t incumbent(std::int32_t character) const { return incumbent_[character]; }  ///< -1 for none.
    /// The field of a place, or null where none was needed or it is not solved yet.
    const CostField* field(std::int32_t place) const;
    /// The nearest place that somebody can take on the ground of a character that holds none; -1 for all
    /// others. It waits there while it stays unmatched.
    std::int32_t waitingPlace(std::int32_t character) const { return waits_[character]; }
    /// True where the place's front goes on until it meets the character, so that the pair's cost is known.
    bool met(std::int32_t character, std::int32_t place) const;
    /// Cost from a character to a place, infinite where there is no way; a lower bound where the front did
    /// not go so far.
    double pairCost(std::int32_t character, std::int32_t place) const;
    /// Solves the fields of these places anew, until all characters are met.
    void widen(std::span<const std::int32_t> places, ThreadPool& pool, std::vector<FieldWorker>& workers);

    /// Writes frozen inputs and progress.
    void save(Writer& archive) const;
    /// Reads what save() wrote; the fields must be solved again up to progress(). False where it does not
    /// fit.
    bool load(Reader& archive, std::int32_t& progress);
    /// Adds frozen inputs and progress, less the cells of the unit cost.
    void hash(Hasher& archive) const;

private:
    void prepare();
    bool holds(std::int32_t character) const;
    void setWaiting();
    void setReach();
    void setWide(const PlanGeneration& former);
    void solveOne(std::int32_t place, FieldWorker& worker);
    template <class Self, class Archive>
    static void visitInputs(Self& self, Archive& archive);

    bool valid_ = false;
    PlanDef def_;
    std::vector<Vec2> characters_;
    std::vector<double> supply_;
    std::vector<Vec2> places_;
    std::vector<double> demand_;
    std::vector<std::uint8_t> usable_;
    std::vector<std::int32_t> incumbent_;
    UnitCost cost_;
    std::int32_t solved_ = 0;
    std::vector<std::uint8_t> wide_;  // Per place: its front goes to all characters, for so many plans yet.
    // Caches.
    std::vector<std::int32_t> waits_;  // Per character: where it waits if it stays unmatched.
    std::vector<double> reach_;        // Per place: its front goes to characters this near [m].
    GroundRegions regions_;
    std::vector<Vec2> standing_;  // Characters, off the walls that contacts may press them into.
    std::vector<std::int32_t> characterRegion_;
    std::vector<std::int32_t> placeRegion_;
    std::vector<CostField> fields_;
    std::vector<std::uint8_t> known_;
};

/// Finds the reached cell nearest to `p` within a few cells; false where there is none.
bool nearestReached(const CostField& field, const Grid& grid, Vec2 p, Cell& found);

}  // namespace muster
