// The quality pass: a judge that looks at a running world now and then.
#pragma once

#include <memory>
#include <optional>

#include "scale/case.h"
#include "scale/fine_ground.h"
#include "scale/judge.h"

namespace muster::scale {

/// Up to so many characters the exact plan judges, beyond a certified bound.
inline constexpr std::int32_t kMostExact = 2500;

/// From this mean distance to the places on, the judge takes the world's own cells: over such ways
/// second-order fields are as good there as on half of them over short ones [m].
inline constexpr double kFarWay = 12.0;

/// Steps between looks: `every`, more where many fields have to be marched far.
std::int32_t looksEvery(std::int32_t every, const SceneDef& scene);

/// What the first group of a world has committed.
Committed committedBy(const World& world);

/// Looks at every `every`-th step, and after the second: at the first plan, which counts on its own.
class QualityPass {
public:
    /// `label` names the case where progress is printed on standard error; empty for silence.
    QualityPass(std::int32_t every, std::string label, ThreadPool& pool);
    /// Call after every step.
    void observe(const World& world);
    /// All looks so far; Status says what kept the judge from looking.
    const Quality& quality() const { return quality_; }
    const Status& status() const { return status_; }  ///< Ok where it could look.

private:
    void look(const World& world);
    const UnitCost* costFor(const World& world, const Committed& plan);

    std::int32_t every_;
    std::string label_;
    ThreadPool& pool_;
    std::optional<FineGround> fine_;
    std::optional<FineGround> coarse_;
    Quality quality_;
    Status status_;
};

}  // namespace muster::scale
