#include <doctest.h>

#include <algorithm>

#include "lab/study/models/model_trial.h"
#include "studio/gestures/control_scheme.h"
#include "studio/study/trial/trial_environment.h"

namespace muster {
namespace {

TEST_CASE("a straight walk in the open takes all controls the same time, within three in a hundred") {
    for (const std::int32_t crowd : studyCrowds()) {
        double least = 1e9;
        double most = 0.0;
        for (const NamedScheme& scheme : namedSchemes()) {
            const auto seconds = equalWalkSeconds(std::string(scheme.name), crowd);
            REQUIRE_MESSAGE(seconds.ok(), seconds.status().message());
            MESSAGE(std::string(scheme.name), ", ", crowd, " characters: ", *seconds, " s");
            least = std::min(least, *seconds);
            most = std::max(most, *seconds);
        }
        CHECK(most <= 1.02 * least);
    }
}

}  // namespace
}  // namespace muster
