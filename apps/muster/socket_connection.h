// WebSockets of the studio's server.
#pragma once

#include <boost/beast/websocket.hpp>
#include <deque>
#include <utility>
#include <vector>

#include "base/token_bucket.h"
#include "server_impl.h"

namespace muster {

namespace http = beast::http;
namespace websocket = beast::websocket;
using Request = http::request<http::vector_body<std::uint8_t>>;

/// A client's WebSocket. It reads one message at a time and writes from a bounded queue.
class SocketConnection : public std::enable_shared_from_this<SocketConnection> {
public:
    SocketConnection(StudioServer::Impl& server, beast::tcp_stream stream)
        : server_(server),
          socket_(std::move(stream)),
          rate_(server.def.limits.messagesPerSecond, server.def.limits.messageBurst),
          began_(secondsNow()) {
        ++server_.sockets;
        ++server_.connections;
    }
    ~SocketConnection() {
        --server_.sockets;
        --server_.connections;
        if (id_ == 0) return;
        server_.openSockets.erase(id_);
        server_.def.events.closed(id_);
    }

    void start(const Request& request) {
        const ServerLimits& limits = server_.def.limits;
        websocket::stream_base::timeout timeout;
        timeout.handshake_timeout = std::chrono::seconds(limits.handshakeSeconds);
        timeout.idle_timeout = std::chrono::seconds(limits.idleSeconds);
        timeout.keep_alive_pings = true;
        beast::get_lowest_layer(socket_).expires_never();
        socket_.set_option(timeout);
        socket_.set_option(websocket::stream_base::decorator([this](websocket::response_type& response) {
            response.set(http::field::sec_websocket_protocol, server_.def.subprotocol);
        }));
        socket_.read_message_max(limits.messageBytes);
        socket_.binary(true);
        socket_.async_accept(request, [self = shared_from_this()](Error error) {
            if (!error) self->opened();
        });
    }

    void send(std::vector<std::vector<std::uint8_t>> messages) {
        const bool idle = queue_.empty();
        for (auto& message : messages) {
            queued_ += message.size();
            queue_.push_back(std::move(message));
        }
        // Closes the connection to a client that reads nothing, so that the queue stays bounded.
        if (queued_ > server_.def.limits.queuedBytes) return cut();
        if (idle) write();
    }

    void cut() {
        Error ignored;
        beast::get_lowest_layer(socket_).socket().close(ignored);
    }

private:
    void opened() {
        id_ = ++server_.lastSocket;
        server_.openSockets[id_] = weak_from_this();
        server_.def.events.opened(id_);
        read();
    }

    void read() {
        socket_.async_read(buffer_, [self = shared_from_this()](Error error, std::size_t) {
            // The connection is closed, silent or broken, or the message is too large (Beast sends the client
            // code 1009).
            if (error) return;
            self->received();
            self->read();
        });
    }

    void received() {
        const auto data = buffer_.cdata();
        const auto* from = static_cast<const std::uint8_t*>(data.data());
        std::vector<std::uint8_t> bytes(from, from + data.size());
        buffer_.consume(buffer_.size());
        const ServerEvents& events = server_.def.events;
        if (!rate_.take(secondsNow() - began_)) {
            if (!refusing_) events.refused(id_, "rate", "Too many messages a second; some were dropped.");
            refusing_ = true;
            return;
        }
        refusing_ = false;
        if (socket_.got_text()) {
            events.refused(id_, "malformed", "Found a text message, expected a binary one.");
        } else if (!events.received(id_, std::move(bytes))) {
            events.refused(id_, "busy", "The simulation is busy; a message was dropped.");
        }
    }

    void write() {
        if (queue_.empty()) return;
        socket_.async_write(asio::buffer(queue_.front()),
                            [self = shared_from_this()](Error error, std::size_t) {
                                if (error) return self->cut();
                                self->queued_ -= self->queue_.front().size();
                                self->queue_.pop_front();
                                self->write();
                            });
    }

    StudioServer::Impl& server_;
    /// Compression is off: frames of a crowd hardly shrink, and it costs seconds of compile time.
    websocket::stream<beast::tcp_stream, false> socket_;
    beast::flat_buffer buffer_;
    TokenBucket rate_;
    double began_;
    bool refusing_ = false;
    ConnectionId id_ = 0;  // 0 until the handshake is complete.
    std::deque<std::vector<std::uint8_t>> queue_;
    std::size_t queued_ = 0;  // Bytes.
};

}  // namespace muster
