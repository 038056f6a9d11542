#include "overrides.h"

#include <cstdint>
#include <cstdlib>

#include "engine/state/validation.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

constexpr std::uint64_t kLargestSeed = (std::uint64_t{1} << 53) - 1;  // As in scenario files.

}  // namespace

void Overrides::addTo(Subcommand& command) {
    command.option("--plan", plan, "Who makes the plans (plan.solver): exact or fast.")
        .oneOf({"exact", "fast"});
    command.option("--preset", preset, "Where parameters start from: units, people or paper.")
        .oneOf({"units", "people", "paper", "muster"});
    command.option("--seed", seed, "Seed of all random numbers, in the place of the file's.")
        .check([](const std::string& text) -> std::string {
            const bool whole = !text.empty() && text.size() <= 16 &&
                               text.find_first_not_of("0123456789") == std::string::npos;
            const bool good = whole && std::stoull(text) <= kLargestSeed;
            return good ? "" : "found " + text + ", expected a whole number from 0 to 2^53 - 1";
        });
    command.option("--set", settings, "Sets a parameter, as name=value; may be repeated.").oneValueEach();
}

Status Overrides::apply(WorldDef& def) const {
    Parameters& parameters = def.parameters;
    if (seed >= 0.0) def.seed = static_cast<std::uint64_t>(seed);
    if (!preset.empty())
        if (Status s = usePreset(parameters, preset); !s.ok()) return s.within("--preset");
    if (!plan.empty()) parameters.plan.solver = plan == "fast" ? PlanSolver::Fast : PlanSolver::Exact;
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        const char* text = equals == std::string::npos ? "" : setting.c_str() + equals + 1;
        char* end = nullptr;
        const double value = std::strtod(text, &end);
        if (end == text || *end != '\0')
            return invalidArgument("--set: found \"" + setting + "\", expected name=number");
        if (Status s = setParameter(parameters, setting.substr(0, equals), value); !s.ok())
            return s.within("--set");
    }
    if (preset.empty() && settings.empty()) return {};
    return validateParameters(parameters, def.box).within(settings.empty() ? "--preset" : "--set");
}

}  // namespace muster
