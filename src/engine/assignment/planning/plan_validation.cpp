#include "engine/assignment/planning/assigner.h"

#include <cmath>
#include <string>
#include <utility>

namespace muster {
namespace {

Status validateDef(const PlanDef& def) {
    if (!(def.exponent >= 1.0 && def.exponent <= 16.0))
        return invalidArgument("plan exponent is not in [1, 16]");
    if (!(def.commitThreshold >= 0.0) || !std::isfinite(def.commitThreshold))
        return invalidArgument("plan threshold is not a finite number >= 0");
    if (!(def.commitThresholdShare >= 0.0) || !std::isfinite(def.commitThresholdShare))
        return invalidArgument("plan threshold share is not a finite number >= 0");
    return {};
}

Status validateSize(const char* what, std::size_t size, std::size_t expected, bool mayBeEmpty) {
    if (size == expected || (mayBeEmpty && size == 0)) return {};
    return invalidArgument("plan " + std::string(what) + " has " + std::to_string(size) +
                           " values, expected " + std::to_string(expected));
}

Status validatePoints(const char* what, std::span<const Vec2> points) {
    for (std::size_t k = 0; k < points.size(); ++k)
        if (!isFinite(points[k]))
            return invalidArgument("plan " + std::string(what) + " " + std::to_string(k) +
                                   " is not at a finite position");
    return {};
}

Status validateAmounts(const char* what, std::span<const double> amounts) {
    for (std::size_t k = 0; k < amounts.size(); ++k)
        if (!(amounts[k] >= 0.0) || !std::isfinite(amounts[k]))
            return invalidArgument("plan " + std::string(what) + " " + std::to_string(k) +
                                   " is not a finite number >= 0");
    return {};
}

Status validateFactors(std::span<const float> factors) {
    for (std::size_t k = 0; k < factors.size(); ++k)
        if (!(factors[k] > 0.0f) || !std::isfinite(factors[k]))
            return invalidArgument("plan slowness " + std::to_string(k) + " is not a finite number above 0");
    return {};
}

Status validateIncumbents(std::span<const std::int32_t> incumbent, std::size_t places) {
    for (std::size_t k = 0; k < incumbent.size(); ++k)
        if (incumbent[k] < -1 || std::cmp_greater_equal(incumbent[k], places))
            return invalidArgument("plan incumbent " + std::to_string(k) + " is place " +
                                   std::to_string(incumbent[k]) + " of " + std::to_string(places));
    return {};
}

}  // namespace

Status validateUnitCost(const UnitCost& cost) {
    const Grid& grid = cost.grid;
    const bool whole = grid.width > 0 && grid.height > 0 && grid.cell > 0.0 &&
                       cost.cells.size() ==
                           static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
    return whole ? Status{} : invalidArgument("plan unit cost does not fill its grid");
}

Status validatePlan(const PlanDef& def, const PlanInput& input) {
    const std::size_t characters = input.characters.size();
    const std::size_t places = input.places.size();
    const Status checks[] = {validateDef(def),
                             validateSize("supply", input.supply.size(), characters, true),
                             validateSize("demand", input.demand.size(), places, true),
                             validateSize("usable", input.usable.size(), places, true),
                             validateSize("connected", input.connected.size(), characters, true),
                             validateSize("known", input.known.size(), characters, true),
                             validateSize("slowness", input.slowness.size(), characters, true),
                             validateFactors(input.slowness),
                             validateSize("character class", input.characterClass.size(), characters, true),
                             validateSize("place class", input.placeClass.size(),
                                          input.characterClass.empty() ? 0 : places, false),
                             validateSize("incumbent", input.incumbent.size(), characters, false),
                             validatePoints("character", input.characters),
                             validatePoints("place", input.places),
                             validateAmounts("supply", input.supply),
                             validateAmounts("demand", input.demand),
                             validateIncumbents(input.incumbent, places)};
    for (const Status& status : checks)
        if (!status.ok()) return status;
    return {};
}

}  // namespace muster
