// Parameters of a world, access to them by name, and presets.
#pragma once

#include <span>
#include <string_view>

#include "muster/generated/parameters.h"
#include "muster/status.h"

namespace muster {

/// Describes one parameter. A switch is the number 0 or 1, a mode is the value of its enumerator.
struct ParameterInfo {
    std::string_view name;         ///< Name in files and messages: "plan.exponent".
    std::string_view unit;         ///< "m", "s", "m/s", "1", "switch", "mode", "steps", "count"...
    double minimum;                ///< Smallest allowed value.
    double maximum;                ///< Largest allowed value.
    std::string_view description;  ///< One sentence.
    double (*get)(const Parameters& parameters);        ///< Reads the field.
    void (*set)(Parameters& parameters, double value);  ///< Writes the field; `value` must be valid.

    /// True where only whole numbers are valid: switches, modes, steps and counts.
    bool whole() const;
    /// True where `value` lies in the range, and is whole where it must be.
    bool valid(double value) const;
};

/// All parameters, in the order in which archives hold them.
std::span<const ParameterInfo> parameterTable();
/// Names of earlier versions, which older files hold: they are read, and set nothing.
std::span<const std::string_view> retiredParameters();
/// Sets a parameter by name. Fails with NotFound, or with InvalidArgument naming name, value and range.
Status setParameter(Parameters& parameters, std::string_view name, double value);
/// Parameters of a preset: "units" (the defaults), "people" or "paper" (docs/parameters.md). Fails with
/// NotFound.
Result<Parameters> parameterPreset(std::string_view name);
/// Sets the parameters in which that preset differs from `units`, and those that have the value of another
/// preset, and no others. Fails with NotFound and then changes nothing.
Status usePreset(Parameters& parameters, std::string_view name);

}  // namespace muster
