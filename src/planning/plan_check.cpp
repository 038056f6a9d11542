// What start() refuses.
#include <cmath>
#include <string>

#include "planning/exact/plan_generation.h"

namespace muster {
namespace {

Status checkDef(const PlanDef& def) {
    if (!(def.exponent >= 1.0 && def.exponent <= 16.0))
        return invalidArgument("plan exponent is not in [1, 16]");
    if (!(def.commitThreshold >= 0.0) || !std::isfinite(def.commitThreshold))
        return invalidArgument("plan threshold is not a finite number >= 0");
    if (!(def.commitThresholdShare >= 0.0) || !std::isfinite(def.commitThresholdShare))
        return invalidArgument("plan threshold share is not a finite number >= 0");
    return {};
}

Status checkSize(const char* what, std::size_t size, std::size_t expected, bool mayBeEmpty) {
    if (size == expected || (mayBeEmpty && size == 0)) return {};
    return invalidArgument("plan " + std::string(what) + " has " + std::to_string(size) +
                           " values, expected " + std::to_string(expected));
}

Status checkPoints(const char* what, std::span<const Vec2> points) {
    for (std::size_t k = 0; k < points.size(); ++k)
        if (!isFinite(points[k]))
            return invalidArgument("plan " + std::string(what) + " " + std::to_string(k) +
                                   " is not at a finite position");
    return {};
}

Status checkAmounts(const char* what, std::span<const double> amounts) {
    for (std::size_t k = 0; k < amounts.size(); ++k)
        if (!(amounts[k] >= 0.0) || !std::isfinite(amounts[k]))
            return invalidArgument("plan " + std::string(what) + " " + std::to_string(k) +
                                   " is not a finite number >= 0");
    return {};
}

Status checkCost(const UnitCost* cost) {
    if (cost == nullptr) return invalidArgument("plan has no unit cost");
    if (cost->grid.width <= 0 || cost->grid.height <= 0 || !(cost->grid.cell > 0.0) ||
        cost->cells.size() !=
            static_cast<std::size_t>(cost->grid.width) * static_cast<std::size_t>(cost->grid.height))
        return invalidArgument("plan unit cost does not fill its grid");
    return {};
}

Status checkIncumbents(std::span<const std::int32_t> incumbent, std::size_t places) {
    for (std::size_t k = 0; k < incumbent.size(); ++k)
        if (incumbent[k] < -1 || incumbent[k] >= static_cast<std::int64_t>(places))
            return invalidArgument("plan incumbent " + std::to_string(k) + " is place " +
                                   std::to_string(incumbent[k]) + " of " + std::to_string(places));
    return {};
}

}  // namespace

Status checkPlan(const PlanDef& def, const PlanInput& input) {
    const std::size_t characters = input.characters.size();
    const std::size_t places = input.places.size();
    const Status checks[] = {
        checkDef(def),
        input.unitCost == nullptr && input.ground != nullptr ? Status{} : checkCost(input.unitCost),
        checkSize("supply", input.supply.size(), characters, true),
        checkSize("demand", input.demand.size(), places, true),
        checkSize("usable", input.usable.size(), places, true),
        checkSize("connected flags", input.connected.size(), characters, true),
        checkSize("incumbent", input.incumbent.size(), characters, false),
        checkPoints("character", input.characters),
        checkPoints("place", input.places),
        checkAmounts("supply", input.supply),
        checkAmounts("demand", input.demand),
        checkIncumbents(input.incumbent, places)};
    for (const Status& status : checks)
        if (!status.ok()) return status;
    return {};
}

}  // namespace muster
