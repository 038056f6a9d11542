// Costs to places, read from the local fields of landmarks round them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/fields/cost/dynamic_cost.h"
#include "engine/fields/cost/static_ground.h"
#include "engine/fields/geodesics/field_requests.h"
#include "engine/fields/geodesics/local_fields.h"

namespace muster {

/// The local fields on one level of the ground, and for each requested place the landmarks from which its
/// cost is read. Queries are const and may run in several threads; they add requests for missing fields to
/// buffers, which the update phase of the next step drains.
class LocalCosts {
public:
    explicit LocalCosts(const LocalFieldsDef& def) : fields_(def) {}  ///< Has no fields yet.

    /// Begins a step with these places on a level of the static ground. All must outlive the next call.
    void beginStep(const StaticGround& ground, const GroundLevel& level, const DynamicCost& dynamicCost,
                   std::span<const Vec2> places);
    /// Solves at most `most` of the requested fields; returns their number.
    std::int32_t solveRequested(std::int32_t most, ThreadPool& pool) {
        return fields_.solveRequested(most, pool);
    }
    /// Takes over the fields of `before` that an archive named. Call after reading it.
    void keepFieldsOf(LocalCosts& before) { fields_.keepFieldsOf(before.fields_); }
    /// Solves the fields that an archive named and keepFieldsOf() did not bring.
    void solveMissing(ThreadPool& pool) { fields_.solveMissing(pool); }
    /// Finds the landmarks of the requested places, and requests missing fields. `countsAsStep` ages the
    /// requests of places.
    void updateLandmarks(bool countsAsStep);

    /// True where `from` lies in the local fields of a place, if there are any.
    bool covers(Vec2 from, std::int32_t place) const;
    /// Requests the local fields of a place for some steps. Places whose assignee asks come first. May be
    /// called from several threads.
    void request(std::int32_t place, bool byAssignee) const;
    /// True where the request of a place has not expired.
    bool requested(std::int32_t place) const { return requests_.active(place); }
    /// True where there are local fields for the place.
    bool known(std::int32_t place) const { return visible_[place].count > 0; }
    /// Cost with the dynamic cost along the path [m]; infinite where the local fields do not know. `line` is
    /// the straight distance [m].
    double cost(Vec2 from, std::int32_t place, double line) const;
    /// Unit vector down the field of the nearest landmark, or straight to the place close to it. For places
    /// known().
    Vec2 direction(Vec2 from, std::int32_t place) const;
    /// The field of the nearest landmark. For places known().
    const CostField& field(std::int32_t place) const;
    /// The local fields themselves.
    LocalFields& fields() { return fields_; }
    const LocalFields& fields() const { return fields_; }

    /// Lets an archive read or write all data that influences later steps.
    template <class Archive>
    void visit(Archive& archive) {
        archive(step_, generation_, requests_, assigneeRequests_, stencilRequests_, visible_, stencil_,
                fields_);
        if constexpr (Archive::kReading) {
            const std::size_t n = requests_.size();
            if (assigneeRequests_.size() != n || stencilRequests_.size() != n || visible_.size() != n ||
                stencil_.size() != n || !slotsValid())
                archive.fail();
        }
    }
    /// Number of places, including places that an archive named.
    std::size_t places() const { return requests_.size(); }

private:
    bool isDue(std::size_t place) const;
    void ageRequests();
    void findLandmarks(std::size_t place, bool fieldsMoved);
    bool slotsValid() const;
    double staticCost(Vec2 from, std::int32_t place) const;
    double costByCorners(const CostField& field, Vec2 from, Vec2 to) const;
    Vec2 farthestVisible(Vec2 from, Vec2 near, Vec2 far) const;
    double lengthAroundCorner(Vec2 from, Vec2 landmark, Vec2 to) const;
    double interpolatedCost(Vec2 from, std::int32_t place) const;
    double dynamicCostAlong(const CostField& field, Vec2 from, Vec2 to) const;

    LocalFields fields_;
    const StaticGround* ground_ = nullptr;
    const DynamicCost* dynamicCost_ = nullptr;
    std::span<const Vec2> places_;
    std::uint32_t step_ = 0;
    std::uint32_t generation_ = 0;  // Generation of fields_, to which slots refer.
    // Request buffers: added to by const queries, drained by updateLandmarks().
    mutable FieldRequests requests_;
    mutable FieldRequests assigneeRequests_;  // Requests for the assignee of the place.
    // Places that need a stencil, as paths to them cross several unit costs.
    mutable FieldRequests stencilRequests_;
    std::vector<VisibleLandmarks> visible_;      // Landmarks per place.
    std::vector<InterpolationStencil> stencil_;  // Stencil per place.
};

}  // namespace muster
