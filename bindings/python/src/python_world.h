// A world as Python holds it.
#pragma once

#include <pybind11/pybind11.h>

#include <cstdint>
#include <map>

#include "muster/world.h"

namespace muster::python {

namespace py = pybind11;

/// A world, and what belongs to its use from Python.
class WorldHandle {
public:
    explicit WorldHandle(World world) : world_(std::move(world)) {}

    /// The world; throws while it makes a step in another thread.
    World& get();
    /// Steps that many times, without the interpreter's lock.
    void step(const py::object& count);
    /// Submits a command, or a body for a step (none: the next one) as the next command of a client. Gives
    /// the command.
    py::object submit(const py::object& what, const py::object& step, const py::object& client);
    /// Goes back to a snapshot.
    void rewind(const py::object& snapshot);

private:
    void stepOnce(World& world);

    World world_;
    bool busy_ = false;                            // Guarded by the interpreter's lock.
    std::map<std::uint32_t, std::uint32_t> next_;  // The next sequence number of each client.
};

/// The world of a Python object.
inline World& worldOf(const py::object& object) {
    return object.cast<WorldHandle&>().get();
}

void defineWorld(py::module_& module);
void defineCharacters(py::module_& module);
void defineGroups(py::module_& module);
void defineScenarios(py::module_& module);
void defineTakes(py::module_& module);
void defineMeasures(py::module_& module);
void defineFigures(py::module_& module);
void defineMotion(py::module_& module);

/// All groups, in ascending order of ids, and the group of an id (groups.cpp).
py::list groupsOf(const py::object& world);
py::object groupOf(const py::object& world, const py::object& id);
/// The characters (characters.cpp).
py::object charactersOf(const py::object& world);
/// What lies on the ground, in ascending order of ids (ground.cpp).
py::list obstaclesOf(const py::object& world);
py::list patchesOf(const py::object& world);
py::list itemsOf(const py::object& world);
py::list checkpointsOf(const py::object& world);
py::list areasOf(const py::object& world);

}  // namespace muster::python
