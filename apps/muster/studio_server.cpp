// The only file that knows Boost.Beast: it takes 20 s and 0.8 GB to compile.
#include "studio_server.h"

#include <fcntl.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <csignal>
#include <deque>
#include <map>
#include <utility>

#include "session/token_bucket.h"
#include "static_files.h"

namespace muster {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using tcp = asio::ip::tcp;
using Error = beast::error_code;
using Request = http::request<http::vector_body<std::uint8_t>>;
using Response = http::response<http::string_body>;

constexpr int kPortsTried = 100;
constexpr int kLingerSeconds = 2;
constexpr const char* kSocketPath = "/ws";
constexpr const char* kTakePath = "/take";
constexpr const char* kHealthPath = "/health";

double secondsNow() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string text(beast::string_view view) {
    return {view.data(), view.size()};
}

// Programs that we start (the browser) get no hold of our sockets.
void keepToOurselves(int socket) {
    fcntl(socket, F_SETFD, FD_CLOEXEC);
}

}  // namespace

class SocketConnection;

struct StudioServer::Impl {
    explicit Impl(ServerDef serverDef)
        : def(std::move(serverDef)), context(1), acceptor(context), signals(context, SIGINT, SIGTERM) {}
    Impl(const Impl&) = delete;

    Status open();
    void accept();
    void awaitSignal();
    bool knownHost(const std::string& host) const;
    bool knownOrigin(const std::string& origin) const;
    void secure(Response& response) const;

    ServerDef def;
    int port = 0;
    std::size_t connections = 0;
    ConnectionId lastSocket = 0;
    std::size_t sockets = 0;  // Also those still shaking hands.
    std::map<ConnectionId, std::weak_ptr<SocketConnection>> open_;
    // Last, so that connections, which the context owns, go before what they report to.
    asio::io_context context;
    tcp::acceptor acceptor;
    asio::signal_set signals;
};

// ---- WebSockets ----

// A client's WebSocket: reads one message at a time, writes from a bounded queue.
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
        server_.open_.erase(id_);
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
        // Somebody who takes no bytes at all is cut, so that the queue stays bounded.
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
        server_.open_[id_] = weak_from_this();
        server_.def.events.opened(id_);
        read();
    }

    void read() {
        socket_.async_read(buffer_, [self = shared_from_this()](Error error, std::size_t) {
            if (error) return;  // Closed, too large (Beast tells the client 1009), silent or broken.
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
    websocket::stream<beast::tcp_stream> socket_;
    beast::flat_buffer buffer_;
    TokenBucket rate_;
    double began_;
    bool refusing_ = false;
    ConnectionId id_ = 0;  // 0 until the handshake is done.
    std::deque<std::vector<std::uint8_t>> queue_;
    std::size_t queued_ = 0;  // Bytes.
};

// ---- HTTP ----

// A TCP connection while it speaks HTTP; it becomes a SocketConnection where a request upgrades it.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
public:
    HttpConnection(StudioServer::Impl& server, tcp::socket socket)
        : server_(server), stream_(std::move(socket)) {
        ++server_.connections;
    }
    ~HttpConnection() { --server_.connections; }

    // Reads the next request's head.
    void start() {
        parser_ = std::make_unique<http::request_parser<http::vector_body<std::uint8_t>>>();
        parser_->header_limit(server_.def.limits.headerBytes);
        parser_->body_limit(server_.def.limits.takeBytes);
        stream_.expires_after(std::chrono::seconds(server_.def.limits.handshakeSeconds));
        http::async_read_header(stream_, buffer_, *parser_,
                                [self = shared_from_this()](Error error, std::size_t size) {
                                    // Beast counts the first line and the fields apart; the limit is for
                                    // both.
                                    if (!error && size > self->server_.def.limits.headerBytes)
                                        error = http::error::header_limit;
                                    self->headRead(error);
                                });
    }

private:
    void headRead(Error error) {
        if (error == http::error::header_limit || error == http::error::buffer_overflow)
            return refuse(431, "The request's header is too large.");
        if (error == http::error::body_limit) return refuse(413, "The body is too large.");
        if (error == http::error::end_of_stream) return close();
        const auto& ofHttp = http::make_error_code(http::error::bad_field).category();
        if (error && error.category() != ofHttp) return;  // Gone, or too slow.
        if (error) return refuse(400, "The request cannot be read.");
        const Request& request = parser_->get();
        if (request.count(http::field::host) != 1 || !server_.knownHost(text(request[http::field::host])))
            return refuse(403, "Unknown host: the studio answers to 127.0.0.1 and localhost only.");
        if (websocket::is_upgrade(request)) return upgrade();
        if (request.method() == http::verb::post) return post();
        if (request.method() != http::verb::get && request.method() != http::verb::head)
            return refuse(405, "Only GET, HEAD and POST are known.");
        if (parser_->content_length() && *parser_->content_length() > 0)
            return refuse(413, "No body is expected here.");
        if (parser_->chunked()) return refuse(413, "No body is expected here.");
        get();
    }

    void upgrade() {
        const Request& request = parser_->get();
        if (text(request.target()) != kSocketPath) return refuse(404, "There is no WebSocket here.");
        if (!originKnown()) return refuse(403, "Unknown origin.");
        bool offered = false;
        for (const auto& name : http::token_list(request[http::field::sec_websocket_protocol]))
            offered = offered || text(name) == server_.def.subprotocol;
        if (!offered) return refuse(400, "The subprotocol " + server_.def.subprotocol + " is expected.");
        if (server_.sockets >= server_.def.limits.clients) return refuse(503, "Too many clients.");
        std::make_shared<SocketConnection>(server_, std::move(stream_))->start(request);
    }

    bool originKnown() const {
        const Request& request = parser_->get();
        return request.count(http::field::origin) == 1 &&
               server_.knownOrigin(text(request[http::field::origin]));
    }

    // A take may be large: pages of others must not have it made, though they could not read it. Browsers say
    // where a request comes from; programs of this machine need not.
    bool takeKnown() const {
        const Request& request = parser_->get();
        const std::string site = text(request["Sec-Fetch-Site"]);
        if (!site.empty() && site != "same-origin" && site != "none") return false;
        return request.count(http::field::origin) == 0 || originKnown();
    }

    void post() {
        if (text(parser_->get().target()) != kTakePath) return refuse(404, "Nothing can be sent here.");
        if (!originKnown()) return refuse(403, "Unknown origin.");
        const auto length = parser_->content_length();
        if (!length) return refuse(411, "The length of the take is expected.");
        if (*length > server_.def.limits.takeBytes) return refuse(413, "The take is too large.");
        stream_.expires_after(std::chrono::seconds(server_.def.limits.bodySeconds));
        http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](Error error, std::size_t) {
            if (error == http::error::body_limit) return self->refuse(413, "The take is too large.");
            if (error) return;
            self->server_.def.events.takeSent(std::move(self->parser_->get().body()), self->reply());
        });
    }

    void get() {
        const std::string target = text(parser_->get().target());
        if (target == kTakePath)
            return takeKnown() ? server_.def.events.takeAsked(reply()) : refuse(403, "Unknown origin.");
        HttpAnswer answer;
        if (target == kHealthPath) {
            answer.type = "application/json";
            answer.body = "{\"status\":\"ok\"}\n";
            return respond(std::move(answer), "no-store");
        }
        auto file = made(target);
        if (!file) file = readStaticFile(server_.def.pageFolder, target);
        if (!file) return refuse(404, "There is no such file.", true);
        answer.type = std::move(file->type);
        answer.body = std::move(file->body);
        respond(std::move(answer), file->cache);
    }

    // A file that lies in no folder.
    std::optional<StaticFile> made(const std::string& target) const {
        const auto path = plainPath(target);
        const auto found = path ? server_.def.files.find(*path) : server_.def.files.end();
        if (found == server_.def.files.end()) return std::nullopt;
        return found->second;
    }

    // What the simulation's thread calls with its answer.
    HttpReply reply() {
        stream_.expires_never();
        return [self = shared_from_this(), &context = server_.context](HttpAnswer answer) {
            asio::post(context, [self, answer = std::move(answer)]() mutable {
                self->respond(std::move(answer), "no-store");
            });
        };
    }

    // Answers and, unless `keep`, closes: what follows may be the body of what was refused.
    void refuse(int status, const std::string& sentence, bool keep = false) {
        HttpAnswer answer;
        answer.status = status;
        answer.body = sentence + "\n";
        keep_ = keep;
        respond(std::move(answer), "no-store");
    }

    void respond(HttpAnswer answer, const std::string& cache) {
        const Request& request = parser_->get();
        response_ = Response(static_cast<http::status>(answer.status), 11);
        response_.set(http::field::content_type, answer.type);
        response_.set(http::field::cache_control, cache);
        if (!answer.fileName.empty())
            response_.set(http::field::content_disposition,
                          "attachment; filename=\"" + answer.fileName + "\"");
        server_.secure(response_);
        response_.keep_alive(keep_ && parser_->is_header_done() && request.keep_alive());
        response_.body() = std::move(answer.body);
        response_.prepare_payload();
        if (parser_->is_header_done() && request.method() == http::verb::head) response_.body().clear();
        stream_.expires_after(std::chrono::seconds(server_.def.limits.bodySeconds));
        http::async_write(stream_, response_, [self = shared_from_this()](Error error, std::size_t) {
            if (error || !self->response_.keep_alive()) return self->close();
            self->start();
        });
    }

    // Says that nothing more comes, then swallows what is still on its way: closing at once would reset the
    // connection, and the client might lose our answer.
    void close() {
        Error ignored;
        stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
        stream_.expires_after(std::chrono::seconds(kLingerSeconds));
        swallow();
    }

    void swallow() {
        stream_.async_read_some(asio::buffer(swallowed_),
                                [self = shared_from_this()](Error error, std::size_t size) {
                                    self->swallowedBytes_ += size;
                                    if (!error && self->swallowedBytes_ < self->server_.def.limits.takeBytes)
                                        self->swallow();
                                });
    }

    StudioServer::Impl& server_;
    beast::tcp_stream stream_;
    beast::flat_buffer buffer_;
    std::unique_ptr<http::request_parser<http::vector_body<std::uint8_t>>> parser_;
    Response response_;
    bool keep_ = true;
    std::array<char, 4096> swallowed_{};
    std::size_t swallowedBytes_ = 0;
};

// ---- The server ----

Status StudioServer::Impl::open() {
    const int last = def.port == 0 ? 0 : std::min(def.port + kPortsTried - 1, 65535);
    for (int candidate = def.port; candidate <= last; ++candidate) {
        Error error;
        const tcp::endpoint endpoint(asio::ip::address_v4::loopback(),
                                     static_cast<unsigned short>(candidate));
        acceptor.open(endpoint.protocol(), error);
        if (!error) keepToOurselves(acceptor.native_handle());
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
            keepToOurselves(socket.native_handle());
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

bool StudioServer::Impl::knownHost(const std::string& host) const {
    const std::string number = ":" + std::to_string(port);
    return host == "127.0.0.1" + number || host == "localhost" + number;
}

bool StudioServer::Impl::knownOrigin(const std::string& origin) const {
    const std::string scheme = "http://";
    return origin.rfind(scheme, 0) == 0 && knownHost(origin.substr(scheme.size()));
}

void StudioServer::Impl::secure(Response& response) const {
    const std::string number = std::to_string(port);
    response.set(
        "Content-Security-Policy",
        "default-src 'self'; script-src 'self'; worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; "
        "img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self' data: blob: ws://127.0.0.1:" +
            number + " ws://localhost:" + number +
            "; frame-ancestors 'none'; base-uri 'none'; form-action 'none'");
    response.set("X-Content-Type-Options", "nosniff");
    response.set("X-Frame-Options", "DENY");
    response.set("Referrer-Policy", "no-referrer");
    response.set("Cross-Origin-Opener-Policy", "same-origin");
    response.set("Cross-Origin-Resource-Policy", "same-origin");
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
        const auto found = impl->open_.find(connection);
        if (found == impl->open_.end()) return;
        if (const auto socket = found->second.lock()) socket->send(std::move(messages));
    });
}

}  // namespace muster
