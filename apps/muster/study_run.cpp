// muster study run
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include "commands.h"
#include "folders.h"
#include "host_loop.h"
#include "invitation.h"
#include "report.h"
#include "studio/gestures/control_scheme.h"
#include "studio/study/host/study_host.h"

namespace muster {
namespace {

struct StudyRunOptions {
    std::string db;
    PeopleSettings settings;
    ServeOptions serve;
    bool test = false;
};

// "2026-11-24T06:00:00Z"
std::string utcNow() {
    using namespace std::chrono;
    const auto now = floor<seconds>(system_clock::now());
    const auto day = floor<days>(now);
    const year_month_day date(day);
    const hh_mm_ss time(now - day);
    char text[32];
    std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02dZ", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
                  static_cast<int>(time.seconds().count()));
    return text;
}

std::vector<std::string> mice() {
    std::vector<std::string> names;
    for (const NamedScheme& scheme : namedSchemes())
        if (scheme.def.kind != SchemeKind::Touch) names.emplace_back(scheme.name);
    return names;
}

int studyRun(const StudyRunOptions& options) {
    auto store = StudyStore::open(options.db, StoreMode::Create);
    if (!store.ok()) return reportFailure(store.status());
    StudyHostDef def{.version = MUSTER_VERSION,
                     .settings = options.settings,
                     .kind = options.test ? RunKind::Test : RunKind::People};
    def.now = utcNow;
    def.token = makeToken;
    StudyHost host(store.value(), std::move(def));
    return serve(host, options.serve);
}

}  // namespace

void addStudyRunCommand(Subcommand& study) {
    Subcommand command = study.add("run", "Serves the page of the study: a run with a person.");
    auto options = std::make_shared<StudyRunOptions>();
    options->serve.mode = "study";
    options->serve.title = "Muster study";
    command.option("--db", options->db, "The study's database; it is made where it is missing.").required();
    command.option("--mouse", options->settings.mouse, "The control that touch is compared with.")
        .oneOf(mice());
    command.option("--crowd", options->settings.crowd, "Number of characters.").range(1, 400);
    command.option("--port", options->serve.port, "Port; the next free one where it is in use.")
        .range(1, 65535);
    command.option("--page", options->serve.pageFolder, "Folder of the built page.").existingFolder();
    command.flag("--test", options->test, "Runs test the page: they are marked, and never count as people.");
    command.flag("--open", options->serve.openBrowser, "Opens the page in the desktop's browser.");
    command.flag("--json", options->serve.json, "One JSON value on standard output: address and port.");
    command.footer(
        "Every window of the page is a run of its own; it begins with consent and can be reloaded at any "
        "time. Only this\n"
        "machine can connect. Ctrl+C ends it; runs that are not over are kept as broken off.\n"
        "Examples:\n"
        "  muster study run --db study.db\n"
        "  muster study run --db study.db --mouse mouse-full-free --crowd 100 --open");
    command.run([options] {
        if (options->serve.pageFolder.empty()) options->serve.pageFolder = pageFolder();
        return studyRun(*options);
    });
}

}  // namespace muster
