#include "experiments/catalogue.h"

namespace muster {

std::vector<std::unique_ptr<Experiment>> paperExperiments() {
    std::vector<std::unique_ptr<Experiment>> all;
    all.push_back(makeHalvesExperiment());
    return all;
}

}  // namespace muster
