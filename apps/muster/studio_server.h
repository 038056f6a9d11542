// HTTP files and WebSocket messages on one port of the loopback interface (docs/security.md).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "muster/status.h"
#include "static_files.h"

namespace muster {

/// What the server refuses, at its edge: the limit itself still passes.
struct ServerLimits {
    std::size_t messageBytes = 64 * 1024;           ///< Of one message of a client.
    double messagesPerSecond = 400.0;               ///< Of one client, on average.
    double messageBurst = 800.0;                    ///< ... and at once.
    std::uint32_t headerBytes = 8 * 1024;           ///< Of an HTTP request: its first line and fields.
    int handshakeSeconds = 5;                       ///< From connecting to the whole request.
    int bodySeconds = 60;                           ///< For the body of a take.
    int idleSeconds = 30;                           ///< A WebSocket is pinged at half of it, closed after it.
    std::size_t clients = 16;                       ///< WebSockets at once.
    std::size_t connections = 128;                  ///< Of any kind at once.
    std::size_t takeBytes = std::size_t{64} << 20;  ///< Of a take sent to us.
    /// Waiting for one client that does not read; then it is cut.
    std::size_t queuedBytes = std::size_t{32} << 20;
};

/// An answer to a request that the simulation serves.
struct HttpAnswer {
    int status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::string body;
    std::string fileName;  ///< Offered for saving; empty to show.
};
/// Gives the answer, from any thread, once.
using HttpReply = std::function<void(HttpAnswer)>;

/// Names a WebSocket; never used again.
using ConnectionId = std::uint64_t;

/// Where the server reports. All are called on the thread in run() and must not block.
struct ServerEvents {
    std::function<void(ConnectionId)> opened;
    /// False where there is no room for the message.
    std::function<bool(ConnectionId, std::vector<std::uint8_t>)> received;
    /// A message was dropped: a code and a sentence for the client.
    std::function<void(ConnectionId, std::string code, std::string text)> refused;
    std::function<void(ConnectionId)> closed;
    std::function<void(HttpReply)> takeRequested;
    std::function<void(std::vector<std::uint8_t>, HttpReply)> takeUploaded;
    std::function<void()> interrupted;  ///< Ctrl+C or a request to end; each time.
};

/// What a server is made from.
struct ServerDef {
    int port = 8080;                          ///< The next free one is taken where it is in use; 0 for any.
    std::string pageFolder;                   ///< Files served at /.
    std::map<std::string, StaticFile> files;  ///< Served too, by path: "/bodies/body-1.glb".
    std::string subprotocol;                  ///< That WebSockets must ask for.
    ServerLimits limits;
    ServerEvents events;
};

/// The server. run() on one thread; send() and stop() from any.
class StudioServer {
public:
    /// Listens on 127.0.0.1. Fails with IoError where no port is free.
    static Result<std::unique_ptr<StudioServer>> listen(ServerDef def);
    ~StudioServer();

    /// Where it listens.
    int port() const;
    /// Serves until stop().
    void run();
    /// Ends run(), closing all connections.
    void stop();
    /// Sends messages in order; nothing where the connection has gone.
    void send(ConnectionId connection, std::vector<std::vector<std::uint8_t>> messages);

    struct Impl;  ///< Private.

private:
    explicit StudioServer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
