#include "page_engine.h"

#include <algorithm>
#include <utility>

#include "base/text_file.h"
#include "host_answers.h"
#include "motion_bodies.h"
#include "request_target.h"

namespace muster {
namespace {

constexpr double kLongestWait = 0.25;  // [s]
constexpr std::size_t kMostFileBytes = std::size_t{64} << 20;
constexpr std::string_view kBodies = "/bodies/";

HttpAnswer body(std::string_view name) {
    auto bytes = bodyFile(name);
    if (!bytes) return sentence(404, "There is no such file.");
    return {.type = "model/gltf-binary", .body = std::move(*bytes)};
}

/// The page has no files: what lies in one is put into the answer.
HttpAnswer withFile(HttpAnswer answer) {
    if (answer.path.empty()) return answer;
    auto bytes = readTextFile(answer.path, kMostFileBytes);
    if (!bytes.ok()) return failure(bytes.status());
    answer.body = std::move(bytes).value();
    answer.path.clear();
    return answer;
}

}  // namespace

PageEngine::PageEngine(const PageEngineDef& def)
    : shelf_(def.takesFolder),
      folder_(ScenarioFolder::scan(def.scenarioFolder)),
      answers_(shelf_, [this](const std::string& name, const TakeAbout& about) {
          session_->takeEdited(name, about);
      }) {
    SessionDef session{.version = def.version, .scenarios = folder_.entries(), .threads = def.threads};
    session.loadScenario = [this](const std::string& wanted) { return folder_.load(wanted); };
    session.loadGestures = [this](const std::string& of, const WorldDef& begun) {
        return folder_.gestures(of, begun);
    };
    session.loadClips = [this](const std::string& of, const WorldDef& begun) {
        return folder_.clips(of, begun);
    };
    session.openSink = [this](const std::string& of) { return shelf_.record(of); };
    session.keepAbout = [this](const std::string& take, const TakeAbout& about) {
        return shelf_.edit(take, about);
    };
    session.replaceTake = [this](const std::string& take, std::span<const std::uint8_t> bytes) {
        return shelf_.replace(take, bytes);
    };
    session.takeTitles = [this] { return shelf_.titles(); };
    session_ = std::make_unique<Session>(std::move(session));
}

Result<std::unique_ptr<PageEngine>> PageEngine::open(const PageEngineDef& def) {
    std::unique_ptr<PageEngine> engine(new PageEngine(def));
    const std::string name = def.scenario.empty() ? engine->folder_.first() : def.scenario;
    const auto world = engine->folder_.load(name);
    if (!world.ok()) return world.status();
    if (Status s = engine->session_->load(name, *world); !s.ok()) return s.within(name);
    return engine;
}

double PageEngine::advance(double seconds) {
    Session& session = *session_;
    session.elapse(std::max(0.0, seconds));
    if (session.stepDue())
        session.step();
    else
        session.prepare();
    if (session.preparing()) return 0.0;
    return std::min(kLongestWait, session.untilNextStep());
}

HttpAnswer PageEngine::ask(std::string_view method, std::string_view target,
                           std::span<const std::uint8_t> bytes) {
    const std::string_view path = withoutQuery(target);
    const bool get = method == "GET", post = method == "POST";
    if (isShelfTarget(target)) return withFile(askShelf(method, target, bytes));
    if (path == "/take" && get) return takeAnswer(*session_);
    if (path == "/take" && post) return openTakeAnswer(*session_, bytes, {});
    if (path == "/handover" && get) return handoverAnswer(*session_, target);
    if (path == "/handover" && post) {
        const Status status = session_->takeOver(bytes);
        return status.ok() ? sentence(200, "The world goes on.") : failure(status);
    }
    if (path == "/scenario" && get) return placeAnswer(*session_);
    if (path == "/scenario" && post) return openPlaceAnswer(*session_, bytes, queryName(target));
    if (path.starts_with(kBodies) && get) return body(path.substr(kBodies.size()));
    return sentence(404, "There is no such file.");
}

HttpAnswer PageEngine::askShelf(std::string_view method, std::string_view target,
                                std::span<const std::uint8_t> bytes) {
    auto request = shelfRequest(method, target);
    if (!request) return sentence(405, "Nothing of that kind can be done here.");
    if (bytes.size() > mostBodyBytes(request->action, kMostFileBytes))
        return sentence(413, "The body is too large.");
    request->body.assign(bytes.begin(), bytes.end());
    if (request->action != ShelfAction::Open) return answers_.answer(*request);
    const auto take = shelf_.read(request->name);
    if (!take.ok()) return failure(take.status());
    const auto* data = reinterpret_cast<const std::uint8_t*>(take->data());
    return openTakeAnswer(*session_, {data, take->size()}, request->name);
}

}  // namespace muster
