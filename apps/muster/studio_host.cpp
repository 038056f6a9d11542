// The studio: its session, its shelf of takes, and the page that shows it.
#include <utility>

#include "engine_files.h"
#include "export_desk.h"
#include "host_loop.h"
#include "kept_places.h"
#include "report.h"
#include "scenario_folder.h"
#include "shelf_desk.h"
#include "studio.h"
#include "take_shelf.h"

namespace muster {
namespace {

void openLater(Mailbox<HostEvent>& mailbox, std::vector<std::uint8_t> bytes, const ShelfRequest& request,
               const HttpReply& reply) {
    const std::size_t size = bytes.size();
    if (!mailbox.post(TakeUploaded{std::move(bytes), request.name, request.director, reply}, size))
        reply(sentence(503, "The simulation is busy."));
}

// The scenario requested by name or path, otherwise the one that was shown last, or the folder's default.
Result<std::string> firstScenario(const StudioOptions& options, ScenarioFolder& folder,
                                  const KeptPlaces& places) {
    if (options.scenario.empty()) {
        if (const std::string last = places.last(); folder.has(last)) return last;
        if (folder.entries().empty())
            return Status(StatusCode::NotFound, "no scenario is found in '" + options.scenarioFolder + "'");
        return folder.first();
    }
    if (folder.has(options.scenario)) return options.scenario;
    return folder.add(options.scenario);
}

Result<Session> makeSession(const StudioOptions& options, ScenarioFolder& folder, const KeptPlaces& places,
                            TakeShelf& shelf) {
    const auto name = firstScenario(options, folder, places);
    if (!name.ok()) return name.status();
    const auto world = folder.load(name.value());
    if (!world.ok()) return world.status();
    printWarnings(world.value(), name.value());
    SessionDef def{.version = MUSTER_VERSION, .scenarios = folder.entries(), .threads = options.threads};
    def.loadScenario = [&folder](const std::string& wanted) { return folder.load(wanted); };
    def.loadGestures = [&folder](const std::string& of, const WorldDef& begun) {
        return folder.gestures(of, begun);
    };
    def.loadClips = [&folder](const std::string& of, const WorldDef& begun) {
        return folder.clips(of, begun);
    };
    def.openSink = [&shelf](const std::string& of) { return shelf.record(of); };
    def.keepAbout = [&shelf](const std::string& take, const TakeAbout& about) {
        return shelf.edit(take, about);
    };
    def.replaceTake = [&shelf](const std::string& take, std::span<const std::uint8_t> bytes) {
        return shelf.replace(take, bytes);
    };
    def.takeTitles = [&shelf] { return shelf.titles(); };
    def.keepScenario = [&folder, &places](const WorldDef& place) -> Result<ScenarioEntry> {
        const auto path = places.put(place);
        if (!path.ok()) return path.status();
        return folder.addFile(*path, KeptPlaces::kPrefix);
    };
    def.opened = [&places](const std::string& scenario) { places.remember(scenario); };
    Session session(std::move(def));
    const Status status = session.load(name.value(), world.value());
    if (!status.ok()) return status.within(name.value());
    return session;
}

}  // namespace

int runStudio(const StudioOptions& options) {
    ServeOptions serving{.port = options.port, .pageFolder = options.pageFolder};
    if (engineBuilt(options.engineFolder)) serving.engineFolder = options.engineFolder;
    serving.scenarioFolder = options.scenarioFolder;
    serving.lan = options.lan;
    serving.openBrowser = options.openBrowser;
    serving.json = options.json;
    serving.site = options.site;
    if (!options.site.empty() && !options.site.starts_with("http"))
        return serveFailed(invalidArgument("--site: found '" + options.site + "', expected an address as " +
                                           "https://example.org/crowd/"));
    // Before the session: loading a scenario takes longer than to see that there is no page.
    if (const auto def = serverDef(serving); !def.ok()) return serveFailed(def.status());
    TakeShelf shelf(options.takesFolder);
    ScenarioFolder folder = ScenarioFolder::scan(options.scenarioFolder);
    const KeptPlaces places(options.placesFolder);
    folder.addFolder(places.folder(), KeptPlaces::kPrefix);
    auto session = makeSession(options, folder, places, shelf);
    if (!session.ok()) return serveFailed(session.status());
    ExportDesk exports(
        {[folder](const std::string& of, const WorldDef& def) { return folder.clips(of, def); },
         options.pageFolder + "/player"});
    return serve(session.value(), serving, [&](Mailbox<HostEvent>& mailbox, ServerEvents& events) {
        auto desk = std::make_unique<ShelfDesk>(
            shelf, exports,
            [&](std::vector<std::uint8_t> bytes, const ShelfRequest& request, const HttpReply& reply) {
                openLater(mailbox, std::move(bytes), request, reply);
            },
            [&](std::string name, TakeAbout about) {
                mailbox.post(TakeEdited{std::move(name), std::move(about)});
            });
        events.shelfRequested = [desk = desk.get()](ShelfRequest request, const HttpReply& reply) {
            if (!desk->post(std::move(request), reply)) reply(sentence(503, "The shelf is busy."));
        };
        return desk;
    });
}

}  // namespace muster
