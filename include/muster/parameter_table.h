// Parameters by name: the table, and the presets.
#pragma once

#include <span>
#include <string_view>

#include "muster/parameters.h"
#include "muster/status.h"

namespace muster {

/// What is known of one parameter. As a number a switch is 0 or 1, and a mode is the value of its enumerator.
struct ParameterInfo {
    std::string_view name;         ///< As files and messages spell it: "plan.exponent".
    std::string_view unit;         ///< "m", "s", "m/s", "1", "switch", "mode", "steps", "count"...
    double minimum;                ///< Smallest allowed value.
    double maximum;                ///< Largest allowed value.
    std::string_view description;  ///< One sentence.
    double (*get)(const Parameters& parameters);        ///< Reads its field.
    void (*set)(Parameters& parameters, double value);  ///< Writes its field; the value must be valid.

    /// True where only whole numbers are valid: switches, modes, steps and counts.
    bool whole() const;
    /// True where `value` lies in the range, and is whole where it must be.
    bool valid(double value) const;
};

/// All parameters, in the order in which archives hold them.
std::span<const ParameterInfo> parameterTable();
/// Sets one by name. Fails with NotFound, or with InvalidArgument naming name, value and range.
Status setParameter(Parameters& parameters, std::string_view name, double value);
/// "muster" (the defaults) or "paper" (exact plans of exponent 1 and threshold 0 in every step). Fails with
/// NotFound.
Result<Parameters> parameterPreset(std::string_view name);
/// Sets what the presets differ in as that preset has it; all else stays. Fails, changing nothing, with
/// NotFound.
Status usePreset(Parameters& parameters, std::string_view name);

}  // namespace muster
