#include "to_python.h"

#include "muster/parameter_table.h"

namespace muster::python {

py::object toPython(Vec2 value) {
    return py::make_tuple(value.x, value.y);
}

py::object toPython(const Box& value) {
    return py::make_tuple(toPython(value.min), toPython(value.max));
}

py::object toPython(const Parameters& value) {
    py::dict changed;
    const Parameters defaults;
    for (const ParameterInfo& info : parameterTable()) {
        const double number = info.get(value);
        if (number != info.get(defaults)) changed[py::str(std::string(info.name))] = number;
    }
    return changed;
}

py::object toPython(const EventCounts& value) {
    py::dict counts;
    for (std::size_t i = 0; i < value.size(); ++i)
        counts[eventKindName(static_cast<EventKind>(i))] = value[i];
    return counts;
}

py::object toPython(const std::array<double, 3>& value) {
    return py::make_tuple(value[0], value[1], value[2]);
}

py::object toPython(const std::array<double, kStageCount>& value) {
    py::dict times;
    for (std::size_t i = 0; i < value.size(); ++i) times[stepStages()[i].name.data()] = value[i];
    return times;
}

py::object toPython(const CommandBody& value) {
    return std::visit([](const auto& body) -> py::object { return toPython(body); }, value);
}

py::dict engineDefaults() {
    py::dict all;
    std::apply(
        [&](const auto&... values) {
            ((all[Described<std::decay_t<decltype(values)>>::kName] = toPython(values)), ...);
        },
        AllDescribed());
    return all;
}

}  // namespace muster::python
