// Costs of ways between any point and any place of a group, at a small price each (SPEC A2, B1).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/archive.h"
#include "base/parallel.h"
#include "cost/dynamic_cost.h"
#include "cost/static_ground.h"

namespace muster {

/// How much work is done in a step.
struct GeodesicsDef {
    std::int32_t nearFields = 6144;    ///< Most windows of the ground cells kept.
    std::int32_t middleFields = 2048;  ///< Most windows of cells twice as wide kept.
    /// Windows made in a step, at most: from 2,500 places on, in proportion. For fewer places fields of all
    /// kinds together, for fewer than 500 one.
    std::int32_t nearPerStep = 2;
    /// The same for the wider ones; with fewer places in every other step.
    std::int32_t middlePerStep = 1;
    /// Far fields made in a step, at most: from 2,500 places on; with fewer in every other step.
    std::int32_t farPerStep = 1;
};

/// Where to walk.
struct WayAhead {
    Vec2 direction;     ///< Unit vector; zero where no way is known.
    float cost = 0.0f;  ///< To the place.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(direction, cost);
    }
};

/// What a walker remembers from step to step of a long way: a point in sight that lies on it, or the landmark
/// of a window that leads round the next corner.
struct WayPoint {
    Vec2 point;                ///< [m]
    std::int32_t place = -1;   ///< The place to which it leads; -1 for none.
    std::int32_t steps = 0;    ///< For which it still serves.
    std::int32_t window = -1;  ///< The landmark: a ground cell; -1 for none.
    bool inSight = false;      ///< The point serves; else the window.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(point, place, steps, window, inSight);
    }
};

/// Interpolates squared costs between fields of landmarks round each place: straight lines where the ground
/// is clear and uniform, small windows of the fine ground near by, fields of the coarse ground far away.
/// Fields are those of the still ground; the excess of crowd and moving things is added along the way.
class Geodesics {
public:
    explicit Geodesics(const GeodesicsDef& def = {});  ///< Knows nothing yet.
    ~Geodesics();
    Geodesics(Geodesics&&) noexcept;  ///< Moves.
    Geodesics& operator=(Geodesics&&) noexcept;

    /// Makes room for the fields that so many places may need on this ground. Changes no result.
    void reserve(const StaticGround& ground, std::size_t places);
    /// Takes the places of this step, and makes some of the fields that were missing in the last. `ground`
    /// and `excess` must live until the next call.
    void update(const StaticGround& ground, const DynamicCost& excess, std::span<const Vec2> places,
                ThreadPool& pool);
    /// Makes all far fields that ways from these points to the places ask for: before a first plan.
    void survey(std::span<const Vec2> from, ThreadPool& pool);
    /// Cost from `from` to a place [m of open ground] >= 0, finite. May be called from several threads.
    float cost(Vec2 from, std::int32_t place) const;
    /// No cost is less than so many times the straight line.
    double perMetre() const;
    /// True where moving things make the ground dearer or cheaper: there costs change from step to step.
    bool unsteady(Vec2 p) const;
    /// The same with the direction to go; `memory` is the walker's own.
    WayAhead ahead(Vec2 from, std::int32_t place, WayPoint& memory) const;
    /// Keeps the windows that walkers need, and asks for those that are missing. Call after all have asked
    /// ahead().
    void remember(std::span<const WayPoint> walkers);
    /// A lower bound of the cost, less what moving patches save: the straight line, as far as both ends lie
    /// deep in ground that costs more by what that costs.
    double atLeast(Vec2 from, std::int32_t place) const;
    /// True where the cost is that of the straight line.
    bool straight(Vec2 from, std::int32_t place) const;

    /// Writes all that can influence later results, less what follows from the ground.
    void save(Writer& archive) const;
    /// Reads what save() wrote; fields are made anew by the next update(). False where it does not fit.
    bool load(Reader& archive);
    /// Adds what save() writes to a hash.
    void hash(Hasher& archive) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
