// Access rules of the studio's server and of its pages (docs/security.md).
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace muster {

/// Where a request arrived, and what it must bring.
struct Doorway {
    std::string address = "127.0.0.1";  ///< Address of this machine that was connected to.
    int port = 0;                       ///< The server's port.
    std::string token;                  ///< What guests must show; empty where there are none.

    /// True where it arrived on this machine itself, by 127.0.0.1.
    bool atDesk() const { return address == "127.0.0.1"; }
};

/// True where an HTTP Host field names the address that was connected to, with the port; 127.0.0.1 may be
/// called localhost, too.
bool isOwnHost(const std::string& host, const Doorway& door);
/// The same for an Origin field.
bool isOwnOrigin(const std::string& origin, const Doorway& door);
/// True where a Cookie field holds the token.
bool cookieHasToken(const std::string& cookies, const Doorway& door);
/// True where a request target is the link of an invitation, "/?token=...", with the right token.
bool linkHasToken(const std::string& target, const Doorway& door);
/// The Set-Cookie field by which a browser that came by the link keeps the token until it is closed.
std::string tokenCookie(const Doorway& door);
/// Names and values of the HTTP fields in every response that keep other sites out.
std::vector<std::pair<const char*, std::string>> securityFields(const Doorway& door);

}  // namespace muster
