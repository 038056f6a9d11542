// The frozen inputs of one plan, and the cost fields solved from them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.h"
#include "base/parallel.h"
#include "engine/assignment/planning/exact/connected_regions.h"
#include "engine/assignment/planning/plan.h"
#include "engine/fields/eikonal/eikonal_solver.h"

namespace muster {

/// Working memory of a thread that solves cost fields.
struct FieldWorker {
    EikonalSolver solver;
    std::vector<Vec2> targets;  ///< Points that the front must reach [m].
};

/// Inputs as they stood at start() and the number of places whose fields are solved are state; the fields and
/// all values derived from the inputs are a cache.
class FrozenPlan {
public:
    /// Copies a valid input. Places whose fronts were unlimited in `former` remain so for some plans.
    void freeze(const PlanDef& def, const PlanInput& input, const UnitCost& cost, const FrozenPlan& former);
    /// Empties it, keeping memory.
    void clear() { valid_ = false; }
    /// Solves the fields of the places [solved(), end).
    void solve(std::int32_t end, ThreadPool& pool, std::vector<FieldWorker>& workers);

    /// True where it is empty, or for these numbers of characters and places on this ground.
    bool suits(std::size_t characters, std::size_t places, const Grid& grid) const {
        return !valid_ ||
               (characters_.size() == characters && places_.size() == places && unitCost_.grid == grid);
    }
    bool valid() const { return valid_; }        ///< True where it holds frozen inputs.
    const PlanDef& def() const { return def_; }  ///< The frozen definition.
    /// Number of characters.
    std::int32_t characters() const { return static_cast<std::int32_t>(characters_.size()); }
    /// Number of places.
    std::int32_t places() const { return static_cast<std::int32_t>(places_.size()); }
    const UnitCost& unitCost() const { return unitCost_; }      ///< The frozen unit cost.
    std::span<const double> supply() const { return supply_; }  ///< Supply per character; empty for 1 each.
    /// Supply of a character >= 0.
    double supplyOf(std::int32_t character) const { return supply_.empty() ? 1.0 : supply_[character]; }
    /// True where a character and a place are of one class, or there are no classes.
    bool inClass(std::int32_t character, std::int32_t place) const {
        return characterClass_.empty() || characterClass_[character] == placeClass_[place];
    }
    bool hasClasses() const { return !characterClass_.empty(); }  ///< True where there are classes.
    /// Demand of a place >= 0; 0 where it is not usable.
    double demandOf(std::int32_t place) const {
        return usable(place) ? (demand_.empty() ? 1.0 : demand_[place]) : 0.0;
    }
    /// True where a character may take the place.
    bool usable(std::int32_t place) const { return usable_.empty() || usable_[place] != 0; }
    /// Incumbent place of a character, -1 for none.
    std::int32_t incumbent(std::int32_t character) const { return incumbent_[character]; }
    /// Incumbent places of all characters.
    std::span<const std::int32_t> incumbents() const { return incumbent_; }
    /// The cost field of a place, or null where none was needed or it is not solved yet.
    const CostField* field(std::int32_t place) const;
    /// The nearest usable place in the region of a character without a place, near which it waits while it
    /// stays unmatched; -1 for all other characters.
    std::int32_t waitingPlace(std::int32_t character) const { return waitingPlace_[character]; }
    /// True where the front of the place must reach the character, so that the pair's cost is exact.
    bool isTarget(std::int32_t character, std::int32_t place) const;
    /// Cost from a character to a place [m]: infinite where there is no path, a lower bound where the
    /// character is no target of the place's front.
    double pairCost(std::int32_t character, std::int32_t place) const;
    /// Solves the fields of these places again with unlimited fronts: to all characters of their regions.
    void solveUnlimited(std::span<const std::int32_t> places, ThreadPool& pool,
                        std::vector<FieldWorker>& workers);

    /// Writes the frozen inputs and the progress.
    void save(Writer& archive) const;
    /// Reads the data of save(); the fields must be solved again up to `progress`. False where it does not
    /// fit.
    bool load(Reader& archive, std::int32_t& progress);
    /// Adds frozen inputs and progress, except the cells of the unit cost.
    void hash(Hasher& archive) const;

private:
    void derive();
    bool holdsIncumbent(std::int32_t character) const;
    void findWaitingPlaces();
    void setFrontRadii();
    void inheritUnlimited(const FrozenPlan& former);
    void solveField(std::int32_t place, FieldWorker& worker);
    template <class Self, class Archive>
    static void visitInputs(Self& self, Archive& archive);

    bool valid_ = false;
    PlanDef def_;
    std::vector<Vec2> characters_;         // Positions of the characters [m].
    std::vector<double> supply_;           // Supply per character; empty for 1 each.
    std::vector<Vec2> places_;             // Positions of the places [m].
    std::vector<double> demand_;           // Demand per place; empty for 1 each.
    std::vector<std::uint8_t> usable_;     // 0 per place that nobody may take; empty for all.
    std::vector<std::int32_t> incumbent_;  // Incumbent per character, -1 for none.
    std::vector<float> known_;             // Per character, as in PlanInput; empty for none [m].
    std::vector<float> slowness_;          // Per character, as in PlanInput; empty for all 1.
    std::vector<std::uint8_t> characterClass_, placeClass_;  // Classes as in PlanInput.
    UnitCost unitCost_;
    std::int32_t solved_ = 0;              // Places whose fields are done.
    std::vector<std::uint8_t> unlimited_;  // Per place: plans for which its front remains unlimited.
    // Derived from these.
    std::vector<std::int32_t> waitingPlace_;  // Per character, -1 for none.
    std::vector<double> frontRadius_;         // Per place: its front goes to characters this near [m].
    ConnectedRegions regions_;
    // Per character: its position, off walls that contacts may press it into [m].
    std::vector<Vec2> freePoint_;
    std::vector<std::int32_t> characterRegion_;
    std::vector<std::int32_t> placeRegion_;
    // Fields per place; fields beyond the number of places keep their memory.
    std::vector<CostField> fields_;
    std::vector<std::uint8_t> fieldKnown_;  // 1 per place whose field is known.
};

/// Finds the reached cell nearest to `p` within a few cells; false where there is none.
bool nearestReached(const CostField& field, const Grid& grid, Vec2 p, Cell& found);

}  // namespace muster
