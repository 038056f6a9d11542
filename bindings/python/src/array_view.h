// The engine's arrays as NumPy arrays, without a copy.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <span>
#include <type_traits>
#include <vector>

#include "muster/geometry.h"
#include "muster/people.h"
#include "muster/vec2.h"

namespace muster::python {

namespace py = pybind11;

/// A read-only array over memory of the engine. It keeps `owner` alive, and its memory (pinned_memory.h).
/// `inner` is the shape of an element.
py::array viewOf(const py::object& owner, const void* data, std::size_t count, const py::dtype& type,
                 const std::vector<py::ssize_t>& inner = {});

/// Elements as records with the fields of Body.
py::dtype bodyRecord();
/// Elements as records with the fields of MeshPoint.
py::dtype meshPointRecord();

/// The same for the types of the engine's arrays.
template <class T>
py::array viewOf(const py::object& owner, std::span<const T> values) {
    if constexpr (std::is_same_v<T, Vec2>) {
        return viewOf(owner, values.data(), values.size(), py::dtype::of<double>(), {2});
    } else if constexpr (std::is_same_v<T, Triangle>) {
        return viewOf(owner, values.data(), values.size(), py::dtype::of<std::int32_t>(), {3});
    } else if constexpr (std::is_same_v<T, Body>) {
        return viewOf(owner, values.data(), values.size(), bodyRecord());
    } else if constexpr (std::is_same_v<T, MeshPoint>) {
        return viewOf(owner, values.data(), values.size(), meshPointRecord());
    } else if constexpr (std::is_enum_v<T>) {
        return viewOf(owner, values.data(), values.size(), py::dtype::of<std::underlying_type_t<T>>());
    } else {
        return viewOf(owner, values.data(), values.size(), py::dtype::of<T>());
    }
}

/// Points as an array of shape (n, 2) of its own.
py::array pointArray(std::span<const Vec2> points);

}  // namespace muster::python
