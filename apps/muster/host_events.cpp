#include "host_events.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <set>
#include <utility>

#include "browser.h"
#include "engine_files.h"
#include "invitation.h"
#include "motion_bodies.h"
#include "report.h"
#include "request_target.h"
#include "studio/session/inbox/protocol.h"

namespace muster {
namespace {

constexpr int kExitInterrupted = 130;  // The exit code that shells use for Ctrl+C.
constexpr const char* kHtmlBegins = "<html ";

bool beginsWorld(const std::vector<std::uint8_t>& bytes) {
    static const auto restart = protocol::encode(protocol::Playback{protocol::PlaybackAction::Restart});
    static const auto demonstrate = protocol::encode(
        protocol::Playback{protocol::PlaybackAction::Demonstrate});
    return !bytes.empty() &&
           (bytes[0] == protocol::LoadScenario::kNumber || bytes == restart || bytes == demonstrate);
}

Status pageExists(const std::string& folder) {
    std::error_code error;
    if (std::filesystem::is_regular_file(folder + "/index.html", error)) return {};
    return {
        StatusCode::NotFound,
        folder +
            ": found no index.html, expected the built page; ./run builds it, --page names another folder"};
}

void printLinks(const Invitation& invitation) {
    if (invitation.links.empty())
        return void(std::printf("No network was found: only this machine can connect.\n"));
    std::printf("For others in your network (whoever has the link can direct):\n");
    for (const std::string& link : invitation.links) std::printf("  %s\n", link.c_str());
    if (isatty(STDOUT_FILENO)) std::printf("\n%s\n", codeText(invitation.code).c_str());
}

void printAddress(const ServeOptions& options, const std::string& address, int port,
                  const Invitation* invitation, const std::string& token) {
    if (options.json) {
        Json value{{"address", address}, {"port", port}};
        if (invitation != nullptr) {
            value["links"] = Json::arrayOf(invitation->links);
            value["token"] = token;
        }
        printJsonValue(value);
    } else {
        std::printf("%s: %s\n", options.title.c_str(), address.c_str());
        if (invitation != nullptr) printLinks(*invitation);
    }
    std::fflush(stdout);
}

}  // namespace

void dropRepeated(std::vector<HostEvent>& events) {
    std::set<std::vector<std::uint8_t>> seen;
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        auto* received = std::get_if<Received>(&*event);
        if (received == nullptr || !beginsWorld(received->bytes)) continue;
        // No client has this number, so the event is ignored.
        if (!seen.insert(received->bytes).second) received->connection = 0;
    }
}

void Serving::run(const std::function<void()>& failed) {
    try {
        server_.run();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "muster studio: the server ended: %s\n", error.what());
        good_ = false;
        failed();
    }
}

ServerEvents eventsTo(Mailbox<HostEvent>& mailbox, std::atomic<bool>& interrupted) {
    ServerEvents events;
    events.opened = [&](ConnectionId id) { mailbox.post(Opened{id}); };
    events.received = [&](ConnectionId id, std::vector<std::uint8_t> bytes) {
        const std::size_t size = bytes.size() + sizeof(HostEvent);
        return mailbox.post(Received{id, std::move(bytes)}, size);
    };
    events.refused = [&](ConnectionId id, std::string code, std::string text) {
        mailbox.post(Refused{id, std::move(code), std::move(text)});
    };
    events.closed = [&](ConnectionId id) { mailbox.post(Closed{id}); };
    events.takeRequested = [&](HttpReply reply) { mailbox.post(TakeRequested{std::move(reply)}); };
    events.takeUploaded = [&](std::vector<std::uint8_t> bytes, const std::string& target,
                              const HttpReply& reply) {
        const std::size_t size = bytes.size();
        if (!mailbox.post(TakeUploaded{std::move(bytes), {}, queryDirector(target), reply}, size))
            reply(sentence(503, "The simulation is busy."));
    };
    events.handoverRequested = [&](std::string target, HttpReply reply) {
        mailbox.post(HandoverRequested{std::move(target), std::move(reply)});
    };
    events.placeRequested = [&](HttpReply reply) { mailbox.post(PlaceRequested{std::move(reply)}); };
    events.placeUploaded = [&](std::vector<std::uint8_t> bytes, const std::string& target,
                               const HttpReply& reply) {
        const std::size_t size = bytes.size();
        if (!mailbox.post(PlaceUploaded{std::move(bytes), queryName(target), queryDirector(target), reply},
                          size))
            reply(sentence(503, "The simulation is busy."));
    };
    events.shelfRequested = [](const ShelfRequest&, const HttpReply& reply) {
        reply(sentence(404, "There are no takes here."));
    };
    events.interrupted = [&] {
        // A second interrupt ends the process at once; a recording loses at most its end.
        if (interrupted.exchange(true)) std::_Exit(kExitInterrupted);
        mailbox.post(Interrupted{});
    };
    return events;
}

namespace {

/// Serves the engine for browsers. Its folder's name follows from its contents, so that browsers keep the
/// files and have them when the server is lost. Gives the folder's address.
Result<std::string> addEngineFiles(const ServeOptions& options, ServerDef& def) {
    auto files = engineModules(options.engineFolder);
    if (!files.ok()) return files.status();
    auto texts = scenarioTexts(options.scenarioFolder, false);
    if (!texts.ok()) return texts.status();
    (*files)["scenarios.json"] = std::move(texts->scenarios);
    (*files)["gestures.json"] = std::move(texts->gestures);
    const std::string folder = "engine-" + versionOf(*files) + "/";
    const std::string base = "/" + folder;
    for (auto& [name, bytes] : *files)
        def.files[base + name] = {typeOfFile(name), kKeptForever, std::move(bytes)};
    return folder;
}

}  // namespace

// The page learns by attributes of its first element what it is to show, and where an engine is.
Result<ServerDef> serverDef(const ServeOptions& options) {
    if (Status status = pageExists(options.pageFolder); !status.ok()) return status;
    ServerDef def{.port = options.port, .pageFolder = options.pageFolder};
    for (BodyFile& body : bodyFiles())
        def.files["/bodies/" + body.name] = {"model/gltf-binary", "no-cache", std::move(body.bytes)};
    def.subprotocol = protocol::kSubprotocol;
    if (options.lan) def.token = makeToken();
    std::string attributes;
    if (!options.mode.empty()) attributes += "data-mode=\"" + options.mode + "\" ";
    if (!options.engineFolder.empty()) {
        // Without an engine a lost server is waited for, that is all.
        const auto folder = addEngineFiles(options, def);
        if (folder.ok()) attributes.append("data-standby=\"").append(*folder).append("\" ");
    }
    if (attributes.empty()) return def;
    auto page = readStaticFile(options.pageFolder, "/index.html");
    const std::size_t at = page ? page->body.find(kHtmlBegins) : std::string::npos;
    if (at == std::string::npos && options.mode.empty()) return def;  // A page of somebody else's.
    if (at == std::string::npos)
        return Status(StatusCode::ParseError, options.pageFolder + "/index.html: found no <html lang=...>");
    page->body.insert(at + std::string(kHtmlBegins).size(), attributes);
    def.files["/index.html"] = *page;
    return def;
}

void announce(const ServeOptions& options, StudioServer& server, const std::string& token) {
    const int port = server.port();
    Invitation invitation;
    if (options.lan) invitation = makeInvitation(networkAddresses(), port, token);
    server.addFile("/invitation.json",
                   {"application/json", "no-store", invitationJson(invitation, options.site)});
    const std::string address = "http://127.0.0.1:" + std::to_string(port) + "/";
    printAddress(options, address, port, options.lan ? &invitation : nullptr, token);
}

void openPage(const ServeOptions& options, int port) {
    if (options.openBrowser) openBrowser("http://127.0.0.1:" + std::to_string(port) + "/");
}

int serveFailed(const Status& status) {
    std::fprintf(stderr, "muster studio: %s\n", status.message().c_str());
    return 1;
}

}  // namespace muster
