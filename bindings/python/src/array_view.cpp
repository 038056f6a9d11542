#include "array_view.h"

#include <cstddef>
#include <memory>

#include "pinned_memory.h"

namespace muster::python {
namespace {

static_assert(sizeof(Vec2) == 2 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(std::int32_t));

/// What a view keeps.
struct Kept {
    py::object owner;
    const void* place;

    Kept(py::object kept, const void* data) : owner(std::move(kept)), place(data) { pin(place); }
    Kept(const Kept&) = delete;
    Kept& operator=(const Kept&) = delete;
    ~Kept() {
        owner = py::object();  // First the world, which may give the block back; then the block.
        unpin(place);
    }
};

py::dtype recordOf(const std::vector<std::pair<const char*, py::dtype>>& fields,
                   const std::vector<std::size_t>& offsets, std::size_t size) {
    py::list names, formats, places;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        names.append(fields[i].first);
        formats.append(fields[i].second);
        places.append(offsets[i]);
    }
    return py::dtype(names, formats, places, static_cast<py::ssize_t>(size));
}

}  // namespace

py::array viewOf(const py::object& owner, const void* data, std::size_t count, const py::dtype& type,
                 const std::vector<py::ssize_t>& inner) {
    std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(count)};
    shape.insert(shape.end(), inner.begin(), inner.end());
    if (count == 0) {
        py::array none(type, shape);
        none.attr("setflags")(py::arg("write") = false);
        return none;
    }
    auto kept = std::make_unique<Kept>(owner, data);
    const py::capsule base(kept.get(), [](void* thing) { delete static_cast<Kept*>(thing); });
    kept.release();
    py::array view(type, shape, data, base);
    view.attr("setflags")(py::arg("write") = false);
    return view;
}

py::dtype bodyRecord() {
    const py::dtype number = py::dtype::of<double>();
    return recordOf(
        {{"radius", number},
         {"max_speed", number},
         {"acceleration", number},
         {"mass", number},
         {"supply", number},
         {"unit_class", py::dtype::of<std::uint8_t>()},
         {"headway", number},
         {"premovement", number},
         {"upstairs", number},
         {"downstairs", number}},
        {offsetof(Body, radius), offsetof(Body, maxSpeed), offsetof(Body, acceleration), offsetof(Body, mass),
         offsetof(Body, supply), offsetof(Body, unitClass), offsetof(Body, headway),
         offsetof(Body, premovement), offsetof(Body, upstairs), offsetof(Body, downstairs)},
        sizeof(Body));
}

py::dtype meshPointRecord() {
    const py::dtype weights = py::dtype::from_args(py::make_tuple(py::dtype::of<double>(), 3));
    return recordOf({{"triangle", py::dtype::of<std::int32_t>()}, {"weight", weights}},
                    {offsetof(MeshPoint, triangle), offsetof(MeshPoint, weight)}, sizeof(MeshPoint));
}

py::array pointArray(std::span<const Vec2> points) {
    return py::array(py::dtype::of<double>(),
                     std::vector<py::ssize_t>{static_cast<py::ssize_t>(points.size()), 2}, points.data());
}

}  // namespace muster::python
