// What the server's connections share. Only studio_server.cpp includes this, directly or not: Boost.Beast
// takes 15 s to compile.
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

/// The server's state. All of it belongs to the thread in run().
struct StudioServer::Impl {
    explicit Impl(ServerDef serverDef)
        : def(std::move(serverDef)), context(1), acceptor(context), signals(context, SIGINT, SIGTERM) {}
    Impl(const Impl&) = delete;

    Status open();
    void accept();
    void awaitSignal();

    ServerDef def;
    int port = 0;
    std::size_t connections = 0;  ///< Open ones of any kind.
    ConnectionId lastSocket = 0;
    std::size_t sockets = 0;  ///< WebSockets, also those still shaking hands.
    std::map<ConnectionId, std::weak_ptr<SocketConnection>> openSockets;
    // Last, so that connections, which the context owns, go before what they report to.
    asio::io_context context;
    tcp::acceptor acceptor;
    asio::signal_set signals;
};

}  // namespace muster
