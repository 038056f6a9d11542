// HTTP files and WebSocket messages on one port (docs/security.md).
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "http_answer.h"
#include "muster/status.h"
#include "shelf_request.h"
#include "static_files.h"

namespace muster {

/// Limits of the server. A value equal to its limit is accepted.
struct ServerLimits {
    std::size_t messageBytes = 64 * 1024;  ///< Size of one message of a client.
    double messagesPerSecond = 400.0;      ///< Average rate of messages of one client.
    double messageBurst = 800.0;           ///< Number of messages that a client may send at once.
    std::uint32_t headerBytes = 8 * 1024;  ///< Size of an HTTP request's first line and fields.
    int handshakeSeconds = 5;              ///< Time from the connection to the complete request.
    int bodySeconds = 60;                  ///< Time for the body of a take.
    /// A WebSocket is pinged after half of this time and closed after all of it.
    int idleSeconds = 30;
    std::size_t clients = 16;                       ///< Number of simultaneous WebSockets.
    std::size_t connections = 128;                  ///< Number of simultaneous connections of any kind.
    std::size_t takeBytes = std::size_t{64} << 20;  ///< Size of an uploaded take.
    /// Size of the messages that wait for one client; beyond it the connection is closed.
    std::size_t queuedBytes = std::size_t{32} << 20;
};

/// Sends the answer. It may be called from any thread, once.
using HttpReply = std::function<void(HttpAnswer)>;

/// Identifies a WebSocket; numbers are never used again.
using ConnectionId = std::uint64_t;

/// Callbacks of the server. All are called on the thread in run() and must not block.
struct ServerEvents {
    std::function<void(ConnectionId)> opened;
    /// Returns false where the queue has no space for the message.
    std::function<bool(ConnectionId, std::vector<std::uint8_t>)> received;
    /// Called where a message was dropped, with a code and a sentence for the client.
    std::function<void(ConnectionId, std::string code, std::string text)> refused;
    std::function<void(ConnectionId)> closed;
    std::function<void(HttpReply)> takeRequested;
    std::function<void(std::vector<std::uint8_t>, std::string target, HttpReply)> takeUploaded;
    std::function<void(std::string target, HttpReply)> handoverRequested;
    std::function<void(HttpReply)> placeRequested;
    std::function<void(std::vector<std::uint8_t>, std::string target, HttpReply)> placeUploaded;
    /// Called for requests to the shelf of takes and to exports.
    std::function<void(ShelfRequest, HttpReply)> shelfRequested;
    std::function<void()> interrupted;  ///< Called for each Ctrl+C or request to end.
};

/// Options of a server.
struct ServerDef {
    /// Where the port is in use, the next free one is used; 0 for any.
    int port = 8080;
    std::string pageFolder;                   ///< Folder of the files served at /.
    std::map<std::string, StaticFile> files;  ///< Further files by path, for example "/bodies/body-1.glb".
    std::string subprotocol;                  ///< Subprotocol that WebSockets must request.
    /// What guests from other machines must show. Empty: it listens on 127.0.0.1 only.
    std::string token;
    ServerLimits limits;
    ServerEvents events;
};

/// The server. run() occupies one thread; send() and stop() may be called from any.
class StudioServer {
public:
    /// Listens on 127.0.0.1, with a token on all IPv4 addresses. Fails with IoError where no port is free.
    static Result<std::unique_ptr<StudioServer>> listen(ServerDef def);
    ~StudioServer();

    /// The port that it listens on.
    int port() const;
    /// Serves one more file. Call before run().
    void addFile(const std::string& path, StaticFile file);
    /// Serves until stop().
    void run();
    /// Ends run(), closing all connections.
    void stop();
    /// Sends messages in order; does nothing where the connection is closed.
    void send(ConnectionId connection, std::vector<std::vector<std::uint8_t>> messages);

    struct Impl;  ///< The implementation.

private:
    explicit StudioServer(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
