// C++ values as Python's data.
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <concepts>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "described.h"

namespace muster::python {

namespace py = pybind11;

py::object toPython(Vec2 value);
py::object toPython(const Box& value);
/// A dict of those parameters that differ from the defaults.
py::object toPython(const Parameters& value);
/// A dict of the number of events by the words of their kinds.
py::object toPython(const EventCounts& value);
py::object toPython(const std::array<double, 3>& value);
/// A dict of milliseconds by the names of stages.
py::object toPython(const std::array<double, kStageCount>& value);
py::object toPython(const CommandBody& value);
inline py::object toPython(bool value) {
    return py::bool_(value);
}
inline py::object toPython(double value) {
    return py::float_(value);
}
inline py::object toPython(const std::string& value) {
    return py::str(value);
}
template <std::integral T>
requires(!std::same_as<T, bool>) py::object toPython(T value) {
    return py::int_(value);
}
template <class Tag>
py::object toPython(Id<Tag> value) {
    return py::int_(value.value);
}

// Templates that need each other.
template <class T>
requires std::is_enum_v<T> py::object toPython(T value);
template <class T>
requires(Described<T>::value) py::object toPython(const T& value);
template <class T>
py::object toPython(const std::optional<T>& value);
template <class T>
py::object toPython(const std::vector<T>& value);

/// A list of what a span holds.
template <class T>
py::list listOf(std::span<T> values) {
    py::list items(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) items[i] = toPython(values[i]);
    return items;
}

template <class T>
requires std::is_enum_v<T> py::object toPython(T value) {
    static const py::list& members = *new py::list(dataClass(Words<T>::kName));
    return members[static_cast<std::size_t>(value)];
}
template <class T>
py::object toPython(const std::optional<T>& value) {
    return value ? toPython(*value) : py::object(py::none());
}
template <class T>
py::object toPython(const std::vector<T>& value) {
    return listOf(std::span(value));
}

/// Collects the fields of a struct in their order.
struct FieldList {
    py::list values;
    template <class T>
    void operator()(const char*, const T& field) {
        values.append(toPython(field));
    }
};
template <class T>
requires(Described<T>::value) py::object toPython(const T& value) {
    FieldList list;
    Described<T>::fields(list, value);
    return classOf<T>()(*py::tuple(list.values));
}

/// A dict of every described type, by name, as C++ makes it.
py::dict engineDefaults();

}  // namespace muster::python
