// The makers of the experiments, one per file.
#pragma once

#include <memory>

#include "lab/reproduce/experiments/experiment.h"

namespace muster {

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
