#include "server_policy.h"

#include <string_view>

namespace muster {
namespace {

constexpr std::string_view kLink = "/?token=";

std::string withPort(const std::string& host, int port) {
    return host + ":" + std::to_string(port);
}

// Browsers send cookies of all ports of a host: the name keeps two studios apart.
std::string cookieName(const Doorway& door) {
    return "muster-" + std::to_string(door.port);
}

// It takes the same time wherever two texts of one length differ.
bool isToken(std::string_view shown, const Doorway& door) {
    if (door.token.empty() || shown.size() != door.token.size()) return false;
    unsigned different = 0;
    for (std::size_t i = 0; i < shown.size(); ++i)
        different |= static_cast<unsigned char>(shown[i]) ^ static_cast<unsigned char>(door.token[i]);
    return different == 0;
}

}  // namespace

bool isOwnHost(const std::string& host, const Doorway& door) {
    return host == withPort(door.address, door.port) ||
           (door.atDesk() && host == withPort("localhost", door.port));
}

bool isOwnOrigin(const std::string& origin, const Doorway& door) {
    const std::string scheme = "http://";
    return origin.starts_with(scheme) && isOwnHost(origin.substr(scheme.size()), door);
}

bool cookieHasToken(const std::string& cookies, const Doorway& door) {
    const std::string name = cookieName(door) + "=";
    std::string_view rest = cookies;
    while (!rest.empty()) {
        const std::size_t end = rest.find(';');
        std::string_view one = rest.substr(0, end);
        while (!one.empty() && one.front() == ' ') one.remove_prefix(1);
        if (one.starts_with(name) && isToken(one.substr(name.size()), door)) return true;
        rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    return false;
}

bool linkHasToken(const std::string& target, const Doorway& door) {
    return target.starts_with(kLink) && isToken(std::string_view(target).substr(kLink.size()), door);
}

std::string tokenCookie(const Doorway& door) {
    return cookieName(door) + "=" + door.token + "; Path=/; HttpOnly; SameSite=Lax";
}

std::vector<std::pair<const char*, std::string>> securityFields(const Doorway& door) {
    std::string sockets = "ws://" + withPort(door.address, door.port);
    if (door.atDesk()) sockets += " ws://" + withPort("localhost", door.port);
    return {{"Content-Security-Policy",
             "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; style-src "
             "'self' 'unsafe-inline'; "
             "img-src 'self' data: blob:; media-src 'self' blob:; font-src 'self' data:; connect-src 'self' "
             "data: "
             "blob: " +
                 sockets + "; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"},
            {"X-Content-Type-Options", "nosniff"},
            {"X-Frame-Options", "DENY"},
            {"Referrer-Policy", "no-referrer"},
            {"Cross-Origin-Opener-Policy", "same-origin"},
            {"Cross-Origin-Resource-Policy", "same-origin"}};
}

}  // namespace muster
