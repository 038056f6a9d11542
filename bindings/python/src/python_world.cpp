#include "python_world.h"

#include <algorithm>
#include <string>

#include "from_python.h"
#include "to_python.h"

namespace muster::python {

World& WorldHandle::get() {
    if (busy_)
        check({StatusCode::Unsupported,
               "world: found a step in another thread, expected one thread at a time"});
    return world_;
}

void WorldHandle::stepOnce(World& world) {
    struct Busy {
        bool& flag;
        explicit Busy(bool& of) : flag(of) { flag = true; }
        ~Busy() { flag = false; }
    };
    const Busy busy(busy_);  // Ends after the lock is back.
    const py::gil_scoped_release others;
    world.step();
}

void WorldHandle::step(const py::object& given) {
    World& world = get();
    const auto count = fromPython<std::int64_t>(given, "count");
    if (count < 0) check(invalidArgument("count: found " + std::to_string(count) + ", expected 0 or more"));
    for (std::int64_t i = 0; i < count; ++i) {
        stepOnce(world);
        if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
}

py::object WorldHandle::submit(const py::object& what, const py::object& step, const py::object& sender) {
    World& world = get();
    const auto client = fromPython<std::uint32_t>(sender, "client");
    Command command;
    if (py::isinstance(what, classOf<Command>())) {
        if (!step.is_none() || client != 0)
            check(invalidArgument(
                "submit: found a Command and a step or client, expected either them or a Command's own"));
        command = fromPython<Command>(what, "command");
    } else {
        FromPython("command").read(what, command.body);
        command.step = world.stepCount();
        if (!step.is_none()) FromPython("step").read(step, command.step);
        command.client = client;
        const auto next = next_.find(client);
        command.sequence = next == next_.end() ? 0 : next->second;
    }
    check(world.submit(command));
    std::uint32_t& next = next_[command.client];
    next = std::max(next, command.sequence + 1);
    return toPython(command);
}

void WorldHandle::rewind(const py::object& snapshot) {
    check(get().rewind(bytesFrom(snapshot, "snapshot")));
}

}  // namespace muster::python
