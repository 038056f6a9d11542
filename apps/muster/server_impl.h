// State that the server's connections share. Only studio_server.cpp may include this, directly or not,
// because Boost.Beast takes 15 s to compile.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/beast/core.hpp>
#include <chrono>
#include <csignal>
#include <map>
#include <memory>
#include <string>

#include "studio_server.h"

namespace muster {

namespace asio = boost::asio;
namespace beast = boost::beast;
using tcp = asio::ip::tcp;
using Error = beast::error_code;

inline double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

inline std::string toString(beast::string_view view) {
    return {view.data(), view.size()};
}

class SocketConnection;

/// The server's state. It belongs to the thread in run().
struct StudioServer::Impl {
    explicit Impl(ServerDef serverDef)
        : def(std::move(serverDef)), context(1), acceptor(context), signals(context, SIGINT, SIGTERM) {}
    Impl(const Impl&) = delete;

    Status open();
    void accept();
    void awaitSignal();

    ServerDef def;
    int port = 0;
    std::size_t connections = 0;  ///< Number of open connections of any kind.
    ConnectionId lastSocket = 0;
    std::size_t sockets = 0;  ///< Number of WebSockets, including those in the handshake.
    std::map<ConnectionId, std::weak_ptr<SocketConnection>> openSockets;
    // The context is declared after the members above, so that the connections that it owns are destroyed
    // before those members.
    asio::io_context context;
    tcp::acceptor acceptor;
    asio::signal_set signals;
};

}  // namespace muster
