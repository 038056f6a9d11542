#include "scale/bench_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>

namespace muster::scale {
namespace {

template <class... Values>
std::string format(const char* pattern, Values... values) {
    char text[256];
    std::snprintf(text, sizeof text, pattern, values...);
    return text;
}

std::string hexadecimal(std::uint64_t value) {
    return format("%016llx", static_cast<unsigned long long>(value));
}

std::string key(const char* name) {
    return format("\"%s\": ", name);
}

std::string number(const char* name, double value, const char* pattern = "%.4g") {
    return key(name) + format(pattern, value) + ", ";
}

std::string text(const char* name, const std::string& value) {
    return key(name) + format("\"%s\", ", value.c_str());
}

std::string stagesJson(const Row& row) {
    std::string all = "{";
    for (std::size_t k = 0; k < row.stages.size(); ++k)
        all += (k > 0 ? ", " : "") + key(stepStages()[k].name.data()) + format("%.4f", row.stages[k]);
    return all + "}";
}

}  // namespace

std::string jsonRow(const Row& row) {
    const CaseDef& def = row.def;
    std::string line = format("{%s", text("scene", def.scene.name).c_str());
    line += text("regime", regimeName(def.scene.regime)) + number("n", def.scene.count, "%.0f") +
            text("plan", def.plan) + number("threads", def.threads, "%.0f") +
            number("seed", static_cast<double>(def.scene.seed), "%.0f") + number("steps", row.steps, "%.0f") +
            text("clock", def.threads == 1 ? "cpu" : "wall");
    line += number("ms_p50", row.p50) + number("ms_p95", row.p95) + number("ms_max", row.max) +
            number("cold_ms", row.cold) + number("wall_ms_p95", row.wallP95) + key("stages") +
            stagesJson(row) + ", ";
    line += text("judge", row.quality.judge) + number("looks", row.quality.looks, "%.0f");
    const bool judged = row.quality.looks > 0;
    line += judged ? number("gap_mean_pct", row.quality.gapMean) + number("gap_max_pct", row.quality.gapMax) +
                         number("objective", row.quality.objectiveMean)
                   : key("gap_mean_pct") + "null, " + key("gap_max_pct") + "null, ";
    line += row.quality.gapCold >= 0.0 ? number("gap_cold_pct", row.quality.gapCold)
                                       : key("gap_cold_pct") + "null, ";
    line += number("swaps_per_s", row.swaps) + number("lag_m", row.lagMean) + number("arrived", row.arrived) +
            number("allocations", static_cast<double>(row.allocations), "%.0f") +
            number("memory_mb", row.memory, "%.1f");
    if (row.exactRatio > 0.0) line += number("exact_ratio", row.exactRatio);
    return line + key("hash") + "\"" + hexadecimal(row.hash) + "\"}";
}

std::string tableHead() {
    return format("%-9s %-9s %6s %-5s %3s %4s %8s %8s %8s %8s %6s %7s %7s %6s %6s %6s %7s %s", "scene",
                  "regime", "n", "plan", "thr", "seed", "ms_p50", "ms_p95", "ms_max", "cold_ms", "judge",
                  "gap_m%", "gap_x%", "swaps", "lag_m", "alloc", "MB", "hash");
}

std::string tableRow(const Row& row) {
    const CaseDef& def = row.def;
    const bool judged = row.quality.looks > 0;
    std::string line = format("%-9s %-9s %6d %-5s %3d %4d ", def.scene.name.c_str(),
                              regimeName(def.scene.regime), def.scene.count, def.plan.c_str(), def.threads,
                              static_cast<int>(def.scene.seed));
    line += format("%8.3f %8.3f %8.3f %8.3f %6s ", row.p50, row.p95, row.max, row.cold,
                   row.quality.judge.c_str());
    line += judged ? format("%7.3f %7.3f ", row.quality.gapMean, row.quality.gapMax)
                   : format("%7s %7s ", "-", "-");
    line += format("%6.2f %6.2f %6lld %7.1f ", row.swaps, row.lagMean,
                   static_cast<long long>(row.allocations), row.memory);
    line += hexadecimal(row.hash);
    if (row.exactRatio > 0.0) line += format("  exact: %.1f times as long", row.exactRatio);
    return line;
}

std::string markdownHead() {
    return "| scene | regime | n | plan | threads | seed | p50 / p95 / max ms | cold ms | judge | gap mean / "
           "worst / cold % | "
           "swaps/s | allocations | MB |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|";
}

std::string markdownRow(const Row& row) {
    const CaseDef& def = row.def;
    const Quality& quality = row.quality;
    std::string line = format("| %s | %s | %d | %s | %d | %d ", def.scene.name.c_str(),
                              regimeName(def.scene.regime), def.scene.count, def.plan.c_str(), def.threads,
                              static_cast<int>(def.scene.seed));
    line += format("| %.3g / %.3g / %.3g | %.3g | %s ", row.p50, row.p95, row.max, row.cold,
                   quality.judge.c_str());
    line += quality.looks > 0
                ? format("| %.3f / %.3f / %.3g ", quality.gapMean, quality.gapMax, quality.gapCold)
                : "| - ";
    return line +
           format("| %.2f | %lld | %.0f |", row.swaps, static_cast<long long>(row.allocations), row.memory);
}

Growth growthOf(std::span<const Row> rows, Regime regime) {
    std::map<std::tuple<std::string, std::string, std::int32_t>, std::vector<const Row*>> series;
    for (const Row& row : rows)
        if (row.def.scene.regime == regime && row.p50 > 0.0)
            series[{row.def.scene.name, row.def.plan, row.def.threads}].push_back(&row);
    Growth growth;
    double xx = 0.0;
    double xy = 0.0;
    for (const auto& entry : series) {
        const std::vector<const Row*>& members = entry.second;
        const auto mean = [&](auto value) {
            double sum = 0.0;
            for (const Row* row : members) sum += value(*row);
            return sum / static_cast<double>(members.size());
        };
        const auto size = [](const Row& row) { return std::log(static_cast<double>(row.def.scene.count)); };
        const auto cost = [](const Row& row) { return std::log(row.p50); };
        const double meanSize = mean(size);
        const double meanCost = mean(cost);
        for (const Row* row : members) {
            xx += (size(*row) - meanSize) * (size(*row) - meanSize);
            xy += (size(*row) - meanSize) * (cost(*row) - meanCost);
            growth.least = growth.points == 0 ? row->def.scene.count
                                              : std::min(growth.least, row->def.scene.count);
            growth.most = std::max(growth.most, row->def.scene.count);
            ++growth.points;
        }
    }
    if (!(xx > 1e-9)) return {};
    growth.exponent = xy / xx;
    return growth;
}

}  // namespace muster::scale
