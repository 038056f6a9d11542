// The loop of a program that serves a page: one thread simulates, another serves. The host is a Session, or
// anything that takes and gives messages as one does.
#pragma once

#include <algorithm>
#include <chrono>
#include <utility>

#include "host_answers.h"
#include "host_events.h"
#include "muster/session.h"

namespace muster {

/// Hands events to a host and lets its time pass, on the thread that calls run().
template <class Host>
class Simulation {
public:
    Simulation(Host& host, Mailbox<HostEvent>& mailbox, StudioServer& server,
               const std::atomic<bool>& interrupted)
        : host_(host), mailbox_(mailbox), server_(server), interrupted_(interrupted) {}

    /// Returns when interrupted.
    void run() {
        using Clock = std::chrono::steady_clock;
        std::vector<HostEvent> events;
        auto last = Clock::now();
        while (!interrupted_) {
            mailbox_.collect(longestWait(), events);
            const auto now = Clock::now();
            // The world stands still while no client is connected.
            if (!clients_.empty()) host_.elapse(std::chrono::duration<double>(now - last).count());
            last = now;
            dropRepeated(events);
            for (HostEvent& event : events) {
                if (interrupted_) break;
                std::visit(*this, event);
            }
            if (!clients_.empty()) work();
            flush();
        }
        host_.finish();
    }

    void operator()(Opened& event) { clients_[event.connection] = host_.connect(); }
    void operator()(Received& event) {
        const auto found = clients_.find(event.connection);
        if (found != clients_.end()) host_.receive(found->second, event.bytes);
    }
    void operator()(Refused& event) {
        const auto found = clients_.find(event.connection);
        if (found != clients_.end()) host_.notice(found->second, true, event.code, event.text);
    }
    void operator()(Closed& event) {
        const auto found = clients_.find(event.connection);
        if (found == clients_.end()) return;
        host_.disconnect(found->second);
        clients_.erase(found);
    }
    void operator()(TakeRequested& event) { event.reply(takeAnswer(host_)); }
    void operator()(TakeUploaded& event) {
        event.reply(openTakeAnswer(host_, event.bytes, event.name, event.director));
    }
    void operator()(HandoverRequested& event) { event.reply(handoverAnswer(host_, event.target)); }
    void operator()(PlaceRequested& event) { event.reply(placeAnswer(host_)); }
    void operator()(PlaceUploaded& event) {
        event.reply(openPlaceAnswer(host_, event.bytes, event.name, event.director));
    }
    void operator()(TakeEdited& event) {
        if constexpr (requires { host_.takeName(); }) host_.takeEdited(event.name, event.about);
    }
    void operator()(Interrupted&) {}  // The event only ends the wait for the mailbox.

private:
    static constexpr double kLongestWait = 0.25;  // [s]

    // A host may have work that makes later steps cheaper.
    double longestWait() const {
        if (clients_.empty()) return kLongestWait;
        if constexpr (requires { host_.preparing(); })
            if (host_.preparing()) return 0.0;
        return std::min(kLongestWait, host_.untilNextStep());
    }
    void work() {
        if (host_.stepDue()) return host_.step();
        if constexpr (requires { host_.prepare(); }) host_.prepare();
    }
    void flush() {
        for (const auto& [connection, client] : clients_) {
            std::vector<MessageBytes> messages;
            host_.outgoing(client, messages);
            if (!messages.empty()) server_.send(connection, std::move(messages));
        }
    }

    Host& host_;
    Mailbox<HostEvent>& mailbox_;
    StudioServer& server_;
    std::map<ConnectionId, std::uint32_t> clients_;
    const std::atomic<bool>& interrupted_;
};

/// Serves a page for a host until interrupted. `prepare` gets the mailbox and the server's callbacks; what it
/// returns lives until nobody is served any more. Returns the program's exit code; failures are printed on
/// standard error.
template <class Host, class Prepare>
int serve(Host& host, const ServeOptions& options, const Prepare& prepare) {
    constexpr std::size_t kMailboxBytes = std::size_t{128} << 20;  // Enough for a take and many messages.
    auto def = serverDef(options);
    if (!def.ok()) return serveFailed(def.status());
    Mailbox<HostEvent> mailbox(kMailboxBytes);
    std::atomic<bool> interrupted = false;
    def->events = eventsTo(mailbox, interrupted);
    [[maybe_unused]] auto prepared = prepare(mailbox, def->events);
    const std::string token = def->token;
    auto server = StudioServer::listen(std::move(def).value());
    if (!server.ok()) return serveFailed(server.status());
    announce(options, *server.value(), token);
    bool served = true;
    {
        const Serving serving(*server.value(), [&] {
            interrupted = true;
            mailbox.post(Interrupted{});
        });
        openPage(options, server.value()->port());
        Simulation<Host>(host, mailbox, *server.value(), interrupted).run();
        served = serving.good();
    }
    // Events that arrive too late refer to connections, which must be destroyed before the server.
    prepared = {};
    std::vector<HostEvent> late;
    mailbox.collect(0.0, late);
    return served ? 0 : 1;
}

/// The same, with nothing to prepare.
template <class Host>
int serve(Host& host, const ServeOptions& options) {
    return serve(host, options, [](Mailbox<HostEvent>&, ServerEvents&) { return 0; });
}

}  // namespace muster
