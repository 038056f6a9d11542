#include "lab/study/models/model_trial.h"

namespace muster {

Result<ModelTrial> runModelTrial(const TrialDef& def, const std::string& setting) {
    const auto parameters = operatorSetting(setting);
    if (!parameters.ok()) return parameters.status();
    auto made = Trial::create(def);
    if (!made.ok()) return made.status();
    Trial trial = std::move(made).value();
    OperatorModel model(trial, parameters.value(), def.seed);
    while (!trial.over()) {
        model.direct(trial);
        trial.step();
    }
    ModelTrial done{.result = trial.result(),
                    .misses = model.misses(),
                    .orders = model.commands(),
                    .operatorSeconds = model.busySeconds()};
    done.decisions.assign(model.decisions().begin(), model.decisions().end());
    done.inputs.assign(trial.inputs().begin(), trial.inputs().end());
    return done;
}

}  // namespace muster
