// The fast plan: near-optimal assignment at a cost that grows about linearly with the crowd (SPEC B1).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/assignment/planning/fast/first_plan.h"
#include "engine/assignment/planning/fast/geodesic_cost_oracle.h"
#include "engine/assignment/planning/fast/place_matching.h"
#include "engine/assignment/planning/plan.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/fields/geodesics/geodesics.h"

namespace muster {

/// advance() evaluates the guidance of all characters to their incumbent places, which guide() returns;
/// workInBackground() updates the assignment; finish() does the rest of both.
class FastPlan final : public Plan {
public:
    const char* name() const override { return "fast"; }
    void reserve(std::size_t characters, std::size_t places, PlanCosts& costs) override;
    std::int32_t shares(std::int32_t) const override { return 1; }
    Status start(const PlanDef& def, const PlanInput& input) override;
    bool pending() const override { return pending_; }
    void advance(std::int32_t share, std::int32_t shares, ThreadPool& pool) override;
    Status finish(ThreadPool& pool, PlanResult& result) override;
    bool worksInBackground() const override { return true; }
    void workInBackground() override;
    void guide(const GuidanceInput& input, ThreadPool& pool, std::span<Vec2> direction,
               std::span<double> cost) override;
    std::int32_t waitingPlace(std::int32_t character) const override;
    double costAt(std::int32_t place, Vec2 p) const override;
    void forget() override;
    bool starting() const override { return assignment_.starting(); }
    void save(Writer& archive) const override;
    bool load(Reader& archive, ThreadPool& pool) override;
    void keepFieldsOf(Plan& before) override;
    void bind(PlanCosts& costs) override;
    bool suits(std::size_t characters, std::size_t places, const Grid& grid) const override;
    void hash(Hasher& archive) const override;

private:
    template <class Self, class Archive>
    static void visit(Self& self, Archive& archive) {
        archive(self.def_, self.characters_, self.places_, self.usable_, self.incumbent_, self.connected_,
                self.slowness_, self.characterClass_, self.placeClass_, self.incumbentCost_, self.guidance_,
                self.guidedPlace_, self.guidanceRound_, self.pending_, self.assigned_, self.assignment_,
                self.targets_, self.waitingPlace_, self.waitingCursor_, self.everFinished_, self.first_,
                self.known_, self.records_, self.edits_);
    }
    bool consistent() const;
    PlannedWays ways() const { return {way_, reach_, onward_}; }
    bool flowsConsistent() const;
    bool guidanceConsistent() const;
    void updateGeodesics(ThreadPool& pool, PlanCosts& costs, std::span<const Vec2> characters,
                         std::span<const Vec2> places);
    void evaluateGuidance(ThreadPool& pool);
    void evaluateGuidanceOf(std::size_t character);
    double groundCost(Vec2 p) const;
    void keepRecord(std::size_t character, Vec2 direction);
    void recordChanges();
    void assign(ThreadPool& pool);
    void prepareFirst(ThreadPool& pool);
    void updateAssignment(ThreadPool& pool);
    void takeAmounts(const PlanInput& input);
    MatchingProblem problemOf(const DynamicAssignmentDef& def, const AssignmentInput& input) const;
    std::span<const std::int32_t> placeOf() const;
    void report(PlanResult& result) const;
    void findWaitingPlaces();
    std::int32_t nearestUsablePlace(Vec2 p) const;
    bool incumbentsAreAssigned() const;
    DynamicAssignmentDef assignmentDef(std::size_t characters) const;

    PlanDef def_;
    std::vector<Vec2> characters_;         // Positions of the characters [m].
    std::vector<Vec2> places_;             // Positions of the places [m].
    std::vector<std::uint8_t> usable_;     // 0 per place that nobody may take; empty for all.
    std::vector<std::int32_t> incumbent_;  // Incumbent per character, -1 for none.
    std::vector<std::uint8_t> connected_;  // Per character, as in PlanInput.
    std::vector<float> slowness_;          // Per character, as in PlanInput.
    // Classes as in PlanInput.
    std::vector<std::uint8_t> characterClass_, placeClass_;
    std::vector<std::int32_t> way_;  // The ways of PlannedWays, of this step only.
    std::vector<float> reach_, onward_;
    std::vector<float> reluctance_;  // Per character, in this step only.
    std::vector<Vec2> moved_;        // Movement per character since the last plan, in this step only [m].
    // Amounts as in PlanInput, in this step only; both empty where all flows are of one unit.
    std::vector<double> supply_, demand_;
    // The least remaining cost of a character to its place.
    struct Record {
        Vec2 at;                   // Position of the place [m].
        float cost = 0.0f;         // Least remaining cost [m].
        std::int32_t place = -1;   // Index of the place, -1 for none.
        std::uint32_t edits = 0;   // Version of the ground of the record.
        std::int32_t changes = 0;  // Number of changes of its place since places last moved.

        template <class Archive>
        void visit(Archive& archive) {
            archive(at, cost, place, edits, changes);
        }
    };
    std::uint32_t edits_ = 0;           // Version of the ground.
    std::vector<float> known_;          // Per character: exact cost to its place [m]; below 0 where unknown.
    std::vector<Record> records_;       // Records per character.
    std::vector<float> incumbentCost_;  // Per character: cost to its incumbent place [m].
    std::vector<Guidance> guidance_;    // Per character, to guidedPlace_.
    std::vector<std::int32_t> guidedPlace_;  // Per character: its incumbent when its guidance was evaluated.
    std::uint32_t guidanceRound_ = 0;        // Number of evaluations.
    bool pending_ = false;
    bool guided_ = false;  // True once the guidance of the pending plan is evaluated.
    // True once the assignment of the pending plan is done. Background work writes this; other threads read
    // it after it has ended.
    bool assigned_ = false;
    bool everFinished_ = false;
    FirstPlan first_;
    PlaceMatching assignment_;
    Geodesics geodesics_;
    std::vector<SteeringTarget> targets_;     // Targets per character.
    std::vector<std::int32_t> waitingPlace_;  // Waiting place per character, -1 for none.
    std::uint32_t waitingCursor_ = 0;  // The character with which the next search for waiting places begins.
    // Points of this step only.
    std::vector<Vec2> prefetchPoints_;
    const StaticGround* ground_ = nullptr;
    PlanCosts* planCosts_ = nullptr;
    bool geodesicsUpdated_ = false;  // True once they have this step's places.
    GeodesicCostOracle costs_;
    ThreadPool backgroundPool_;  // A pool of one thread.
    /// The cost field of one place on the static ground, for pictures.
    struct PictureField {
        Vec2 place;                // Position of the place [m].
        std::uint32_t ground = 0;  // Version of the ground.
        CostField field;
        std::optional<EikonalSolver> solver;  // Solver, made when it is first asked for.
    };
    mutable PictureField picture_;
};

}  // namespace muster
