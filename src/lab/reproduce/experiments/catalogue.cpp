#include "lab/reproduce/experiments/experiment.h"

namespace muster {

std::vector<std::unique_ptr<Experiment>> paperExperiments() {
    std::vector<std::unique_ptr<Experiment>> all;
    all.push_back(makeControlsExperiment());
    all.push_back(makeHalvesExperiment());
    all.push_back(makeMetricExperiment());
    all.push_back(makeWoodlandExperiment());
    all.push_back(makeTrafficExperiment());
    all.push_back(makeCourseExperiment());
    all.push_back(makeThreePathsExperiment());
    all.push_back(makeCongestionExperiment());
    all.push_back(makeShapesExperiment());
    all.push_back(makePacmanExperiment());
    all.push_back(makeTransportExperiment());
    all.push_back(makeScaleExperiment());
    return all;
}

}  // namespace muster
