#include "studio/study/runs/run_plan.h"

#include <utility>

#include "studio/gestures/control_scheme.h"

namespace muster {
namespace {

// First row of a balanced Latin square of four; row r adds r (Williams 1949).
constexpr std::array<std::int32_t, 4> kFirstRow{0, 1, 3, 2};
// Layouts of people begin here, far from those of models.
constexpr std::uint64_t kFirstSeed = 20'000'000;
constexpr std::uint64_t kFirstPracticeSeed = 2'000'000'000;

Status check(const PeopleSettings& settings, std::int64_t number) {
    if (number < 0 || number > 100'000'000)
        return invalidArgument("The run's number is " + std::to_string(number) +
                               "; it must be 0 to 100000000.");
    const auto scheme = namedScheme(settings.mouse);
    if (!scheme.ok()) return scheme.status();
    if (scheme.value().def.kind == SchemeKind::Touch)
        return invalidArgument("'" + settings.mouse +
                               "' is no mouse; touch is compared with one of the mice.");
    if (settings.crowd < 1 || settings.crowd > 400)
        return invalidArgument("The crowd is " + std::to_string(settings.crowd) + "; it must be 1 to 400.");
    return {};
}

}  // namespace

Result<PeoplePlan> planPeople(const PeopleSettings& settings, std::int64_t number) {
    if (const Status status = check(settings, number); !status.ok()) return status;
    const auto row = static_cast<std::int32_t>(number % 4);
    const bool mouseFirst = number / 4 % 2 == 1;
    PeoplePlan plan;
    plan.order = row + (mouseFirst ? 4 : 0);
    plan.schemes = {"touch", settings.mouse};
    if (mouseFirst) std::swap(plan.schemes[0], plan.schemes[1]);
    // Rows 0 and 1 against 2 and 3: not to be confused with the environment, its place or the block.
    const bool touchMirrored = (row / 2 + number / kPeopleOrders) % 2 == 1;
    const auto environments = studyEnvironments();
    for (std::int32_t period = 1; period <= 2; ++period) {
        const std::string& scheme = plan.schemes[static_cast<std::size_t>(period - 1)];
        const bool mirrored = (scheme == "touch") == touchMirrored;
        const auto run = static_cast<std::uint64_t>(number);
        plan.trials.push_back(
            {{std::string(environments[0].name), settings.crowd, scheme, kFirstPracticeSeed + run, mirrored},
             true,
             period,
             0});
        for (std::int32_t place = 0; place < 4; ++place) {
            const auto index = static_cast<std::size_t>((kFirstRow[static_cast<std::size_t>(place)] + row) %
                                                        4);
            plan.trials.push_back({{std::string(environments[index].name), settings.crowd, scheme,
                                    kFirstSeed + 4 * run + index, mirrored},
                                   false,
                                   period,
                                   place + 1});
        }
    }
    return plan;
}

}  // namespace muster
