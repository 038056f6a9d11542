#include "host_events.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <set>
#include <utility>

#include "browser.h"
#include "motion_bodies.h"
#include "report.h"
#include "session/protocol.h"

namespace muster {
namespace {

constexpr int kExitInterrupted = 130;  // The exit code that shells use for Ctrl+C.
constexpr const char* kHtmlBegins = "<html ";

int httpStatus(StatusCode code) {
    if (code == StatusCode::NotFound) return 404;
    return code == StatusCode::LimitExceeded ? 413 : 400;
}

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

}  // namespace

HttpAnswer sentence(int status, const std::string& words) {
    HttpAnswer answer;
    answer.status = status;
    answer.body = words + "\n";
    return answer;
}

HttpAnswer failure(const Status& status) {
    return sentence(httpStatus(status.code()), status.message());
}

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
    events.takeUploaded = [&](std::vector<std::uint8_t> bytes, HttpReply reply) {
        const std::size_t size = bytes.size();
        if (!mailbox.post(TakeUploaded{std::move(bytes), reply}, size))
            reply(sentence(503, "The simulation is busy."));
    };
    events.interrupted = [&] {
        // A second interrupt ends the process at once; a recording loses at most its end.
        if (interrupted.exchange(true)) std::_Exit(kExitInterrupted);
        mailbox.post(Interrupted{});
    };
    return events;
}

Result<ServerDef> serverDef(const ServeOptions& options) {
    if (Status status = pageExists(options.pageFolder); !status.ok()) return status;
    ServerDef def;
    def.port = options.port;
    def.pageFolder = options.pageFolder;
    for (BodyFile& body : bodyFiles())
        def.files["/bodies/" + body.name] = {"model/gltf-binary", "no-cache", std::move(body.bytes)};
    def.subprotocol = protocol::kSubprotocol;
    if (options.mode.empty()) return def;
    // The page learns by an attribute of its first element what it is to show.
    auto page = readStaticFile(options.pageFolder, "/index.html");
    const std::size_t at = page ? page->body.find(kHtmlBegins) : std::string::npos;
    if (at == std::string::npos)
        return Status(StatusCode::ParseError, options.pageFolder + "/index.html: found no <html lang=...>");
    page->body.insert(at + std::string(kHtmlBegins).size(), "data-mode=\"" + options.mode + "\" ");
    def.files["/index.html"] = *page;
    return def;
}

void announce(const ServeOptions& options, int port) {
    const std::string address = "http://127.0.0.1:" + std::to_string(port) + "/";
    if (options.json)
        printJsonValue({{"address", address}, {"port", port}});
    else
        std::printf("%s: %s\n", options.title.c_str(), address.c_str());
    std::fflush(stdout);
    if (options.openBrowser) openBrowser(address);
}

int serveFailed(const Status& status) {
    std::fprintf(stderr, "muster studio: %s\n", status.message().c_str());
    return 1;
}

}  // namespace muster
