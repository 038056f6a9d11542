// The studio: one thread simulates, another serves. The server posts events to the simulation.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <thread>
#include <variant>

#include "browser.h"
#include "export_desk.h"
#include "http_answers.h"
#include "invitation.h"
#include "mailbox.h"
#include "motion_bodies.h"
#include "muster/session.h"
#include "report.h"
#include "scenario_folder.h"
#include "session/protocol.h"
#include "shelf_desk.h"
#include "studio.h"
#include "studio_server.h"
#include "take_shelf.h"

namespace muster {
namespace {

constexpr std::size_t kMailboxBytes = std::size_t{128} << 20;  // Enough for a take and many messages.
constexpr double kLongestWait = 0.25;                          // [s]
constexpr int kExitInterrupted = 130;                          // The exit code that shells use for Ctrl+C.

// Events that the server posts to the simulation.
struct Opened {
    ConnectionId connection;
};
struct Received {
    ConnectionId connection;
    std::vector<std::uint8_t> bytes;
};
struct Refused {
    ConnectionId connection;
    std::string code;
    std::string text;
};
struct Closed {
    ConnectionId connection;
};
struct TakeRequested {
    HttpReply reply;
};
struct TakeUploaded {
    std::vector<std::uint8_t> bytes;
    std::string name;  // On the shelf; empty where it comes from elsewhere.
    HttpReply reply;
};
struct TakeEdited {
    std::string name;
    TakeAbout about;
};
struct Interrupted {};
using HostEvent = std::variant<Opened, Received, Refused, Closed, TakeRequested, TakeUploaded, TakeEdited,
                               Interrupted>;

bool beginsWorld(const std::vector<std::uint8_t>& bytes) {
    static const auto restart = protocol::encode(protocol::Playback{protocol::PlaybackAction::Restart});
    static const auto demonstrate = protocol::encode(
        protocol::Playback{protocol::PlaybackAction::Demonstrate});
    return !bytes.empty() &&
           (bytes[0] == protocol::LoadScenario::kNumber || bytes == restart || bytes == demonstrate);
}

// A new world costs much and replaces everything before it. Of equal waiting requests only the last is
// handled, so that a client cannot keep the simulation busy by repeating one.
void dropRepeated(std::vector<HostEvent>& events) {
    std::set<std::vector<std::uint8_t>> seen;
    for (auto event = events.rbegin(); event != events.rend(); ++event) {
        auto* received = std::get_if<Received>(&*event);
        if (received == nullptr || !beginsWorld(received->bytes)) continue;
        // No client has this number, so the event is ignored.
        if (!seen.insert(received->bytes).second) received->connection = 0;
    }
}

// Owns the session and handles events, on the thread that calls run().
class Simulation {
public:
    Simulation(Session session, Mailbox<HostEvent>& mailbox, StudioServer& server,
               const std::atomic<bool>& interrupted)
        : session_(std::move(session)), mailbox_(mailbox), server_(server), interrupted_(interrupted) {}

    // Returns when interrupted.
    void run() {
        using Clock = std::chrono::steady_clock;
        std::vector<HostEvent> events;
        auto last = Clock::now();
        while (!interrupted_) {
            mailbox_.collect(longestWait(), events);
            const auto now = Clock::now();
            // The world stands still while no client is connected.
            if (!clients_.empty()) session_.elapse(std::chrono::duration<double>(now - last).count());
            last = now;
            dropRepeated(events);
            for (HostEvent& event : events) {
                if (interrupted_) break;
                std::visit(*this, event);
            }
            if (!clients_.empty() && session_.stepDue())
                session_.step();
            else if (!clients_.empty())
                session_.prepare();
            flush();
        }
        session_.finish();
    }

    void operator()(Opened& event) { clients_[event.connection] = session_.connect(); }
    void operator()(Received& event) {
        const auto found = clients_.find(event.connection);
        if (found != clients_.end()) session_.receive(found->second, event.bytes);
    }
    void operator()(Refused& event) {
        const auto found = clients_.find(event.connection);
        if (found != clients_.end()) session_.notice(found->second, true, event.code, event.text);
    }
    void operator()(Closed& event) {
        const auto found = clients_.find(event.connection);
        if (found == clients_.end()) return;
        session_.disconnect(found->second);
        clients_.erase(found);
    }
    void operator()(TakeRequested& event) {
        auto bytes = session_.take();
        if (!bytes.ok()) return event.reply(failure(bytes.status()));
        HttpAnswer answer;
        answer.type = "application/octet-stream";
        answer.body.assign(bytes.value().begin(), bytes.value().end());
        answer.fileName = session_.takeName();
        event.reply(std::move(answer));
    }
    void operator()(TakeUploaded& event) {
        const Status status = session_.openTake(event.bytes, event.name.empty() ? "take" : event.name,
                                                event.name);
        if (!status.ok()) return event.reply(failure(status));
        event.reply(sentence(200, "The take is open."));
    }
    void operator()(TakeEdited& event) { session_.takeEdited(event.name, event.about); }
    void operator()(Interrupted&) {}  // The event only ends the wait for the mailbox.

private:
    double longestWait() const {
        if (clients_.empty()) return kLongestWait;
        return session_.preparing() ? 0.0 : std::min(kLongestWait, session_.untilNextStep());
    }
    void flush() {
        for (const auto& [connection, client] : clients_) {
            std::vector<MessageBytes> messages;
            session_.outgoing(client, messages);
            if (!messages.empty()) server_.send(connection, std::move(messages));
        }
    }

    Session session_;
    Mailbox<HostEvent>& mailbox_;
    StudioServer& server_;
    std::map<ConnectionId, std::uint32_t> clients_;
    const std::atomic<bool>& interrupted_;
};

// Runs the server on its own thread; the destructor stops it.
class Serving {
public:
    Serving(StudioServer& server, const std::function<void()>& failed)
        : server_(server), thread_([this, failed] { run(failed); }) {}
    ~Serving() {
        server_.stop();
        thread_.join();
    }
    bool good() const { return good_; }

private:
    void run(const std::function<void()>& failed) {
        try {
            server_.run();
        } catch (const std::exception& error) {
            std::fprintf(stderr, "muster studio: the server ended: %s\n", error.what());
            good_ = false;
            failed();
        }
    }

    StudioServer& server_;
    std::atomic<bool> good_ = true;
    std::thread thread_;  // The last member, because the thread uses the others.
};

void openLater(Mailbox<HostEvent>& mailbox, std::vector<std::uint8_t> bytes, std::string name,
               const HttpReply& reply) {
    const std::size_t size = bytes.size();
    if (!mailbox.post(TakeUploaded{std::move(bytes), std::move(name), reply}, size))
        reply(sentence(503, "The simulation is busy."));
}

ServerEvents eventsTo(Mailbox<HostEvent>& mailbox, ShelfDesk& desk, std::atomic<bool>& interrupted) {
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
        openLater(mailbox, std::move(bytes), {}, reply);
    };
    events.shelfRequested = [&](ShelfRequest request, HttpReply reply) {
        if (!desk.post(std::move(request), reply)) reply(sentence(503, "The shelf is busy."));
    };
    events.interrupted = [&] {
        // A second interrupt ends the process at once; a recording loses at most its end.
        if (interrupted.exchange(true)) std::_Exit(kExitInterrupted);
        mailbox.post(Interrupted{});
    };
    return events;
}

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

Result<Session> makeSession(const StudioOptions& options, ScenarioFolder& folder, TakeShelf& shelf) {
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
    def.openSink = [&shelf](const std::string& of) { return shelf.record(of); };
    def.keepAbout = [&shelf](const std::string& take, const TakeAbout& about) {
        return shelf.edit(take, about);
    };
    Session session(std::move(def));
    const Status status = session.load(name.value(), world.value());
    if (!status.ok()) return status.within(name.value());
    return session;
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

std::string printAddress(int port, const Invitation* invitation, const std::string& token, bool json) {
    const std::string address = "http://127.0.0.1:" + std::to_string(port) + "/";
    if (json) {
        Json value{{"address", address}, {"port", port}};
        if (invitation != nullptr) {
            value["links"] = Json::arrayOf(invitation->links);
            value["token"] = token;
        }
        printJsonValue(value);
    } else {
        std::printf("Muster studio: %s\n", address.c_str());
        if (invitation != nullptr) printLinks(*invitation);
    }
    std::fflush(stdout);
    return address;
}

int failed(const Status& status) {
    std::fprintf(stderr, "muster studio: %s\n", status.message().c_str());
    return 1;
}

}  // namespace

int runStudio(const StudioOptions& options) {
    if (Status status = pageExists(options.pageFolder); !status.ok()) return failed(status);
    TakeShelf shelf(options.takesFolder);
    ScenarioFolder folder = ScenarioFolder::scan(options.scenarioFolder);
    auto session = makeSession(options, folder, shelf);
    if (!session.ok()) return failed(session.status());
    Mailbox<HostEvent> mailbox(kMailboxBytes);
    std::atomic<bool> interrupted = false;
    ExportDesk exports(
        [folder](const std::string& of, const WorldDef& def) { return folder.clips(of, def); });
    std::optional<ShelfDesk> desk;
    desk.emplace(
        shelf, exports,
        [&](std::vector<std::uint8_t> bytes, std::string name, const HttpReply& reply) {
            openLater(mailbox, std::move(bytes), std::move(name), reply);
        },
        [&](std::string name, TakeAbout about) {
            mailbox.post(TakeEdited{std::move(name), std::move(about)});
        });
    ServerDef def;
    def.port = options.port;
    def.pageFolder = options.pageFolder;
    for (BodyFile& body : bodyFiles())
        def.files["/bodies/" + body.name] = {"model/gltf-binary", "no-cache", std::move(body.bytes)};
    def.subprotocol = protocol::kSubprotocol;
    const std::string token = options.lan ? makeToken() : std::string();
    def.token = token;
    def.events = eventsTo(mailbox, *desk, interrupted);
    auto server = StudioServer::listen(std::move(def));
    if (!server.ok()) return failed(server.status());
    const int port = server.value()->port();
    Invitation invitation;
    if (options.lan) invitation = makeInvitation(networkAddresses(), port, token);
    server.value()->addFile("/invitation.json", {"application/json", "no-store", invitationJson(invitation)});
    const std::string address = printAddress(port, options.lan ? &invitation : nullptr, token, options.json);
    bool served = true;
    {
        const Serving serving(*server.value(), [&] {
            interrupted = true;
            mailbox.post(Interrupted{});
        });
        if (options.openBrowser) openBrowser(address);
        Simulation(std::move(session).value(), mailbox, *server.value(), interrupted).run();
        served = serving.good();
    }
    // Events that arrive too late refer to connections, which must be destroyed before the server.
    desk.reset();
    std::vector<HostEvent> late;
    mailbox.collect(0.0, late);
    return served ? 0 : 1;
}

}  // namespace muster
