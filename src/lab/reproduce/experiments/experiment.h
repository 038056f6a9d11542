// One experiment of the paper: its runs, its measurements and its criteria (SPEC section 6); and the makers
// of all experiments, one per file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lab/reproduce/experiments/samples.h"
#include "lab/reproduce/experiments/verdict.h"
#include "muster/status.h"

namespace muster {

/// Words of an experiment, for its chapter in the report.
struct ExperimentText {
    std::string id;     ///< "X4"
    std::string title;  ///< "Dense woodland"
    std::string paper;  ///< Result of the paper, with its section or figure.
    std::string scene;  ///< Our scene, and how it is measured.
    /// Name of its file under scenarios/paper without ".json"; of several files that to watch first.
    std::string scenario;
    /// Findings beyond the criteria; may be empty. Paragraphs end with a line break.
    std::string findings;
};

/// One way to run the scene, compared with the others. All arms run with all seeds.
struct Arm {
    /// Id such as "transport" or "fixed"; unique within the experiment together with the preset.
    std::string id;
    std::string title;              ///< Title above its column and under its pictures: "Transport".
    std::string preset = "muster";  ///< Parameters it starts from: "muster" or "paper".
};

/// A measured figure: a row of the table.
struct FigureInfo {
    std::string name;           ///< Name as in RunSample.
    std::string title;          ///< Title such as "last one there".
    std::string unit;           ///< Unit such as "s"; empty for counts.
    std::int32_t decimals = 2;  ///< Number of decimals that are shown.
};

/// A line of a chart.
struct ChartSeries {
    std::string title;         ///< Title in the legend.
    std::vector<Vec2> points;  ///< Points in the units of the axes.
    bool marksOnly = false;    ///< Points are shown without a line.
};

/// A chart of the report.
struct ChartDef {
    std::string title;                ///< One sentence that says what is to be seen.
    std::string xTitle;               ///< Title of the axis with its unit.
    std::string yTitle;               ///< Title of the axis with its unit.
    bool logX = false;                ///< The axis is logarithmic; all its values are > 0.
    bool logY = false;                ///< The axis is logarithmic; all its values are > 0.
    std::vector<ChartSeries> series;  ///< Series in the order of the legend.
};

/// One run that is asked for.
struct RunRequest {
    Arm arm;                 ///< The arm that is run.
    std::uint64_t seed = 1;  ///< Seed, from 1 on.
    bool film = false;       ///< Whether pictures are wanted.
    std::string folder;      ///< Folder of the paper's scenarios.
    /// Parameters by name, instead of the scenario's.
    std::vector<std::pair<std::string, double>> settings = {};
};

/// An experiment. Stateless: several threads run one experiment at the same time.
class Experiment {
public:
    virtual ~Experiment() = default;
    /// Title and texts.
    virtual ExperimentText text() const = 0;
    /// All arms. The criteria judge the first one.
    virtual std::vector<Arm> arms() const = 0;
    /// The rows of the experiment's table.
    virtual std::vector<FigureInfo> figures() const = 0;
    /// True where the experiment measures time, so that nothing else may run meanwhile.
    virtual bool timed() const { return false; }
    /// One run. Fails where its scenario cannot be read.
    virtual Result<RunSample> run(const RunRequest& request) const = 0;
    /// Judges the criteria.
    virtual void judge(const Samples& samples, Judge& judge) const = 0;
    /// Charts shown with the table; none by default.
    virtual std::vector<ChartDef> charts(const Samples& samples) const {
        (void)samples;
        return {};
    }
};

/// All experiments in their order: X1 to X11, X13.
std::vector<std::unique_ptr<Experiment>> paperExperiments();

std::unique_ptr<Experiment> makeControlsExperiment();    ///< X1
std::unique_ptr<Experiment> makeHalvesExperiment();      ///< X2
std::unique_ptr<Experiment> makeMetricExperiment();      ///< X3
std::unique_ptr<Experiment> makeWoodlandExperiment();    ///< X4
std::unique_ptr<Experiment> makeTrafficExperiment();     ///< X5
std::unique_ptr<Experiment> makeCourseExperiment();      ///< X6
std::unique_ptr<Experiment> makeThreePathsExperiment();  ///< X7
std::unique_ptr<Experiment> makeCongestionExperiment();  ///< X8
std::unique_ptr<Experiment> makeShapesExperiment();      ///< X9
std::unique_ptr<Experiment> makePacmanExperiment();      ///< X10
std::unique_ptr<Experiment> makeTransportExperiment();   ///< X11
std::unique_ptr<Experiment> makeScaleExperiment();       ///< X13

}  // namespace muster
