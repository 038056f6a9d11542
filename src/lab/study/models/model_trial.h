// One trial directed by an operator model.
#pragma once

#include <string>
#include <vector>

#include "lab/study/models/operator_model.h"
#include "muster/status.h"

namespace muster {

/// Trials of the report have seeds from 1 on; whatever is tuned uses seeds from here on, which no report has.
inline constexpr std::uint64_t kFirstTuningSeed = 1000001;

/// A trial with all that the model did in it.
struct ModelTrial {
    TrialResult result;                    ///< Result as of any trial.
    std::int32_t misses = 0;               ///< Number of gestures without the effect that was meant.
    std::int32_t orders = 0;               ///< Number of orders that the model meant to give.
    double operatorSeconds = 0.0;          ///< Time in which the model decided or moved [s].
    std::vector<ModelDecision> decisions;  ///< Decisions in the order of time.
    std::vector<StampedInput> inputs;      ///< All inputs of the model.
};

/// Runs a trial to its end. Items, and the chance of the model, depend on the seed alone, so that trials of
/// two schemes with one seed are a pair. Fails where a name is unknown.
Result<ModelTrial> runModelTrial(const TrialDef& def, const std::string& setting);

/// Time from the last event of one order until the middle of the crowd has gone 20 m straight over open
/// ground [s], towards a point 25 m away. Fails where the scheme is unknown or the crowd does not get there
/// within a minute.
Result<double> equalWalkSeconds(const std::string& scheme, std::int32_t crowd);

}  // namespace muster
