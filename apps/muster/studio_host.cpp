// The studio: its session and the page that shows it.
#include "host_loop.h"
#include "report.h"
#include "scenario_folder.h"
#include "studio.h"
#include "take_file.h"

namespace muster {
namespace {

// The scenario requested by name or path, otherwise the folder's default.
Result<std::string> firstScenario(const StudioOptions& options, ScenarioFolder& folder) {
    if (options.scenario.empty()) {
        if (folder.entries().empty())
            return Status(StatusCode::NotFound, "no scenario is found in '" + options.scenarioFolder + "'");
        return folder.first();
    }
    if (folder.has(options.scenario)) return options.scenario;
    return folder.add(options.scenario);
}

Result<Session> makeSession(const StudioOptions& options) {
    ScenarioFolder folder = ScenarioFolder::scan(options.scenarioFolder);
    const auto name = firstScenario(options, folder);
    if (!name.ok()) return name.status();
    const auto world = folder.load(name.value());
    if (!world.ok()) return world.status();
    printWarnings(world.value(), name.value());
    SessionDef def;
    def.version = MUSTER_VERSION;
    def.threads = options.threads;
    def.scenarios = folder.entries();
    def.loadScenario = [folder](const std::string& wanted) { return folder.load(wanted); };
    def.loadGestures = [folder](const std::string& of, const WorldDef& begun) {
        return folder.gestures(of, begun);
    };
    def.loadClips = [folder](const std::string& of, const WorldDef& begun) {
        return folder.clips(of, begun);
    };
    if (!options.takesFolder.empty())
        def.openSink = [takes = options.takesFolder](const std::string& of) {
            return openTakeFile(takes, of);
        };
    Session session(std::move(def));
    const Status status = session.load(name.value(), world.value());
    if (!status.ok()) return status.within(name.value());
    return session;
}

}  // namespace

int runStudio(const StudioOptions& options) {
    if (options.host != "127.0.0.1" && options.host != "localhost") {
        return serveFailed(invalidArgument("found the host '" + options.host +
                                           "', expected 127.0.0.1: only this machine may connect"));
    }
    ServeOptions serving;
    serving.port = options.port;
    serving.pageFolder = options.pageFolder;
    serving.openBrowser = options.openBrowser;
    serving.json = options.json;
    // Before the session: loading a scenario takes longer than to see that there is no page.
    if (const auto def = serverDef(serving); !def.ok()) return serveFailed(def.status());
    auto session = makeSession(options);
    if (!session.ok()) return serveFailed(session.status());
    return serve(session.value(), serving);
}

}  // namespace muster
