// Who may talk to the studio's server, and what its pages may do (docs/security.md).
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace muster {

/// True for 127.0.0.1 and localhost with the server's port, as an HTTP Host field names them.
bool isLocalHost(const std::string& host, int port);
/// The same as an Origin field.
bool isLocalOrigin(const std::string& origin, int port);
/// HTTP fields of every response that keep other sites out, by name.
std::vector<std::pair<const char*, std::string>> securityFields(int port);

}  // namespace muster
