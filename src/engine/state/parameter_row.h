// A row of the table of parameters: how a field is read and written as a number.
#pragma once

#include <string_view>
#include <type_traits>

#include "muster/parameter_table.h"

namespace muster {

/// A field of the parameters, or of one of their groups.
template <auto Field>
auto& fieldOf(auto& parameters) {
    return parameters.*Field;
}
template <auto Group, auto Field>
auto& fieldOf(auto& parameters) {
    return (parameters.*Group).*Field;
}

/// Reads a field as a number.
template <auto... Path>
double readField(const Parameters& parameters) {
    return static_cast<double>(fieldOf<Path...>(parameters));
}
/// Writes a valid number to a field.
template <auto... Path>
void writeField(Parameters& parameters, double value) {
    auto& field = fieldOf<Path...>(parameters);
    field = static_cast<std::remove_reference_t<decltype(field)>>(value);
}

/// The row of the field that lies at a path.
template <auto... Path>
constexpr ParameterInfo parameter(std::string_view name, std::string_view unit, double minimum,
                                  double maximum, std::string_view description) {
    return {name, unit, minimum, maximum, description, &readField<Path...>, &writeField<Path...>};
}

}  // namespace muster
