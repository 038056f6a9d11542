// Shortest-path oracle: geodesic costs between any point and any place of a group in nearly constant time
// (SPEC A2, B1). Landmark-based distance oracle after Goldberg and Harrelson 2005, with any-angle lines of
// sight (Nash et al. 2007).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/archive.h"
#include "base/parallel.h"
#include "engine/fields/cost/dynamic_cost.h"
#include "engine/fields/cost/static_ground.h"
#include "engine/fields/geodesics/shared_far_fields.h"
#include "engine/ground/routes/route_graph.h"

namespace muster {

/// Capacities of the field caches, and numbers of fields solved in a step.
struct GeodesicsDef {
    std::int32_t fineFields = 6144;    ///< Capacity for local fields on the ground cells >= 1.
    std::int32_t middleFields = 2048;  ///< Capacity for local fields on cells twice as wide >= 1.
    /// Local fields on the ground cells solved in a step, at most: in proportion to the places from 2,500 on.
    /// Groups with fewer places share this budget among the fields of all kinds; below 500 places it is one
    /// field.
    std::int32_t finePerStep = 2;
    /// Local fields on cells twice as wide solved in a step, at most; groups of fewer places solve them in
    /// every other step.
    std::int32_t middlePerStep = 1;
    /// Far fields solved in a step, at most; groups of fewer than 2,500 places solve them in every other
    /// step.
    std::int32_t farPerStep = 1;
};

/// Desired direction of a character (Helbing and Molnár 1995), and the cost of its path.
struct Guidance {
    Vec2 direction;     ///< Unit vector; zero where no path is known.
    float cost = 0.0f;  ///< Cost of the path to the place [m].

    /// Lets an archive read or write the guidance.
    template <class Archive>
    void visit(Archive& archive) {
        archive(direction, cost);
    }
};

/// Use of a route for a character that no field leads.
enum class RouteUse : std::uint8_t {
    None,    ///< The character needs none.
    Wanted,  ///< Geodesics::findRoutes() finds one.
    Known,   ///< The target is the next corner of its route.
};

/// The target of a character on a long path, remembered for several steps: the farthest point of the path in
/// line of sight, or, where none is, the local field of a landmark behind the next corner.
struct SteeringTarget {
    Vec2 point;                       ///< Point on the path [m].
    std::int32_t place = -1;          ///< The place to which the path leads; -1 for none.
    std::int32_t steps = 0;           ///< Steps for which the target remains valid.
    std::int32_t landmark = -1;       ///< Landmark of the local field: a ground cell; -1 for none.
    bool inSight = false;             ///< True where `point` is the target; false where the local field is.
    RouteUse route = RouteUse::None;  ///< Use of a route: Known if the target is that of a route.
    bool seen = false;                ///< True if the corner was in sight when the route was found,
    Vec2 after;                       ///< the corner after it, itself where it is the last [m],
    Vec2 end;                         ///< and the position of the place at that time [m].

    /// Lets an archive read or write the target.
    template <class Archive>
    void visit(Archive& archive) {
        archive(point, place, steps, landmark, inSight, route, seen, after, end);
    }
};

/// Answers queries from a hierarchy of sources: lines of sight where the ground is clear and uniform, local
/// fields of landmarks near by, far fields on the coarse ground beyond. Fields hold the cost of the static
/// ground only; the dynamic cost is integrated along the path. Fields that a query lacks are requested and
/// solved in later steps.
class Geodesics {
public:
    explicit Geodesics(const GeodesicsDef& def = {});  ///< Has no fields yet.
    ~Geodesics();
    Geodesics(Geodesics&&) noexcept;  ///< Moves the oracle.
    Geodesics& operator=(Geodesics&&) noexcept;

    /// Allocates memory for the fields that a number of places may need on this ground, with or without
    /// routes. Changes no result.
    void reserve(const StaticGround& ground, std::size_t places, bool routes = false);
    /// Takes the places of this step, and solves some of the fields that were requested in the last. `ground`
    /// and `dynamicCost` must outlive the next call.
    void update(const StaticGround& ground, const DynamicCost& dynamicCost, std::span<const Vec2> places,
                ThreadPool& pool);
    /// Sets that fields are solved in one step out of `period`, 1 or more, from the next update on; `rank` is
    /// the step's turn. So several geodesics share a budget, and the far fields, where these are given. Where
    /// `routes` are found in every step, small groups on large ground use these alone.
    void shareSteps(std::int32_t period, std::int32_t rank, SharedFarFields* fields, bool routes);
    /// Solves fields that queries from these points would request, for a first plan: local fields, then far
    /// fields, with at most `cells` cells in all (local fields count more), which are subtracted. True where
    /// no far field is missing any more. Only a `thorough` call looks for all missing fields; other calls do
    /// so in one step of four.
    bool prefetch(std::span<const Vec2> from, bool thorough, std::int64_t& cells, ThreadPool& pool);
    /// Finds routes for characters `from` [m] whose targets want one, at least one in a step. After update(),
    /// before guidance().
    void findRoutes(RouteGraph& routes, std::span<const Vec2> from, std::span<SteeringTarget> targets);
    /// Cost from `from` to a place [m of open ground] >= 0, finite. May be called from several threads.
    float cost(Vec2 from, std::int32_t place) const;
    /// Least unit cost of the ground: no cost is less than this times the straight distance.
    double leastUnitCost() const;
    /// True where moving obstacles or patches change the unit cost at `p`: there costs change from step to
    /// step.
    bool hasMovingCost(Vec2 p) const;
    /// The cost with the direction to walk; `target` belongs to the character. May be called from several
    /// threads.
    Guidance guidance(Vec2 from, std::int32_t place, SteeringTarget& target) const;
    /// Marks the local fields of these targets as used, and requests missing ones. Must be called after all
    /// calls of guidance() in a step.
    void retainFields(std::span<const SteeringTarget> targets);
    /// Lower bound of the cost without the savings of moving patches [m]: the straight line, with the unit
    /// cost of its ends as far as their uniform clearance reaches.
    double lowerBound(Vec2 from, std::int32_t place) const;
    /// True where the cost is that of the straight line.
    bool lineOfSight(Vec2 from, std::int32_t place) const;

    /// Writes all that can influence later results, except values that follow from the ground.
    void save(Writer& archive) const;
    /// Reads the data of save(); fields are solved again by the next update(). False where it does not fit.
    bool load(Reader& archive);
    /// Takes over the fields of `before` that load() named, where the ground is the same: the next update()
    /// solves only the others. Call after load(), and then bind(). `before` becomes useless.
    void keepFieldsOf(Geodesics& before);
    /// Sets the ground of the fields that load() named: that of the archive, before any edit. Call after
    /// load().
    void bind(const StaticGround& ground);
    /// Adds the data of save() to a hash.
    void hash(Hasher& archive) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
