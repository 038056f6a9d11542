// HTTP requests to the studio's server: the page's files, takes, and the upgrade to a WebSocket.
#pragma once

#include <array>
#include <boost/asio/post.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/http/file_body.hpp>
#include <optional>
#include <utility>

#include "invitation.h"
#include "request_target.h"
#include "server_policy.h"
#include "socket_connection.h"
#include "static_files.h"

namespace muster {

using Response = http::response<http::string_body>;

/// Seconds that a closing connection waits for the client to close.
inline constexpr int kLingerSeconds = 2;
/// Time in which a file must be taken [s].
inline constexpr int kFileSeconds = 600;
inline constexpr const char* kSocketPath = "/ws";
inline constexpr const char* kTakePath = "/take";
inline constexpr const char* kPlacePath = "/scenario";
inline constexpr const char* kHandoverPath = "/handover";
inline constexpr const char* kCodePath = "/code";
inline constexpr const char* kHealthPath = "/health";

/// A TCP connection that speaks HTTP. It becomes a SocketConnection when a request upgrades it.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
public:
    HttpConnection(StudioServer::Impl& server, tcp::socket socket)
        : server_(server), stream_(std::move(socket)) {
        ++server_.connections;
        Error error;
        const auto here = stream_.socket().local_endpoint(error);
        door_ = {error ? std::string("0.0.0.0") : here.address().to_string(), server_.port,
                 server_.def.token};
    }
    ~HttpConnection() { --server_.connections; }

    // Reads the next request's header.
    void start() {
        parser_ = std::make_unique<http::request_parser<http::vector_body<std::uint8_t>>>();
        parser_->header_limit(server_.def.limits.headerBytes);
        parser_->body_limit(server_.def.limits.takeBytes);
        stream_.expires_after(std::chrono::seconds(server_.def.limits.handshakeSeconds));
        http::async_read_header(stream_, buffer_, *parser_,
                                [self = shared_from_this()](Error error, std::size_t size) {
                                    // Beast limits the first line and the fields separately; this limit is
                                    // for both together.
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
        if (error && error.category() != ofHttp) return;  // The client is gone or too slow.
        if (error) return refuse(400, "The request cannot be read.");
        const Request& request = parser_->get();
        if (request.count(http::field::host) != 1 || !isOwnHost(toString(request[http::field::host]), door_))
            return refuse(403, "Unknown host: the studio answers to its own address only.");
        if (linkHasToken(toString(request.target()), door_)) return invite();
        if (!door_.atDesk() && !cookieHasToken(toString(request[http::field::cookie]), door_))
            return refuse(403, "This studio opens by its link only. Whoever started it has the link.");
        if (websocket::is_upgrade(request)) return upgrade();
        if (isShelfTarget(toString(request.target()))) return askShelf();
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
        if (toString(request.target()) != kSocketPath) return refuse(404, "There is no WebSocket here.");
        if (!originKnown()) return refuse(403, "Unknown origin.");
        bool offered = false;
        for (const auto& name : http::token_list(request[http::field::sec_websocket_protocol]))
            offered = offered || toString(name) == server_.def.subprotocol;
        if (!offered) return refuse(400, "The subprotocol " + server_.def.subprotocol + " is expected.");
        if (server_.sockets >= server_.def.limits.clients) return refuse(503, "Too many clients.");
        std::make_shared<SocketConnection>(server_, std::move(stream_))->start(request);
    }

    // The browser keeps the token as a cookie, so that it stands in no address afterwards.
    void invite() {
        HttpAnswer answer{.status = 303, .body = "Welcome.\n", .location = "/"};
        respond(std::move(answer), "no-store");
    }

    bool originKnown() const {
        const Request& request = parser_->get();
        return request.count(http::field::origin) == 1 &&
               isOwnOrigin(toString(request[http::field::origin]), door_);
    }

    // The shelf of takes and exports. Reading is allowed as for /take, changing as for opening a take.
    void askShelf() {
        const Request& request = parser_->get();
        const bool head = request.method() == http::verb::head;
        auto asked = shelfRequest(head ? "GET" : toString(request.method_string()),
                                  toString(request.target()));
        if (!asked) return refuse(405, "Nothing of that kind can be done here.");
        if (isReading(asked->action) ? !takeKnown() : !originKnown()) return refuse(403, "Unknown origin.");
        const std::size_t most = mostBodyBytes(asked->action, server_.def.limits.takeBytes);
        const auto length = parser_->content_length();
        if (parser_->chunked() || (most > 0 && !length))
            return refuse(411, "The length of the body is expected.");
        if (length && *length > most) return refuse(413, "The body is too large.");
        stream_.expires_after(std::chrono::seconds(server_.def.limits.bodySeconds));
        auto read = [self = shared_from_this(), asked = *asked](Error error, std::size_t) mutable {
            if (error == http::error::body_limit) return self->refuse(413, "The body is too large.");
            if (error) return;
            asked.body = std::move(self->parser_->get().body());
            self->server_.def.events.shelfRequested(std::move(asked), self->reply());
        };
        http::async_read(stream_, buffer_, *parser_, std::move(read));
    }

    // Pages of other sites must not make the server build a large take, even though they could not read it.
    // Browsers state the origin of a request; local programs need not.
    bool takeKnown() const {
        const Request& request = parser_->get();
        const std::string site = toString(request["Sec-Fetch-Site"]);
        if (!site.empty() && site != "same-origin" && site != "none") return false;
        return request.count(http::field::origin) == 0 || originKnown();
    }

    void post() {
        const std::string target = toString(parser_->get().target());
        const bool place = withoutQuery(target) == kPlacePath;
        if (!place && withoutQuery(target) != kTakePath) return refuse(404, "Nothing can be sent here.");
        const std::string what = place ? "scenario" : "take";
        if (!originKnown()) return refuse(403, "Unknown origin.");
        const auto length = parser_->content_length();
        if (!length) return refuse(411, "The length of the " + what + " is expected.");
        if (*length > server_.def.limits.takeBytes) return refuse(413, "The " + what + " is too large.");
        stream_.expires_after(std::chrono::seconds(server_.def.limits.bodySeconds));
        auto read = [self = shared_from_this(), place, what, target](Error error, std::size_t) {
            if (error == http::error::body_limit) return self->refuse(413, "The " + what + " is too large.");
            if (error) return;
            auto body = std::move(self->parser_->get().body());
            const ServerEvents& events = self->server_.def.events;
            if (place) return events.placeUploaded(std::move(body), target, self->reply());
            events.takeUploaded(std::move(body), target, self->reply());
        };
        http::async_read(stream_, buffer_, *parser_, std::move(read));
    }

    void get() {
        const std::string target = toString(parser_->get().target());
        if (target == kTakePath)
            return takeKnown() ? server_.def.events.takeRequested(reply()) : refuse(403, "Unknown origin.");
        if (withoutQuery(target) == kHandoverPath)
            return takeKnown() ? server_.def.events.handoverRequested(target, reply())
                               : refuse(403, "Unknown origin.");
        if (target == kPlacePath)
            return takeKnown() ? server_.def.events.placeRequested(reply()) : refuse(403, "Unknown origin.");
        if (withoutQuery(target) == kCodePath)
            return takeKnown() ? respond(codeAnswer(queryValue(target, "text")), "no-store")
                               : refuse(403, "Unknown origin.");
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

    // Finds a file that is stored in memory instead of a folder.
    std::optional<StaticFile> made(const std::string& target) const {
        const auto path = plainPath(target);
        const auto found = path ? server_.def.files.find(*path) : server_.def.files.end();
        if (found == server_.def.files.end()) return std::nullopt;
        return found->second;
    }

    // Returns the callback that the simulation's thread calls with its answer.
    HttpReply reply() {
        stream_.expires_never();
        return [self = shared_from_this(), &context = server_.context](HttpAnswer answer) {
            asio::post(context, [self, answer = std::move(answer)]() mutable {
                self->respond(std::move(answer), "no-store");
            });
        };
    }

    // Answers. Closes unless `keep`, because a refused request's body may follow.
    void refuse(int status, const std::string& sentence, bool keep = false) {
        HttpAnswer answer{.status = status, .body = sentence + "\n"};
        keep_ = keep;
        respond(std::move(answer), "no-store");
    }

    // Sends a file in pieces, however large it is.
    void respondFile(const HttpAnswer& answer, const std::string& cache) {
        const Request& request = parser_->get();
        http::file_body::value_type body;
        Error error;
        body.open(answer.path.c_str(), beast::file_mode::scan, error);
        if (error) return refuse(404, "The file is gone.", true);
        fileResponse_.emplace(std::piecewise_construct, std::make_tuple(std::move(body)),
                              std::make_tuple(static_cast<http::status>(answer.status), 11));
        setFields(*fileResponse_, answer, cache);
        fileResponse_->keep_alive(request.keep_alive());
        fileResponse_->prepare_payload();
        stream_.expires_after(std::chrono::seconds(kFileSeconds));
        const auto sent = [self = shared_from_this()](Error failed, std::size_t) {
            const bool keep = !failed && self->fileResponse_->keep_alive();
            self->fileResponse_.reset();
            if (!keep) return self->close();
            self->start();
        };
        if (request.method() != http::verb::head) return http::async_write(stream_, *fileResponse_, sent);
        fileHead_.emplace(*fileResponse_);
        http::async_write_header(stream_, *fileHead_, sent);
    }

    template <class AnyResponse>
    void setFields(AnyResponse& response, const HttpAnswer& answer, const std::string& cache) const {
        response.set(http::field::content_type, answer.type);
        response.set(http::field::cache_control, cache);
        if (!answer.fileName.empty())
            response.set(http::field::content_disposition,
                         "attachment; filename=\"" + answer.fileName + "\"");
        for (const auto& [field, value] : securityFields(door_)) response.set(field, value);
    }

    void respond(HttpAnswer answer, const std::string& cache) {
        if (!answer.path.empty()) return respondFile(answer, cache);
        const Request& request = parser_->get();
        response_ = Response(static_cast<http::status>(answer.status), 11);
        setFields(response_, answer, cache);
        if (!answer.location.empty()) {
            response_.set(http::field::location, answer.location);
            response_.set(http::field::set_cookie, tokenCookie(door_));
        }
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

    // Ends the sending direction, then reads and drops what still arrives. An immediate close would reset the
    // connection, and the client might lose the answer.
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
    Doorway door_;
    beast::flat_buffer buffer_;
    std::unique_ptr<http::request_parser<http::vector_body<std::uint8_t>>> parser_;
    Response response_;
    std::optional<http::response<http::file_body>> fileResponse_;
    std::optional<http::response_serializer<http::file_body>> fileHead_;
    bool keep_ = true;
    std::array<char, 4096> swallowed_{};
    std::size_t swallowedBytes_ = 0;
};

}  // namespace muster
