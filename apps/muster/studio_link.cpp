#include "studio_link.h"

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>

namespace muster {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using LinkError = beast::error_code;
using Socket = websocket::stream<beast::tcp_stream, false>;

constexpr std::chrono::seconds kConnectTime(5);
constexpr std::size_t kMostKept = 2000;  // Messages that nobody has asked for.
constexpr const char* kTarget = "/ws";

}  // namespace

Result<StudioAddress> StudioAddress::read(std::string text) {
    for (const char* begin : {"ws://", "http://"})
        if (text.starts_with(begin)) text.erase(0, std::string(begin).size());
    if (const std::size_t slash = text.find('/'); slash != std::string::npos) text.erase(slash);
    StudioAddress address;
    const std::size_t colon = text.rfind(':');
    address.host = text.substr(0, colon);
    if (colon != std::string::npos) address.port = text.substr(colon + 1);
    const bool digits = address.port.find_first_not_of("0123456789") == std::string::npos;
    if (address.host.empty() || address.port.empty() || !digits || address.port.size() > 5)
        return invalidArgument("found the address '" + text + "', expected one like ws://127.0.0.1:8080");
    return address;
}

/// One connection. All of it but the queue of what has come belongs to the thread that runs the context.
struct StudioLink::Impl {
    StudioAddress address;
    std::string name;
    asio::io_context context;
    std::unique_ptr<Socket> socket;
    beast::flat_buffer buffer;
    std::deque<std::vector<std::uint8_t>> writes;
    std::thread thread;

    std::mutex mutex;
    std::condition_variable came;
    std::deque<std::vector<std::uint8_t>> inbox;
    bool open = false;

    std::string where() const { return address.host + ":" + address.port; }

    Status connect() {
        close();
        context.restart();
        socket = std::make_unique<Socket>(context);
        if (Status reached = reach(); !reached.ok()) return close(), reached;
        socket->binary(true);
        socket->read_message_max(64u << 20);
        {
            const std::lock_guard lock(mutex);
            open = true;
            inbox.clear();
        }
        read();
        put(protocol::encode(protocol::Hello{name}));
        thread = std::thread([this] { context.run(); });
        return {};
    }

    // A deadline ends only what is asynchronous: this runs the context until each part has ended.
    Status reach() {
        LinkError error;
        asio::ip::tcp::resolver resolver(context);
        const auto found = resolver.resolve(address.host, address.port, error);
        auto& lowest = beast::get_lowest_layer(*socket);
        lowest.expires_after(kConnectTime);
        if (!error) lowest.async_connect(found, [&](LinkError ended, const auto&) { error = ended; });
        finishWork();
        if (error)
            return {StatusCode::IoError,
                    "No studio answers at " + where() + ": start one with 'muster studio'."};
        lowest.expires_never();  // The handshake has a deadline of its own.
        auto deadlines = websocket::stream_base::timeout::suggested(beast::role_type::client);
        deadlines.handshake_timeout = kConnectTime;
        socket->set_option(deadlines);
        socket->set_option(websocket::stream_base::decorator([this](websocket::request_type& request) {
            request.set(beast::http::field::origin, "http://" + where());
            request.set(beast::http::field::sec_websocket_protocol, protocol::kSubprotocol);
        }));
        websocket::response_type response;
        socket->async_handshake(response, where(), kTarget, [&](LinkError ended) { error = ended; });
        finishWork();
        if (error == beast::error::timeout) return silent();
        if (error)
            return {StatusCode::IoError, "The studio at " + where() + " refuses: " +
                                             (response.body().empty() ? error.message() : response.body())};
        return {};
    }

    void finishWork() {
        context.run();
        context.restart();
    }

    Status silent() const {
        return {StatusCode::IoError,
                "What listens at " + where() +
                    " does not answer as a studio does: start one with 'muster studio'."};
    }

    void close() {
        context.stop();
        if (thread.joinable()) thread.join();
        writes.clear();
        buffer.clear();
        socket.reset();
        const std::lock_guard lock(mutex);
        open = false;
    }

    void lost() {
        const std::lock_guard lock(mutex);
        open = false;
        came.notify_all();
    }

    void read() {
        socket->async_read(buffer, [this](LinkError error, std::size_t) {
            if (error) return lost();
            const auto data = buffer.cdata();
            const auto* from = static_cast<const std::uint8_t*>(data.data());
            {
                const std::lock_guard lock(mutex);
                inbox.emplace_back(from, from + data.size());
                if (inbox.size() > kMostKept) inbox.pop_front();
                came.notify_all();
            }
            buffer.consume(buffer.size());
            read();
        });
    }

    void put(std::vector<std::uint8_t> bytes) {
        writes.push_back(std::move(bytes));
        if (writes.size() == 1) write();
    }

    void write() {
        socket->async_write(asio::buffer(writes.front()), [this](LinkError error, std::size_t) {
            if (error) return lost();
            writes.pop_front();
            if (!writes.empty()) write();
        });
    }
};

StudioLink::StudioLink(StudioAddress address, std::string name) : impl_(std::make_unique<Impl>()) {
    impl_->address = std::move(address);
    impl_->name = std::move(name);
}

StudioLink::~StudioLink() {
    impl_->close();
}

Status StudioLink::send(std::vector<std::uint8_t> bytes) {
    bool open = false;
    {
        const std::lock_guard lock(impl_->mutex);
        open = impl_->open;
    }
    if (!open) {
        if (Status connected = impl_->connect(); !connected.ok()) return connected;
        const bool greeted = await(kConnectTime, [](const protocol::ServerMessage& message) {
            return std::holds_alternative<protocol::Welcome>(message);
        });
        if (!greeted) return impl_->close(), impl_->silent();
    }
    asio::post(impl_->context,
               [impl = impl_.get(), bytes = std::move(bytes)]() mutable { impl->put(std::move(bytes)); });
    return {};
}

bool StudioLink::await(std::chrono::milliseconds most,
                       const std::function<bool(const protocol::ServerMessage&)>& take) {
    const auto until = std::chrono::steady_clock::now() + most;
    std::unique_lock lock(impl_->mutex);
    for (;;) {
        while (!impl_->inbox.empty()) {
            const std::vector<std::uint8_t> bytes = std::move(impl_->inbox.front());
            impl_->inbox.pop_front();
            lock.unlock();
            const auto message = protocol::decodeServer(bytes);
            if (message.ok() && take(message.value())) return true;
            lock.lock();
        }
        if (!impl_->open || impl_->came.wait_until(lock, until) == std::cv_status::timeout) return false;
    }
}

void StudioLink::forget() {
    const std::lock_guard lock(impl_->mutex);
    impl_->inbox.clear();
}

}  // namespace muster
