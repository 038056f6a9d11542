// muster._core.Take and muster.TakeWriter.
#include <memory>

#include "array_view.h"
#include "files/export/exporter.h"
#include "from_python.h"
#include "muster/export.h"
#include "muster/own_clips.h"
#include "muster/take.h"
#include "python_world.h"
#include "to_python.h"

namespace muster::python {
namespace {

/// Collects positions, frame by frame.
class PositionCollector : public Exporter {
public:
    bool wantsPoses() const override { return false; }
    Status begin(const ExportInfo&) override {
        ids.clear();
        frames.clear();
        positions.clear();
        return {};
    }
    Status frame(const ExportFrame& frame) override {
        for (const ExportCharacter& c : frame.characters) {
            ids.push_back(c.id);
            frames.push_back(static_cast<std::int64_t>(frame.index));
            positions.push_back(c.position);
        }
        return {};
    }
    Status finish() override { return {}; }

    std::vector<std::uint32_t> ids;
    std::vector<std::int64_t> frames;
    std::vector<Vec2> positions;
};

py::tuple positionsOf(const Take& recorded, double fps, double from, double to, const py::object& workers) {
    const std::int32_t threads = threadsFrom(workers);
    PositionCollector collector;
    Status status;
    {
        const py::gil_scoped_release others;
        const ExportDef def{from, to, fps, threads, {}};
        const ClipLibrary none;
        status = exportTake(recorded, none, def, collector);
        if (status.code() == StatusCode::Corrupt &&
            !recorded.frames.empty())  // The take is of another version.
            status = exportTake(recorded, none, def, collector, {}, ReplayFrom::Frames);
    }
    check(status);
    return py::make_tuple(
        py::array_t<std::uint32_t>(static_cast<py::ssize_t>(collector.ids.size()), collector.ids.data()),
        py::array_t<std::int64_t>(static_cast<py::ssize_t>(collector.frames.size()), collector.frames.data()),
        pointArray(collector.positions));
}

void exportFile(const Take& recorded, const std::string& path, const std::string& format, double fps,
                double from, double to, std::int32_t threads) {
    check(exportFormat(format).status());
    Status status;
    {
        const py::gil_scoped_release others;
        status = exportTake(recorded, ownClips(), format, path, {from, to, fps, threads, {}});
    }
    check(status);
}

py::object replay(const Take& recorded, const py::object& workers) {
    const std::int32_t threads = threadsFrom(workers);
    ReplayReport report;
    {
        const py::gil_scoped_release others;
        report = take(replayTake(recorded, threads));
    }
    return toPython(report);
}

py::list storedFrames(const Take& recorded) {
    py::list all;
    for (const TakeFrame& frame : recorded.frames)
        all.append(py::make_tuple(
            frame.step,
            py::array_t<std::uint32_t>(static_cast<py::ssize_t>(frame.ids.size()), frame.ids.data()),
            pointArray(frame.positions)));
    return all;
}

void defineTakeFacts(py::class_<Take, std::shared_ptr<Take>>& type) {
    type.def_property_readonly("scenario", [](const Take& self) { return self.scenario; });
    type.def_property_readonly("definition", [](const Take& self) { return toPython(self.def); });
    type.def_property_readonly("commands", [](const Take& self) { return toPython(self.commands); });
    type.def_property_readonly("marks", [](const Take& self) { return toPython(self.marks); });
    type.def_property_readonly("events", [](const Take& self) { return toPython(self.events); });
    type.def_property_readonly("frames", &storedFrames);
    type.def_property_readonly("about", [](const Take& self) { return toPython(self.about); });
    type.def_property_readonly("finished", [](const Take& self) { return self.finished; });
    type.def_property_readonly("torn_bytes", [](const Take& self) { return self.tornBytes; });
    type.def_property_readonly("steps", &Take::steps);
}

void defineTake(py::module_& module) {
    py::class_<Take, std::shared_ptr<Take>> type(module, "TakeData");
    type.def_static(
        "load", [](const py::object& path) { return std::make_shared<Take>(take(readTake(pathFrom(path)))); },
        py::arg("path"));
    type.def_static(
        "parse",
        [](const py::object& bytes, const std::string& source) {
            return std::make_shared<Take>(take(parseTake(bytesFrom(bytes, "data"), source)));
        },
        py::arg("data"), py::arg("source_name"));
    type.def("replay", &replay, py::arg("threads"));
    type.def(
        "simulates_alike",
        [](const Take& self, const py::object& workers) {
            const std::int32_t threads = threadsFrom(workers);
            const py::gil_scoped_release others;
            return simulatesAlike(self, threads);
        },
        py::arg("threads"));
    type.def("positions", &positionsOf, py::arg("fps"), py::arg("begin"), py::arg("end"), py::arg("threads"));
    type.def("export", &exportFile, py::arg("path"), py::arg("format"), py::arg("fps"), py::arg("begin"),
             py::arg("end"), py::arg("threads"));
    defineTakeFacts(type);
    module.def(
        "export_formats",
        [] {
            py::dict all;
            for (const ExportFormat& format : exportFormats()) all[format.name] = format.about;
            return all;
        },
        "The formats of Take.export() by their names, each with a line of description.");
}

}  // namespace

void defineTakes(py::module_& module) {
    defineTake(module);
    py::class_<TakeWriter>(
        module, "TakeWriter",
        "Writes a take: a file that replays bit for bit. Each record is handed to the system before a call\n"
        "returns, so that a killed process loses at most the record it was writing.")
        .def(py::init([](const py::object& path, const py::object& definition, bool overwrite) {
                 const py::object given = py::module_::import("muster.scenario")
                                              .attr("as_definition")(definition);
                 const auto text = pathFrom(path);
                 return take(TakeWriter::create(text, fromPython<WorldDef>(given, "definition"), overwrite));
             }),
             py::arg("path"), py::arg("definition"), py::arg("overwrite") = true,
             "Makes the file. Fails with IoError, also where it exists and `overwrite` is False.")
        .def(
            "command",
            [](TakeWriter& self, const py::object& command) {
                check(self.command(fromPython<Command>(command, "command")));
            },
            py::arg("command"),
            "Appends a Command, as World.submit() gave it: in the order of submission, before the step that "
            "applies it.")
        .def(
            "observe", [](TakeWriter& self, WorldHandle& world) { check(self.observe(world.get())); },
            py::arg("world"),
            "Call after every single step: appends the events of orders, and frames and hash marks whenever "
            "they are due.")
        .def(
            "finish", [](TakeWriter& self, WorldHandle& world) { check(self.finish(world.get())); },
            py::arg("world"), "Appends the end record and closes the file, synchronised with the disk.");
}

}  // namespace muster::python
