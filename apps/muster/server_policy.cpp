#include "server_policy.h"

namespace muster {

bool isLocalHost(const std::string& host, int port) {
    const std::string number = ":" + std::to_string(port);
    return host == "127.0.0.1" + number || host == "localhost" + number;
}

bool isLocalOrigin(const std::string& origin, int port) {
    const std::string scheme = "http://";
    return origin.rfind(scheme, 0) == 0 && isLocalHost(origin.substr(scheme.size()), port);
}

std::vector<std::pair<const char*, std::string>> securityFields(int port) {
    const std::string number = std::to_string(port);
    return {
        {"Content-Security-Policy",
         "default-src 'self'; script-src 'self'; worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; "
         "img-src 'self' data: blob:; media-src 'self' blob:; font-src 'self' data:; connect-src 'self' "
         "data: blob: ws://127.0.0.1:" +
             number + " ws://localhost:" + number +
             "; frame-ancestors 'none'; base-uri 'none'; form-action 'none'"},
        {"X-Content-Type-Options", "nosniff"},
        {"X-Frame-Options", "DENY"},
        {"Referrer-Policy", "no-referrer"},
        {"Cross-Origin-Opener-Policy", "same-origin"},
        {"Cross-Origin-Resource-Policy", "same-origin"}};
}

}  // namespace muster
