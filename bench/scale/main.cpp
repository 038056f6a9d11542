// muster-bench: what a step costs at scale, and how good its plans are.
#include <cstdio>
#include <exception>

#include "scale/options.h"
#include "scale/report.h"

namespace muster::scale {
namespace {

void printHead(const Options& options) {
    if (options.json) return;
    std::printf("Times of whole steps: the thread's CPU time with one thread, wall time with more.\n%s\n", tableHead().c_str());
}

void printGrowth(const Options& options, const std::vector<Row>& rows) {
    if (options.json) return;
    for (const Regime regime : {Regime::Far, Regime::Tracking}) {
        const Growth growth = growthOf(rows, regime);
        if (growth.points == 0) continue;
        std::printf("%s: the cost of a step grows as n^%.2f from %d to %d characters (p50, %d rows)\n",
                    regimeName(regime), growth.exponent, growth.least, growth.most, growth.points);
    }
}

int run(const Options& options) {
    const auto cases = casesOf(options);
    printHead(options);
    std::vector<Row> rows;
    int exitCode = 0;
    for (const CaseDef& def : *cases) {
        const Result<Row> row = runCase(def);
        if (!row.ok()) {
            std::fprintf(stderr, "muster-bench: skipped: %s %s %d: %s\n", def.scene.name.c_str(),
                         regimeName(def.scene.regime), def.scene.count, row.status().message().c_str());
            if (row.status().code() != StatusCode::NotFound) exitCode = 1;
            continue;
        }
        std::printf("%s\n", options.json ? jsonRow(*row).c_str() : tableRow(*row).c_str());
        std::fflush(stdout);
        rows.push_back(*row);
    }
    printGrowth(options, rows);
    return exitCode;
}

}  // namespace
}  // namespace muster::scale

int main(int argc, char** argv) {
    using namespace muster::scale;
    try {
        Options options;
        const int code = readOptions(argc, argv, options);
        return code >= 0 ? code : run(options);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "muster-bench: %s\n", error.what());
        return 1;
    }
}
