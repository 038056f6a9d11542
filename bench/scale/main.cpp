// muster-bench: what a step costs at scale, and how good its plans are.
#include <cstdio>
#include <exception>

#include "scale/bench_options.h"
#include "scale/bench_report.h"
#include "scale/quality.h"

namespace muster::scale {
namespace {

constexpr std::int32_t kMaxExact = 1000;  // Largest crowd for which the exact plan is timed too.
constexpr std::int32_t kMaxQuick = 500;   // Largest far crowd that --quick judges.
constexpr double kExactSeconds = 1.0;     // World time of the run with the exact plan, which is slow [s].

void printHead(const Options& options) {
    if (options.json) return;
    std::printf("Times of whole steps: the thread's CPU time with one thread, wall time with more.\n\n%s\n",
                options.markdown ? markdownHead().c_str() : tableHead().c_str());
}

std::string lineOf(const Options& options, const Row& row) {
    return options.json ? jsonRow(row) : options.markdown ? markdownRow(row) : tableRow(row);
}

void printGrowth(const Options& options, const std::vector<Row>& rows) {
    if (options.json) return;
    for (const Regime regime : {Regime::Far, Regime::Tracking}) {
        const Growth growth = growthOf(rows, regime);
        if (growth.points == 0) continue;
        std::printf("\n%s: the cost of a step grows as n^%.2f from %d to %d characters (p50, %d rows)\n",
                    regimeName(regime), growth.exponent, growth.least, growth.most, growth.points);
    }
}

// Judging happens in a second run, so that it does not change the times. Both runs must end in the same
// state.
Status judge(const Options& options, Row& row, ThreadPool& pool) {
    const SceneDef& scene = row.def.scene;
    const std::string label = scene.name + " " + regimeName(scene.regime) + " " + std::to_string(scene.count);
    QualityPass pass(looksEvery(options.gapEvery, scene), label, pool);
    const Result<Row> again = runCase(row.def, [&](const World& world) { pass.observe(world); });
    if (!again.ok()) return again.status();
    if (!pass.status().ok())
        std::fprintf(stderr, "muster-bench: %s: not judged: %s\n", label.c_str(),
                     pass.status().message().c_str());
    row.quality = pass.quality();
    if (again->hash != row.hash)
        return Status(StatusCode::Corrupt, label + ": the run that was judged ended in another state");
    return {};
}

// Ratio of step times with the exact plan to those of the row, from a shorter run.
double exactRatio(const Row& row) {
    CaseDef def = row.def;
    if (def.plan == "exact" || def.scene.count > kMaxExact) return 0.0;
    def.plan = "exact";
    def.seconds = kExactSeconds;
    const Result<Row> exact = runCase(def);
    return exact.ok() && row.p50 > 0.0 ? exact->p50 / row.p50 : 0.0;
}

Result<Row> measure(const Options& options, const CaseDef& def, ThreadPool& pool) {
    Result<Row> row = runCase(def);
    if (!row.ok()) return row;
    if (options.exact) row->exactRatio = exactRatio(*row);
    const bool tooLong = options.quick && def.scene.regime == Regime::Far && def.scene.count > kMaxQuick;
    if (options.noGap || tooLong) return row;
    if (const Status status = judge(options, *row, pool); !status.ok()) return status;
    return row;
}

int run(const Options& options) {
    ThreadPool pool(0);
    const auto cases = casesOf(options);
    printHead(options);
    std::vector<Row> rows;
    int exitCode = 0;
    for (const CaseDef& def : *cases) {
        const Result<Row> row = measure(options, def, pool);
        if (!row.ok()) {
            std::fprintf(stderr, "muster-bench: skipped: %s %s %d: %s\n", def.scene.name.c_str(),
                         regimeName(def.scene.regime), def.scene.count, row.status().message().c_str());
            if (row.status().code() != StatusCode::NotFound) exitCode = 1;
            continue;
        }
        std::printf("%s\n", lineOf(options, *row).c_str());
        std::fflush(stdout);
        rows.push_back(*row);
    }
    printGrowth(options, rows);
    return exitCode;
}

std::string ordersText(const OrdersDef& def, const OrdersRow& row) {
    char text[400];
    std::snprintf(
        text, sizeof(text),
        "%d characters in %d groups, %d obstacles, %d gaps: step p50 %.2f, p95 %.2f, first %.1f, worst "
        "%.1f ms (step %d: %s), with an order at most %.2f ms above others; longest wait %.2f s; hash "
        "%016llx\n",
        def.count, def.groups, def.obstacles, def.gaps, row.p50, row.p95, row.first, row.worst, row.worstStep,
        row.worstStages.c_str(), row.above, row.longestWait, static_cast<unsigned long long>(row.hash));
    return text;
}

/// Prints what was measured, or the sentence that says why nothing was.
template <class Measured, class Text>
int report(const Result<Measured>& measured, const Text& text) {
    if (!measured.ok()) {
        std::fprintf(stderr, "muster-bench: %s\n", measured.status().message().c_str());
        return 1;
    }
    std::printf("%s", text(*measured).c_str());
    return 0;
}

int runLed(const LedGroundDef& def) {
    const Result<LedGroundRow> row = runLedGround(def);
    const bool noMap = row.status().code() == StatusCode::NotFound;
    const int code = report(row, ledGroundText);
    return noMap || (code == 0 && row->arrived >= 0.0) ? 0 : 1;
}

int runSubcommand(const Options& o) {
    if (o.command == "ground" && o.lead) return runLed(o.ground);
    if (o.command == "ground") return report(runLargeGround(o.ground.ground), largeGroundText);
    if (o.command == "people") return report(measurePeople(o.people), peopleText);
    if (o.command == "battle")
        return report(measureBattle(o.battle),
                      [&](const BattleRow& row) { return battleText(o.battle, row); });
    if (o.command == "orders")
        return report(measureOrders(o.orders),
                      [&](const OrdersRow& row) { return ordersText(o.orders, row); });
    if (o.command == "commands")
        return report(measureCommands(o.commands),
                      [&](const auto& rows) { return commandsText(o.commands, rows); });
    if (o.command == "rewind")
        return report(measureRewind(o.rewind),
                      [&](const RewindRow& row) { return rewindText(o.rewind, row); });
    return run(o);
}

}  // namespace
}  // namespace muster::scale

int main(int argc, char** argv) {
    using namespace muster::scale;
    try {
        Options options;
        const int code = readOptions(argc, argv, options);
        if (code >= 0) return code;
        return runSubcommand(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "muster-bench: %s\n", error.what());
        return 1;
    }
}
