// muster measure
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/text_file.h"
#include "lab/measures/crossings.h"
#include "lab/measures/recording.h"
#include "lab/measures/series.h"
#include "lab/measures/speeds.h"
#include "lab/measures/voronoi.h"
#include "lab_commands.h"
#include "lab_commands_list.h"
#include "report.h"

namespace muster {
namespace {

struct TrajectoryOptions {
    std::string file, ground;
    std::vector<std::string> lines, areas;
    double fps = 0.0, cutOff = 0.0, reaches = -1.0, period = 0.0;
    int frameStep = 5;
    bool singleFile = false, json = false, csv = false;
};

/// "1,2,3,4" as points; none where it is something else.
std::optional<std::vector<Vec2>> pointsIn(const std::string& text) {
    std::vector<double> numbers;
    const char* at = text.c_str();
    while (true) {
        char* end = nullptr;
        numbers.push_back(std::strtod(at, &end));
        if (end == at || !std::isfinite(numbers.back())) return std::nullopt;
        if (*end == '\0') break;
        if (*end != ',') return std::nullopt;
        at = end + 1;
    }
    if (numbers.size() % 2 != 0) return std::nullopt;
    std::vector<Vec2> points;
    for (std::size_t k = 0; k < numbers.size(); k += 2) points.push_back({numbers[k], numbers[k + 1]});
    return points;
}

/// Two points are the corners of a rectangle, more those of a polygon; or well-known text.
Result<Region> areaIn(const std::string& text) {
    const auto points = pointsIn(text);
    if (!points) return Region::parse(text);
    if (points->size() < 2) return invalidArgument("found one point, expected x1,y1,x2,y2 or a polygon");
    const Vec2 a = points->front(), b = points->back();
    return points->size() == 2 ? Region::create({a, {b.x, a.y}, b, {a.x, b.y}}) : Region::create(*points);
}

struct LineMeasured {
    Line line;
    std::vector<Crossing> right, left;  // First crossings.
    std::vector<std::int32_t> countRight, countLeft;

    std::size_t length() const { return right.size() + left.size(); }
};

struct AreaMeasured {
    Region area;
    std::vector<double> density, speed;  // Classic.
    VoronoiSeries voronoi;
};

struct Measurement {
    Recording recording;
    std::vector<LineMeasured> lines;
    std::vector<AreaMeasured> areas;
    std::vector<double> lastSeen, headways;
};

/// A box round all positions, where the ground is not known.
Region groundOf(const Trajectories& all) {
    Box box{{0, 0}, {1, 1}};
    if (!all.all().empty()) box = {all.all()[0].position, all.all()[0].position};
    for (const Sighting& s : all.all())
        box = {{std::min(box.min.x, s.position.x), std::min(box.min.y, s.position.y)},
               {std::max(box.max.x, s.position.x), std::max(box.max.y, s.position.y)}};
    box = box.grown(0.5);
    return Region::create({box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}).value();
}

Result<Region> chosenGround(const TrajectoryOptions& options, const Recording& recording) {
    if (options.ground.empty())
        return recording.walkable ? *recording.walkable : groundOf(recording.trajectories);
    std::string text = options.ground;
    if (const auto file = readTextFile(text); file.ok()) text = *file;
    auto ground = areaIn(text);
    return ground.ok() ? std::move(ground) : Result<Region>(ground.status().within("--ground"));
}

Result<Measurement> measureAll(const TrajectoryOptions& options) {
    auto recording = readRecording(options.file, options.fps);
    if (!recording.ok()) return recording.status();
    Measurement measured{std::move(recording).value(), {}, {}, {}, {}};
    const Trajectories& all = measured.recording.trajectories;
    const SpeedDef speedDef{.frameStep = options.frameStep, .period = options.period};
    const auto speeds = personalSpeeds(all, speedDef);
    for (const std::string& text : options.lines) {
        const auto ends = pointsIn(text);
        if (!ends || ends->size() != 2 || (*ends)[0] == (*ends)[1])
            return invalidArgument("--line: found \"" + text + "\", expected x1,y1,x2,y2");
        LineMeasured line{{(*ends)[0], (*ends)[1]}, {}, {}, {}, {}};
        const auto crossed = crossings(all, line.line);
        line.right = firstCrossings(crossed, 1);
        line.left = firstCrossings(crossed, -1);
        line.countRight = crossedByFrame(all, line.right);
        line.countLeft = crossedByFrame(all, line.left);
        measured.lines.push_back(std::move(line));
    }
    if (!options.areas.empty()) {
        const auto ground = chosenGround(options, measured.recording);
        if (!ground.ok()) return ground.status();
        for (const std::string& text : options.areas) {
            auto area = areaIn(text);
            if (!area.ok()) return area.status().within("--area");
            measured.areas.push_back({*area, classicDensity(all, *area), meanSpeed(all, *area, speeds),
                                      voronoiSeries(all, *ground, *area, {options.cutOff, 3}, speeds)});
        }
    }
    measured.lastSeen = lastSeen(all);
    if (options.singleFile)
        for (const FileHeadway& h : headways(all, options.period)) measured.headways.push_back(h.distance);
    return measured;
}

Json numberOrNull(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json flowJson(const std::vector<Crossing>& crossed, double width) {
    const double flow = meanFlow(crossed);
    return {{"crossed", crossed.size()},
            {"first_s", crossed.empty() ? Json(nullptr) : Json(crossed.front().time)},
            {"last_s", crossed.empty() ? Json(nullptr) : Json(crossed.back().time)},
            {"flow_per_s", numberOrNull(flow)},
            {"specific_flow_per_s_m", numberOrNull(flow / width)}};
}

Json seriesJson(const std::vector<double>& values, const Trajectories& all) {
    const SteadyState steady = steadyState(values);
    const auto time = [&](std::size_t index) {
        return all.timeOf(all.firstFrame() + static_cast<std::int32_t>(index));
    };
    return {{"mean", numberOrNull(meanOf(values).mean)},
            {"deviation", numberOrNull(meanOf(values).deviation)},
            {"most", values.empty() ? Json(nullptr) : Json(*std::max_element(values.begin(), values.end()))},
            {"steady_mean", numberOrNull(steady.mean)},
            {"steady_from_s", time(steady.begin)},
            {"steady_to_s", time(steady.end)}};
}

double quantile(const std::vector<double>& sorted, double share) {
    if (sorted.empty()) return kUnmeasured;
    return sorted[static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size()))) - 1];
}

Json summaryJson(const Measurement& measured, const TrajectoryOptions& options) {
    const Trajectories& all = measured.recording.trajectories;
    Json lines = Json::array(), areas = Json::array();
    for (const LineMeasured& line : measured.lines)
        lines.push({{"to_the_right", flowJson(line.right, distance(line.line.a, line.line.b))},
                    {"to_the_left", flowJson(line.left, distance(line.line.a, line.line.b))}});
    for (const AreaMeasured& area : measured.areas) {
        Json one = {{"area_m2", area.area.area()},
                    {"density_classic", seriesJson(area.density, all)},
                    {"speed_mean", seriesJson(area.speed, all)},
                    {"density_voronoi", seriesJson(area.voronoi.density, all)},
                    {"speed_voronoi", seriesJson(area.voronoi.speed, all)}};
        if (options.reaches >= 0.0) {
            const std::size_t at = firstReaching(area.voronoi.density, options.reaches);
            one["reaches_s"] = at == area.voronoi.density.size()
                                   ? Json(nullptr)
                                   : Json(all.timeOf(all.firstFrame() + static_cast<std::int32_t>(at)));
        }
        areas.push(std::move(one));
    }
    Json summary = {{"persons", all.persons().size()},
                    {"frames", all.frameCount()},
                    {"frame_rate", all.frameRate()},
                    {"lines", lines},
                    {"areas", areas},
                    {"last_seen_s",
                     {{"half", numberOrNull(quantile(measured.lastSeen, 0.5))},
                      {"95_percent", numberOrNull(quantile(measured.lastSeen, 0.95))},
                      {"all", numberOrNull(quantile(measured.lastSeen, 1.0))}}}};
    if (!measured.headways.empty())
        summary["headway_m"] = {{"mean", meanOf(measured.headways).mean},
                                {"deviation", meanOf(measured.headways).deviation}};
    return summary;
}

/// Prints a value of JSON as indented lines "name  value".
void printLines(const Json& value, int depth) {
    for (const Json::Member& member : value.members()) {
        if (member.value.isArray()) {
            for (std::size_t k = 0; k < member.value.size(); ++k) {
                std::printf("%*s%s %zu\n", 2 * depth, "", member.key.c_str(), k + 1);
                printLines(member.value[k], depth + 1);
            }
        } else if (member.value.isObject()) {
            std::printf("%*s%s\n", 2 * depth, "", member.key.c_str());
            printLines(member.value, depth + 1);
        } else if (member.value.isNumber()) {
            std::printf("%*s%-*s%.6g\n", 2 * depth, "", 28 - 2 * depth, member.key.c_str(),
                        member.value.number());
        } else {
            std::printf("%*s%-*s-\n", 2 * depth, "", 28 - 2 * depth, member.key.c_str());
        }
    }
}

void printCsv(const Measurement& measured) {
    std::printf("t");
    for (std::size_t k = 1; k <= measured.lines.size(); ++k) std::printf(",line%zu_right,line%zu_left", k, k);
    for (std::size_t k = 1; k <= measured.areas.size(); ++k)
        std::printf(
            ",area%zu_density_classic,area%zu_speed_mean,area%zu_density_voronoi,area%zu_speed_voronoi", k, k,
            k, k);
    std::printf(",persons\n");
    const Trajectories& all = measured.recording.trajectories;
    for (std::int32_t f = 0; f < all.frameCount(); ++f) {
        std::printf("%.9g", all.timeOf(all.firstFrame() + f));
        for (const LineMeasured& line : measured.lines)
            std::printf(",%d,%d", line.countRight[f], line.countLeft[f]);
        for (const AreaMeasured& area : measured.areas)
            std::printf(",%.9g,%.9g,%.9g,%.9g", area.density[f], area.speed[f], area.voronoi.density[f],
                        area.voronoi.speed[f]);
        std::printf(",%zu\n", all.frame(f).size());
    }
}

int runMeasure(const TrajectoryOptions& options) {
    const auto measured = measureAll(options);
    if (!measured.ok()) return reportFailure(measured.status());
    if (options.csv) {
        printCsv(*measured);
    } else if (options.json) {
        printJsonValue(summaryJson(*measured, options));
    } else {
        printLines(summaryJson(*measured, options), 0);
    }
    return kExitOk;
}

}  // namespace

void addMeasureCommand(CommandLine& line) {
    Subcommand command = line.add(kMeasureCommand.name, kMeasureCommand.about);
    auto options = std::make_shared<TrajectoryOptions>();
    command
        .option("TRAJECTORY", options->file,
                "CSV of muster play, text of PedPy or JuPedSim, or SQLite of JuPedSim.")
        .required();
    command
        .option("--line", options->lines,
                "x1,y1,x2,y2 [m]: who crosses it, when, which way; may be repeated.")
        .oneValueEach();
    command
        .option("--area", options->areas,
                "Two corners x1,y1,x2,y2 of a rectangle, or those of a polygon [m], or WKT; may be repeated.")
        .oneValueEach();
    command.option("--ground", options->ground,
                   "Walkable area for Voronoi cells: as an area, or a file with WKT; else the file's.");
    command.option("--cut-off", options->cutOff, "Radius beyond which Voronoi cells end [m]; 0 for none.")
        .finite(0.0, 1e6);
    command
        .option("--frame-step", options->frameStep,
                "Speeds are measured from so many frames before to so many after.")
        .range(1, 100000);
    command
        .option("--reaches", options->reaches,
                "Tells when the Voronoi density of each area first reaches this [1/m2].")
        .finite(0.0, 1e6);
    command.option("--period", options->period, "Length of ground that is joined in x [m]; 0 for none.")
        .finite(0.0, 1e9);
    command.option("--fps", options->fps, "Frame rate of a text that names none.").finite(0.0, 1e6);
    command.flag("--single-file", options->singleFile, "Tells the distances to the one ahead, in x.");
    const Option json = command.flag("--json", options->json, "One JSON value on standard output.");
    command.flag("--csv", options->csv, "The series of all frames as CSV on standard output.").excludes(json);
    command.footer(
        "Definitions are those of PedPy (docs/people.md).\n"
        "Examples:\n"
        "  muster measure run.csv --line 10,0,10,2\n"
        "  muster measure run.sqlite --area 4,0,6,2 --cut-off 1.2 --json\n"
        "  muster measure ring.txt --area 5,1,7,3 --ground 0,0,20,4 --period 20 --csv");
    command.run([options] { return runMeasure(*options); });
}

}  // namespace muster
