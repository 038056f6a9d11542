// The studio: one thread simulates, one serves; letters go between them.
#include <spawn.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <thread>
#include <variant>

#include "mailbox.h"
#include "muster/session/protocol.h"
#include "muster/session/session.h"
#include "scenario_folder.h"
#include "studio.h"
#include "studio_server.h"
#include "take_file.h"

extern char** environ;

namespace muster {
namespace {

constexpr std::size_t kMailboxBytes = std::size_t{128} << 20;  // A take and many messages.
constexpr double kLongestWait = 0.25;                          // [s]

// Letters to the simulation.
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
struct TakeAsked {
    HttpReply reply;
};
struct TakeSent {
    std::vector<std::uint8_t> bytes;
    HttpReply reply;
};
struct Interrupted {};
using Letter = std::variant<Opened, Received, Refused, Closed, TakeAsked, TakeSent, Interrupted>;

int httpStatus(StatusCode code) {
    if (code == StatusCode::NotFound) return 404;
    return code == StatusCode::LimitExceeded ? 413 : 400;
}

HttpAnswer sentence(int status, const std::string& words) {
    HttpAnswer answer;
    answer.status = status;
    answer.body = words + "\n";
    return answer;
}

HttpAnswer failure(const Status& status) { return sentence(httpStatus(status.code()), status.message()); }

// Owns the session and does what the letters ask, on the thread that calls run().
class Simulation {
public:
    Simulation(Session session, Mailbox<Letter>& mailbox, StudioServer& server)
        : session_(std::move(session)), mailbox_(mailbox), server_(server) {}

    // Until interrupted.
    void run() {
        using Clock = std::chrono::steady_clock;
        std::vector<Letter> letters;
        auto last = Clock::now();
        while (!interrupted_) {
            mailbox_.collect(clients_.empty() ? kLongestWait : std::min(kLongestWait, session_.untilNextStep()), letters);
            const auto now = Clock::now();
            // The world waits while nobody watches.
            if (!clients_.empty()) session_.elapse(std::chrono::duration<double>(now - last).count());
            last = now;
            for (Letter& letter : letters) std::visit(*this, letter);
            if (!clients_.empty() && session_.stepDue()) session_.step();
            flush();
        }
        session_.finish();
    }

    void operator()(Opened& letter) { clients_[letter.connection] = session_.connect(); }
    void operator()(Received& letter) {
        const auto found = clients_.find(letter.connection);
        if (found != clients_.end()) session_.receive(found->second, letter.bytes);
    }
    void operator()(Refused& letter) {
        const auto found = clients_.find(letter.connection);
        if (found != clients_.end()) session_.notice(found->second, true, letter.code, letter.text);
    }
    void operator()(Closed& letter) {
        const auto found = clients_.find(letter.connection);
        if (found == clients_.end()) return;
        session_.disconnect(found->second);
        clients_.erase(found);
    }
    void operator()(TakeAsked& letter) {
        auto bytes = session_.take();
        if (!bytes.ok()) return letter.reply(failure(bytes.status()));
        HttpAnswer answer;
        answer.type = "application/octet-stream";
        answer.body.assign(bytes.value().begin(), bytes.value().end());
        answer.fileName = session_.takeName();
        letter.reply(std::move(answer));
    }
    void operator()(TakeSent& letter) {
        const Status status = session_.openTake(letter.bytes, "take");
        if (!status.ok()) return letter.reply(failure(status));
        letter.reply(sentence(200, "The take is open."));
    }
    void operator()(Interrupted&) { interrupted_ = true; }

private:
    void flush() {
        for (const auto& [connection, client] : clients_) {
            std::vector<MessageBytes> messages;
            session_.outgoing(client, messages);
            if (!messages.empty()) server_.send(connection, std::move(messages));
        }
    }

    Session session_;
    Mailbox<Letter>& mailbox_;
    StudioServer& server_;
    std::map<ConnectionId, std::uint32_t> clients_;
    bool interrupted_ = false;
};

ServerEvents eventsTo(Mailbox<Letter>& mailbox) {
    ServerEvents events;
    events.opened = [&](ConnectionId id) { mailbox.post(Opened{id}); };
    events.received = [&](ConnectionId id, std::vector<std::uint8_t> bytes) {
        const std::size_t size = bytes.size() + sizeof(Letter);
        return mailbox.post(Received{id, std::move(bytes)}, size);
    };
    events.refused = [&](ConnectionId id, std::string code, std::string text) {
        mailbox.post(Refused{id, std::move(code), std::move(text)});
    };
    events.closed = [&](ConnectionId id) { mailbox.post(Closed{id}); };
    events.takeAsked = [&](HttpReply reply) { mailbox.post(TakeAsked{std::move(reply)}); };
    events.takeSent = [&](std::vector<std::uint8_t> bytes, HttpReply reply) {
        const std::size_t size = bytes.size();
        if (!mailbox.post(TakeSent{std::move(bytes), reply}, size))
            reply(sentence(503, "The simulation is busy."));
    };
    events.interrupted = [&] { mailbox.post(Interrupted{}); };
    return events;
}

void openBrowser(const std::string& address) {
    if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
    std::string program = "xdg-open";
    std::string argument = address;
    char* arguments[] = {program.data(), argument.data(), nullptr};
    pid_t child = 0;
    if (posix_spawnp(&child, "xdg-open", nullptr, nullptr, arguments, environ) != 0) return;
    std::thread([child] { waitpid(child, nullptr, 0); }).detach();
}

// The scenario that is asked for, by name or path, else the folder's first.
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
    SessionDef def;
    def.version = MUSTER_VERSION;
    def.threads = options.threads;
    def.scenarios = folder.entries();
    def.loadScenario = [folder](const std::string& wanted) { return folder.load(wanted); };
    if (!options.takesFolder.empty())
        def.openSink = [takes = options.takesFolder](const std::string& of) { return openTakeFile(takes, of); };
    Session session(std::move(def));
    const Status status = session.load(name.value(), world.value());
    if (!status.ok()) return status.within(name.value());
    return session;
}

int failed(const Status& status) {
    std::fprintf(stderr, "muster studio: %s\n", status.message().c_str());
    return 1;
}

}  // namespace

int runStudio(const StudioOptions& options) {
    if (options.host != "127.0.0.1" && options.host != "localhost") {
        return failed(invalidArgument("found the host '" + options.host +
                                      "', expected 127.0.0.1: only this machine may connect"));
    }
    auto session = makeSession(options);
    if (!session.ok()) return failed(session.status());
    Mailbox<Letter> mailbox(kMailboxBytes);
    ServerDef def;
    def.port = options.port;
    def.pageFolder = options.pageFolder;
    def.subprotocol = protocol::kSubprotocol;
    def.events = eventsTo(mailbox);
    auto server = StudioServer::listen(std::move(def));
    if (!server.ok()) return failed(server.status());
    const std::string address = "http://127.0.0.1:" + std::to_string(server.value()->port()) + "/";
    std::printf("Muster studio: %s\n", address.c_str());
    std::fflush(stdout);
    std::thread serving([&] { server.value()->run(); });
    if (options.openBrowser) openBrowser(address);
    Simulation(std::move(session).value(), mailbox, *server.value()).run();
    server.value()->stop();
    serving.join();
    // Letters that came too late hold connections, which must go before the server.
    std::vector<Letter> late;
    mailbox.collect(0.0, late);
    return 0;
}

}  // namespace muster
