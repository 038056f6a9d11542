#include "overrides.h"

#include <cstdlib>

#include "engine/state/validation.h"
#include "muster/parameter_table.h"

namespace muster {

void Overrides::addTo(Subcommand& command) {
    command.option("--plan", plan, "Who makes the plans (plan.solver): exact or fast.")
        .oneOf({"exact", "fast"});
    command.option("--preset", preset, "Where parameters start from: units, people or paper.")
        .oneOf({"units", "people", "paper", "muster"});
    command.option("--set", settings, "Sets a parameter, as name=value; may be repeated.").oneValueEach();
}

Status Overrides::apply(WorldDef& def) const {
    Parameters& parameters = def.parameters;
    if (!preset.empty())
        if (Status s = usePreset(parameters, preset); !s.ok()) return s.within("--preset");
    if (!plan.empty()) parameters.plan.solver = plan == "fast" ? PlanSolver::Fast : PlanSolver::Exact;
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        const char* text = equals == std::string::npos ? "" : setting.c_str() + equals + 1;
        char* end = nullptr;
        const double value = std::strtod(text, &end);
        if (end == text || *end != '\0') {
            return invalidArgument("--set: found \"" + setting + "\", expected name=number");
        }
        if (Status s = setParameter(parameters, setting.substr(0, equals), value); !s.ok())
            return s.within("--set");
    }
    if (preset.empty() && settings.empty()) return {};
    return validateParameters(parameters, def.box).within(settings.empty() ? "--preset" : "--set");
}

}  // namespace muster
