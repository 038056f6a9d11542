// What a server's thread posts to the thread that simulates, and the server's own thread.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "http_answers.h"
#include "mailbox.h"
#include "muster/take.h"
#include "studio_server.h"

namespace muster {

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
    std::string name;            // On the shelf; empty where it comes from elsewhere.
    std::uint32_t director = 0;  // Who opens it; 0 for somebody.
    HttpReply reply;
};
struct TakeEdited {
    std::string name;
    TakeAbout about;
};
struct HandoverRequested {
    std::string target;
    HttpReply reply;
};
struct PlaceRequested {
    HttpReply reply;
};
struct PlaceUploaded {
    std::vector<std::uint8_t> bytes;
    std::string name;
    std::uint32_t director = 0;
    HttpReply reply;
};
struct Interrupted {};
using HostEvent = std::variant<Opened, Received, Refused, Closed, TakeRequested, TakeUploaded, TakeEdited,
                               HandoverRequested, PlaceRequested, PlaceUploaded, Interrupted>;

/// Callbacks that post to the mailbox. There is no shelf of takes.
ServerEvents eventsTo(Mailbox<HostEvent>& mailbox, std::atomic<bool>& interrupted);
/// A new world costs much and replaces everything before it. Of equal waiting requests for one only the last
/// is handled, so that a client cannot keep the simulation busy by repeating it.
void dropRepeated(std::vector<HostEvent>& events);

/// Runs the server on its own thread; the destructor stops it.
class Serving {
public:
    /// `failed` is called where the server ends by itself.
    Serving(StudioServer& server, const std::function<void()>& failed)
        : server_(server), thread_([this, failed] { run(failed); }) {}
    ~Serving() {
        server_.stop();
        thread_.join();
    }
    bool good() const { return good_; }  ///< It has not ended by itself.

private:
    void run(const std::function<void()>& failed);

    StudioServer& server_;
    std::atomic<bool> good_ = true;
    std::thread thread_;  // The last member, because the thread uses the others.
};

/// How a page is served.
struct ServeOptions {
    int port = 8080;         ///< Where it is in use, the next free one is taken.
    std::string pageFolder;  ///< Folder of the built page.
    /// Folder of the engine for browsers, with which the page goes on where the server is lost; empty for
    /// none.
    std::string engineFolder;
    std::string scenarioFolder;  ///< Folder of the scenarios that this engine offers.
    std::string mode;  ///< What the page shows instead of the studio: "study"; empty for the studio.
    std::string title = "Muster studio";  ///< Printed before the address.
    bool lan = false;                     ///< Others in the network may come, by a link with a token.
    bool openBrowser = false;             ///< Opens the page in the desktop's browser.
    bool json = false;                    ///< Prints address and port as one JSON value.
    std::string site;  ///< Address of a site for links that need no studio; empty for none.
};

/// The definition of a server of that page, without its events. Fails where there is no page.
Result<ServerDef> serverDef(const ServeOptions& options);
/// Prints the address, and the links for others in the network; opens the browser, where that is wanted.
/// `token`: what guests must show.
void announce(const ServeOptions& options, StudioServer& server, const std::string& token);
/// Opens the page in the desktop's browser, where that is wanted.
void openPage(const ServeOptions& options, int port);
/// Prints why a server does not run; returns the exit code.
int serveFailed(const Status& status);

}  // namespace muster
