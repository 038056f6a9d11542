// The only source that includes Boost.Beast.
#include "studio_server.h"

#include <fcntl.h>

#include <algorithm>
#include <csignal>
#include <utility>

#include "http_connection.h"

namespace muster {
namespace {

constexpr int kPortsTried = 100;

/// Keeps programs that this process starts (the browser) from inheriting its sockets.
void closeOnExec(int socket) {
    fcntl(socket, F_SETFD, FD_CLOEXEC);
}

}  // namespace

Status StudioServer::Impl::open() {
    const int last = def.port == 0 ? 0 : std::min(def.port + kPortsTried - 1, 65535);
    for (int candidate = def.port; candidate <= last; ++candidate) {
        Error error;
        const auto address = def.token.empty() ? asio::ip::address_v4::loopback()
                                               : asio::ip::address_v4::any();
        const tcp::endpoint endpoint(address, static_cast<unsigned short>(candidate));
        acceptor.open(endpoint.protocol(), error);
        if (!error) closeOnExec(acceptor.native_handle());
        if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
        if (!error) acceptor.bind(endpoint, error);
        if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
        if (!error) {
            port = acceptor.local_endpoint().port();
            return {};
        }
        Error ignored;
        acceptor.close(ignored);
        if (error != asio::error::address_in_use)
            return {StatusCode::IoError, "port " + std::to_string(candidate) + ": " + error.message()};
    }
    return {StatusCode::IoError,
            "ports " + std::to_string(def.port) + " to " + std::to_string(last) + " are all in use"};
}

void StudioServer::Impl::accept() {
    acceptor.async_accept([this](Error error, tcp::socket socket) {
        if (!acceptor.is_open()) return;
        if (!error && connections < def.limits.connections) {
            Error ignored;
            closeOnExec(socket.native_handle());
            socket.set_option(tcp::no_delay(true), ignored);
            std::make_shared<HttpConnection>(*this, std::move(socket))->start();
        }
        accept();
    });
}

void StudioServer::Impl::awaitSignal() {
    signals.async_wait([this](Error error, int) {
        if (error) return;
        def.events.interrupted();
        awaitSignal();
    });
}

StudioServer::StudioServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

StudioServer::~StudioServer() = default;

Result<std::unique_ptr<StudioServer>> StudioServer::listen(ServerDef def) {
    auto impl = std::make_unique<Impl>(std::move(def));
    const Status status = impl->open();
    if (!status.ok()) return status;
    return std::unique_ptr<StudioServer>(new StudioServer(std::move(impl)));
}

int StudioServer::port() const {
    return impl_->port;
}

void StudioServer::addFile(const std::string& path, StaticFile file) {
    impl_->def.files[path] = std::move(file);
}

void StudioServer::run() {
    impl_->accept();
    impl_->awaitSignal();
    impl_->context.run();
}

void StudioServer::stop() {
    impl_->context.stop();
}

void StudioServer::send(ConnectionId connection, std::vector<std::vector<std::uint8_t>> messages) {
    asio::post(impl_->context, [impl = impl_.get(), connection, messages = std::move(messages)]() mutable {
        const auto found = impl->openSockets.find(connection);
        if (found == impl->openSockets.end()) return;
        if (const auto socket = found->second.lock()) socket->send(std::move(messages));
    });
}

}  // namespace muster
