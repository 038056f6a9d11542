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

/// What the first group of a world has committed.
Committed committedBy(const World& world);

/// Looks at every `every`-th step, from the second on (the first plan is made in the first).
class QualityPass {
public:
    /// `label` names the case where progress is told on standard error; empty for silence.
    QualityPass(std::int32_t every, std::string label, ThreadPool& pool);
    /// Call after every step.
    void observe(const World& world);
    /// All looks so far; Status says what kept the judge from looking.
    const Quality& quality() const { return quality_; }
    const Status& status() const { return status_; }  ///< Ok where it could look.

private:
    void look(const World& world);

    std::int32_t every_;
    std::string label_;
    ThreadPool& pool_;
    std::optional<FineGround> ground_;
    Quality quality_;
    Status status_;
};

}  // namespace muster::scale
