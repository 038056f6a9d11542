// The quality pass: judges the plans of a running world at intervals.
#pragma once

#include <optional>

#include "scale/case.h"
#include "scale/fine_ground.h"
#include "scale/judge.h"

namespace muster::scale {

/// Largest number of characters that the exact plan judges; a lower bound judges larger crowds.
inline constexpr std::int32_t kMostExact = 2500;

/// Mean distance to the places above which cost fields use the world's cells instead of cells of half the
/// edge [m]. Over long paths, second-order fields on them are as exact as on fine cells over short paths.
inline constexpr double kCoarseDistance = 12.0;

/// Steps between judgements: `every`, or a multiple of it where many far cost fields must be solved.
std::int32_t looksEvery(std::int32_t every, const SceneDef& scene);

/// The committed plan of the first group of a world.
Committed committedBy(const World& world);

/// Judges every `every`-th step, and the second step for the first plan, which is reported separately.
class QualityPass {
public:
    /// `label` names the case where progress is printed on standard error; empty for silence.
    QualityPass(std::int32_t every, std::string label, ThreadPool& pool);
    /// Must be called after every step.
    void observe(const World& world);
    /// The results of all judgements so far.
    const Quality& quality() const { return quality_; }
    const Status& status() const { return status_; }  ///< Why judging failed, or Ok.

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
