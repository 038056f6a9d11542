// The fast plan: near-optimal places at a cost that hardly grows with the crowd (SPEC B1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dynamic/dynamic_assignment.h"
#include "eikonal/eikonal_solver.h"
#include "geodesics/geodesics.h"
#include "planning/fast/fast_costs.h"
#include "planning/plan.h"

namespace muster {

/// From the positions given to start() advance() works out the costs and ways of all to their own places,
/// which guide() uses, and workInBackground() the matching; finish() does what of these is left.
class FastPlan final : public Plan {
public:
    const char* name() const override { return "fast"; }
    bool readsUnitCost() const override { return false; }
    void reserve(std::size_t characters, std::size_t places, const StaticGround& ground) override;
    Status start(const PlanDef& def, const PlanInput& input) override;
    bool pending() const override { return pending_; }
    void advance(std::int32_t slice, std::int32_t slices, ThreadPool& pool) override;
    Status finish(ThreadPool& pool, PlanResult& result) override;
    bool worksInBackground() const override { return true; }
    void workInBackground() override;
    void guide(const GuidanceInput& input, ThreadPool& pool, std::span<Vec2> direction,
               std::span<double> cost) override;
    std::int32_t waitingPlace(std::int32_t character) const override;
    double costAt(std::int32_t place, Vec2 p) const override;
    void save(Writer& archive) const override;
    bool load(Reader& archive, ThreadPool& pool) override;
    bool suits(std::size_t characters, std::size_t places, const Grid& grid) const override;
    void hash(Hasher& archive) const override;

private:
    template <class Archive>
    void visit(Archive& archive) {
        archive(def_, characters_, places_, usable_, incumbent_, present_, own_, way_, ownPlace_, round_,
                pending_, matched_, assignment_, walkers_, waiting_, turn_, planned_);
    }
    bool consistent() const;
    bool consistentWays() const;
    void update(ThreadPool& pool, const StaticGround& ground, const DynamicCost& excess,
                std::span<const Vec2> places);
    void measureOwn(ThreadPool& pool);
    void match(ThreadPool& pool);
    void assign(ThreadPool& pool);
    void report(PlanResult& result) const;
    void seekWaitingPlaces();
    bool sameAsMatched() const;
    DynamicAssignmentDef assignmentDef(std::size_t characters) const;

    PlanDef def_;
    std::vector<Vec2> characters_;
    std::vector<Vec2> places_;
    std::vector<std::uint8_t> usable_;
    std::vector<std::int32_t> incumbent_;
    std::vector<std::uint8_t> present_;   // Per character: in the places' region.
    std::vector<float> own_;              // Per character: cost to its place.
    std::vector<Guidance> way_;           // Per character, to ownPlace_.
    std::vector<std::int32_t> ownPlace_;  // Its place when that was worked out.
    std::uint32_t round_ = 0;             // Of working it out.
    bool pending_ = false;
    // The pending plan knows the costs and ways of all to their own places.
    bool measured_ = false;
    // Its matching is done. Work aside writes this, others read it when that is over.
    bool matched_ = false;
    bool planned_ = false;  // A plan was finished.
    DynamicAssignment assignment_;
    Geodesics geodesics_;
    std::vector<SteeringTarget> walkers_;
    std::vector<std::int32_t> waiting_;  // Per character: place beside which it waits, -1.
    std::uint32_t turn_ = 0;             // Of the search for these.
    // Of this step only.
    const StaticGround* ground_ = nullptr;
    const DynamicCost* excess_ = nullptr;
    bool updated_ = false;  // The geodesics know this step's places.
    FastCosts costs_;
    ThreadPool alone_;  // For work aside, which has one thread.
    // For pictures: the field of one place on the still ground.
    struct Picture {
        Vec2 place;
        std::uint32_t ground = 0;
        CostField field;
        EikonalSolver solver;
    };
    mutable Picture picture_;
};

}  // namespace muster
