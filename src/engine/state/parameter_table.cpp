// The table of parameters, and the presets.
#include "muster/parameter_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "engine/ground/environment/environment.h"
#include "engine/state/generated/parameter_rows.h"
#include "engine/state/validation_parts.h"

namespace muster {
namespace {

using parameter_rows::kAll;
using parameter_rows::kPresets;
using parameter_rows::kRetired;

constexpr double largest(std::string_view name) {
    return std::find_if(kAll.begin(), kAll.end(),
                        [&](const ParameterInfo& info) { return info.name == name; })
        ->maximum;
}
// Clearance is known up to its limit only, and a place needs the radius and its own clearance.
static_assert(largest("character.radius") + largest("place.clearance") <= Environment::kClearanceLimit);

}  // namespace

bool ParameterInfo::whole() const {
    return unit == "switch" || unit == "mode" || unit == "steps" || unit == "count";
}

bool ParameterInfo::valid(double value) const {
    return value >= minimum && value <= maximum && (!whole() || value == std::floor(value));
}

std::span<const ParameterInfo> parameterTable() {
    return kAll;
}

std::span<const std::string_view> retiredParameters() {
    return kRetired;
}

Status setParameter(Parameters& parameters, std::string_view name, double value) {
    for (const ParameterInfo& info : kAll) {
        if (info.name != name) continue;
        if (info.valid(value)) {
            info.set(parameters, value);
            return {};
        }
        const bool inside = value >= info.minimum && value <= info.maximum;
        const std::string range = std::string("[").append(numberText(info.minimum)) + ", " +
                                  numberText(info.maximum) + "]";
        return invalidArgument("parameter " + std::string(name) + " is " + numberText(value) +
                               (inside ? ", expected a whole number in " + range
                                       : ", expected a number in " + range + " " + std::string(info.unit)));
    }
    if (std::find(std::begin(kRetired), std::end(kRetired), name) != std::end(kRetired)) return {};
    return {StatusCode::NotFound, "there is no parameter \"" + std::string(name.substr(0, 80)) + "\""};
}

Result<Parameters> parameterPreset(std::string_view name) {
    Parameters parameters;
    if (parameter_rows::makePreset(parameters, name)) return parameters;
    std::string names;
    for (const std::string_view preset : kPresets)
        names.append(names.empty() ? "" : preset == kPresets.back() ? " or " : ", ").append(preset);
    return Status(StatusCode::NotFound,
                  "there is no preset \"" + std::string(name.substr(0, 80)) + "\", expected " + names);
}

Status usePreset(Parameters& parameters, std::string_view name) {
    const auto preset = parameterPreset(name);
    if (!preset.ok()) return preset.status();
    const Parameters units;
    std::array<Parameters, kPresets.size()> others;
    for (std::size_t k = 0; k < others.size(); ++k) parameter_rows::makePreset(others[k], kPresets[k]);
    for (const ParameterInfo& info : kAll) {
        const double now = info.get(parameters), usual = info.get(units), wanted = info.get(*preset);
        const bool ofOther = std::any_of(others.begin(), others.end(), [&](const Parameters& other) {
            return info.get(other) != usual && info.get(other) == now;
        });
        if (wanted != usual || ofOther) info.set(parameters, wanted);
    }
    return {};
}

}  // namespace muster
