// One experiment of the paper: what is run, what is measured, what must be seen (SPEC section 6); and the
// makers of all experiments, one per file.
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
    std::string paper;  ///< What the paper shows, and where.
    std::string scene;  ///< Our scene, and how it is measured.
    /// Its file under scenarios/paper without ".json"; where several, the one to watch first.
    std::string scenario;
    /// What is learned beyond the criteria; may be empty. Paragraphs end with a line break.
    std::string findings;
};

/// What is compared: one way to run the scene. All arms run with all seeds.
struct Arm {
    /// "transport", "fixed"; unique within the experiment together with the preset.
    std::string id;
    std::string title;              ///< Above its column and under its pictures: "Transport".
    std::string preset = "muster";  ///< Parameters it starts from: "muster" or "paper".
};

/// A measured figure: a row of the table.
struct FigureInfo {
    std::string name;           ///< As in RunSample.
    std::string title;          ///< "last one there"
    std::string unit;           ///< "s"; empty for counts.
    std::int32_t decimals = 2;  ///< Shown.
};

/// A line of a chart.
struct ChartSeries {
    std::string title;         ///< In the legend.
    std::vector<Vec2> points;  ///< In the axes' units.
    bool marksOnly = false;    ///< Points without a line.
};

/// A chart of the report.
struct ChartDef {
    std::string title;                ///< One sentence: what is to be seen.
    std::string xTitle;               ///< With its unit.
    std::string yTitle;               ///< With its unit.
    bool logX = false;                ///< Logarithmic axis; all its values > 0.
    bool logY = false;                ///< Logarithmic axis; all its values > 0.
    std::vector<ChartSeries> series;  ///< In the order of the legend.
};

/// One run that is asked for.
struct RunRequest {
    Arm arm;                 ///< Which way.
    std::uint64_t seed = 1;  ///< From 1.
    bool film = false;       ///< Pictures are wanted.
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
    /// The arms that are compared. The first is the one that is judged.
    virtual std::vector<Arm> arms() const = 0;
    /// The rows of its table.
    virtual std::vector<FigureInfo> figures() const = 0;
    /// True where it measures time, so that nothing else may run meanwhile.
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
