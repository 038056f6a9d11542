// Which C++ types are plain data in Python, and by which names.
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <tuple>
#include <type_traits>

#include "engine/world/metrics.h"
#include "muster/command.h"
#include "muster/event.h"
#include "muster/take.h"
#include "muster/views.h"
#include "muster/world.h"

namespace muster::python {

/// The Python name and the fields of a struct; a specialisation for each one that has a class in Python.
template <class T>
struct Described : std::false_type {};
/// The Python name and the words of an enumeration.
template <class T>
struct Words {};

#include "generated/described_types.inc"

/// The class of that name in muster._types.
inline pybind11::object dataClass(const char* name) {
    return pybind11::module_::import("muster._types").attr(name);
}
/// The class of a described type; it lives as long as the process.
template <class T>
const pybind11::object& classOf() {
    static const pybind11::object& known = *new pybind11::object(dataClass(Described<T>::kName));
    return known;
}

}  // namespace muster::python
