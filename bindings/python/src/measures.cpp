// muster._core.TrajectoryData and RegionData: measures of trajectories (muster.measure).
#include <limits>

#include "array_view.h"
#include "engine/world/inspect.h"
#include "files/export/formats.h"
#include "from_python.h"
#include "lab/measures/crossings.h"
#include "lab/measures/recording.h"
#include "lab/measures/series.h"
#include "lab/measures/speeds.h"
#include "lab/measures/voronoi.h"
#include "python_world.h"
#include "to_python.h"

namespace muster::python {
namespace {

template <class T>
py::array_t<T> arrayOf(const std::vector<T>& values) {
    return py::array_t<T>(static_cast<py::ssize_t>(values.size()), values.data());
}

std::vector<Vec2> pointsFrom(const py::object& given, const char* name) {
    std::vector<Vec2> points;
    FromPython(name).read(given, points);
    return points;
}

/// Reads one column of the sightings by `pick`.
template <class T, class Pick>
py::array_t<T> columnOf(const Trajectories& all, const Pick& pick) {
    py::array_t<T> column(static_cast<py::ssize_t>(all.all().size()));
    T* into = column.mutable_data();
    for (const Sighting& s : all.all()) *into++ = pick(s);
    return column;
}

using Speeds = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<double> speedsFrom(const Speeds& given, const Trajectories& all) {
    if (static_cast<std::size_t>(given.size()) != all.all().size() && given.size() != 0)
        throw py::value_error("speeds: found " + std::to_string(given.size()) +
                              ", expected one per sighting, " + std::to_string(all.all().size()));
    return {given.data(), given.data() + given.size()};
}

Recording recordingFrom(double frameRate, const py::array_t<std::int32_t, py::array::forcecast>& frames,
                        const py::array_t<std::uint32_t, py::array::forcecast>& ids,
                        const py::object& positions) {
    const std::vector<Vec2> places = pointsFrom(positions, "positions");
    if (static_cast<std::size_t>(frames.size()) != places.size() || ids.size() != frames.size())
        throw py::value_error("frames, ids and positions: found different lengths");
    std::vector<Sighting> all;
    for (std::size_t i = 0; i < places.size(); ++i)
        all.push_back(
            {frames.at(static_cast<py::ssize_t>(i)), ids.at(static_cast<py::ssize_t>(i)), places[i]});
    return {take(Trajectories::create(frameRate, std::move(all))), {}};
}

py::tuple crossingsOf(const Recording& self, const py::object& a, const py::object& b, int direction,
                      bool first) {
    Line line;
    FromPython("line").read(a, line.a);
    FromPython("line").read(b, line.b);
    auto found = crossings(self.trajectories, line);
    if (first) {
        found = firstCrossings(found, direction);
    } else if (direction != 0) {
        std::erase_if(found, [direction](const Crossing& c) { return c.direction != direction; });
    }
    std::vector<std::uint32_t> ids;
    std::vector<std::int32_t> frames, directions;
    std::vector<double> times;
    std::vector<Vec2> points;
    for (const Crossing& c : found) {
        ids.push_back(c.id);
        frames.push_back(c.frame);
        times.push_back(c.time);
        directions.push_back(c.direction);
        points.push_back(c.point);
    }
    return py::make_tuple(arrayOf(ids), arrayOf(frames), arrayOf(times), arrayOf(directions),
                          pointArray(points));
}

SpeedBorder borderFrom(const std::string& word) {
    if (word == "adaptive") return SpeedBorder::Adaptive;
    if (word == "single") return SpeedBorder::SingleSided;
    if (word == "exclude") return SpeedBorder::Exclude;
    throw py::value_error("border: found \"" + word + "\", expected adaptive, single or exclude");
}

py::array_t<double> speedsOf(const Recording& self, std::int32_t step, const std::string& border,
                             const py::object& direction, double period) {
    if (step < 1) throw py::value_error("frame_step: found " + std::to_string(step) + ", expected 1 or more");
    SpeedDef def{step, borderFrom(border), {}, period};
    if (!direction.is_none()) FromPython("direction").read(direction, def.direction.emplace());
    return arrayOf(personalSpeeds(self.trajectories, def));
}

py::tuple voronoiOf(const Recording& self, const Region& walkable, const Region& area, double cutOff,
                    std::int32_t quadSegments, const Speeds& given) {
    if (quadSegments < 1 || quadSegments > 100) throw py::value_error("quad_segments: expected 1 to 100");
    const auto speeds = speedsFrom(given, self.trajectories);
    VoronoiSeries series;
    {
        const py::gil_scoped_release others;
        series = voronoiSeries(self.trajectories, walkable, area, {cutOff, quadSegments}, speeds);
    }
    return py::make_tuple(arrayOf(series.density), arrayOf(series.speed));
}

py::array_t<double> cellAreasOf(const Recording& self, std::int32_t frame, const Region& walkable,
                                double cutOff, std::int32_t quadSegments) {
    const std::int32_t index = frame - self.trajectories.firstFrame();
    if (index < 0 || index >= self.trajectories.frameCount()) throw py::index_error("there is no such frame");
    std::vector<double> areas;
    for (const VoronoiCell& cell :
         voronoiCells(self.trajectories.frame(index), walkable, {cutOff, quadSegments}))
        areas.push_back(cell.area);
    return arrayOf(areas);
}

py::tuple headwaysOf(const Recording& self, double period, bool backwards) {
    std::vector<std::int64_t> rows;
    std::vector<std::uint32_t> ahead;
    std::vector<double> distances;
    for (const FileHeadway& h : headways(self.trajectories, period, backwards)) {
        rows.push_back(static_cast<std::int64_t>(h.sighting));
        ahead.push_back(h.ahead);
        distances.push_back(h.distance);
    }
    return py::make_tuple(arrayOf(rows), arrayOf(ahead), arrayOf(distances));
}

void defineTrajectoryData(py::module_& module) {
    py::class_<Recording> type(module, "TrajectoryData");
    type.def_static(
        "load", [](const py::object& path, double rate) { return take(readRecording(pathFrom(path), rate)); },
        py::arg("path"), py::arg("frame_rate"));
    type.def_static("make", &recordingFrom, py::arg("frame_rate"), py::arg("frames"), py::arg("ids"),
                    py::arg("positions"));
    type.def_property_readonly("frame_rate",
                               [](const Recording& self) { return self.trajectories.frameRate(); });
    type.def_property_readonly("first_frame",
                               [](const Recording& self) { return self.trajectories.firstFrame(); });
    type.def_property_readonly("frame_count",
                               [](const Recording& self) { return self.trajectories.frameCount(); });
    type.def_property_readonly("walkable", [](const Recording& self) {
        return self.walkable ? py::cast(*self.walkable) : py::object(py::none());
    });
    type.def_property_readonly("frames", [](const Recording& self) {
        return columnOf<std::int32_t>(self.trajectories, [](const Sighting& s) { return s.frame; });
    });
    type.def_property_readonly("ids", [](const Recording& self) {
        return columnOf<std::uint32_t>(self.trajectories, [](const Sighting& s) { return s.id; });
    });
    type.def_property_readonly("positions", [](const Recording& self) {
        std::vector<Vec2> points;
        for (const Sighting& s : self.trajectories.all()) points.push_back(s.position);
        return pointArray(points);
    });
    type.def("crossings", &crossingsOf, py::arg("a"), py::arg("b"), py::arg("direction"), py::arg("first"));
    type.def("speeds", &speedsOf, py::arg("frame_step"), py::arg("border"), py::arg("direction"),
             py::arg("period"));
    type.def(
        "classic_density",
        [](const Recording& self, const Region& area) {
            return arrayOf(classicDensity(self.trajectories, area));
        },
        py::arg("area"));
    type.def(
        "mean_speed",
        [](const Recording& self, const Region& area, const Speeds& speeds) {
            return arrayOf(meanSpeed(self.trajectories, area, speedsFrom(speeds, self.trajectories)));
        },
        py::arg("area"), py::arg("speeds"));
    type.def("voronoi", &voronoiOf, py::arg("walkable"), py::arg("area"), py::arg("cut_off"),
             py::arg("quad_segments"), py::arg("speeds"));
    type.def("cell_areas", &cellAreasOf, py::arg("frame"), py::arg("walkable"), py::arg("cut_off"),
             py::arg("quad_segments"));
    type.def("headways", &headwaysOf, py::arg("period"), py::arg("backwards"));
    type.def("last_seen", [](const Recording& self) { return arrayOf(lastSeen(self.trajectories)); });
}

}  // namespace

void defineMeasures(py::module_& module) {
    py::class_<Region> region(module, "RegionData");
    region.def_static(
        "polygon",
        [](const py::object& corners) { return take(Region::create(pointsFrom(corners, "polygon"))); },
        py::arg("corners"));
    region.def_static(
        "parse", [](const std::string& text) { return take(Region::parse(text)); }, py::arg("text"));
    region.def_static(
        "of_world",
        [](const py::object& world) {
            return take(Region::parse(walkableArea(inspect::environment(worldOf(world)))));
        },
        py::arg("world"));
    region.def_property_readonly("area", &Region::area);
    region.def(
        "contains",
        [](const Region& self, const py::object& point) {
            Vec2 p;
            FromPython("point").read(point, p);
            return self.contains(p);
        },
        py::arg("point"));
    defineTrajectoryData(module);
    module.def(
        "steady_state",
        [](const Speeds& values) {
            const SteadyState steady = steadyState({values.data(), static_cast<std::size_t>(values.size())});
            return py::make_tuple(steady.begin, steady.end, steady.mean);
        },
        py::arg("values"), "The steady part of a series: begin, end and mean (muster.measure).");
}

}  // namespace muster::python
