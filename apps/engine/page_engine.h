// The studio's session where the page has its engine beside it: what the server does, without sockets and
// threads.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "http_answer.h"
#include "muster/session.h"
#include "scenario_folder.h"
#include "shelf_answers.h"
#include "take_shelf.h"

namespace muster {

/// Where a page's engine finds scenarios and keeps takes.
struct PageEngineDef {
    std::string scenarioFolder = "/scenarios";  ///< Folder of the picker's scenarios.
    std::string takesFolder = "/takes";         ///< Folder of the shelf of takes.
    std::string scenario;                       ///< Loaded first; empty for the folder's default.
    std::string version;                        ///< Version that is sent to the page.
    std::int32_t threads = 1;                   ///< Threads of the world.
};

/// A session with a shelf. Not thread-safe; nothing waits.
class PageEngine {
public:
    /// Fails with NotFound where the scenario is not there, or like loadScenario and World::create.
    static Result<std::unique_ptr<PageEngine>> open(const PageEngineDef& def);
    PageEngine(const PageEngine&) = delete;
    PageEngine& operator=(const PageEngine&) = delete;

    /// The session, for messages of the page.
    Session& session() { return *session_; }
    /// Lets time pass [s], and does one piece of the work that is due. Returns the time after which it wants
    /// to be called again [s]; 0 for at once.
    double advance(double seconds);
    /// Answers a request as the server does (docs/protocol.md, "Takes over HTTP"), but for exports. The
    /// target is a path: "/takes", "/scenario?name=market".
    HttpAnswer ask(std::string_view method, std::string_view target, std::span<const std::uint8_t> body);

private:
    explicit PageEngine(const PageEngineDef& def);
    HttpAnswer askShelf(std::string_view method, std::string_view target, std::span<const std::uint8_t> body);

    TakeShelf shelf_;
    ScenarioFolder folder_;
    ShelfAnswers answers_;
    std::unique_ptr<Session> session_;
};

}  // namespace muster
