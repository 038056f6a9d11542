#include "lab/verify/report/words.h"

#include <cmath>

#include "files/report/markup.h"

namespace muster {
namespace {

std::string unitText(const std::string& unit) {
    return unit.empty() ? "" : (unit[0] == '/' ? unit : " " + unit);
}

}  // namespace

std::string limitsText(const VerifyCheck& check) {
    const bool low = std::isfinite(check.low), high = std::isfinite(check.high);
    const auto number = [&](double limit) { return plainNumber(limit); };
    if (low && high && check.low == check.high) return number(check.low) + unitText(check.unit);
    if (low && high) return number(check.low) + " to " + number(check.high) + unitText(check.unit);
    if (low) return "at least " + number(check.low) + unitText(check.unit);
    if (high) return "at most " + number(check.high) + unitText(check.unit);
    return "-";
}

std::string valueText(const VerifyCheck& check) {
    if (!std::isfinite(check.value)) return "no value";
    if (check.value != 0.0 && std::abs(check.value) < 1e-4)
        return fixedNumber(check.value, 4) + unitText(check.unit);
    std::string number = plainNumber(check.value);
    if (std::isfinite(check.high) && check.value > check.high) number = judgedNumber(check.value, check.high);
    if (std::isfinite(check.low) && check.value < check.low) number = judgedNumber(check.value, check.low);
    return number + unitText(check.unit);
}

std::string decisiveText(const RowResult& row) {
    if (row.outcome == Outcome::Missing) return row.row.missing;
    const VerifyCheck* chosen = nullptr;
    std::size_t binding = 0, failed = 0;
    for (const VerifyCheck& check : row.report.checks) {
        if (!check.binding) continue;
        ++binding;
        if (!check.pass()) ++failed;
        if (chosen == nullptr || (chosen->pass() && !check.pass())) chosen = &check;
    }
    if (chosen == nullptr) return "nothing was judged";
    std::string text = chosen->what + ": " + valueText(*chosen) + " (" + limitsText(*chosen) +
                       (chosen->whose == Whose::Own ? ", [own]" : "") + ")";
    if (failed > 1) text += "; " + std::to_string(failed) + " of " + std::to_string(binding) + " fail";
    return text;
}

}  // namespace muster
