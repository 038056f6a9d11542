// Access rules of the studio's server and of its pages (docs/security.md).
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace muster {

/// True where an HTTP Host field names 127.0.0.1 or localhost with the server's port.
bool isLocalHost(const std::string& host, int port);
/// The same for an Origin field.
bool isLocalOrigin(const std::string& origin, int port);
/// Names and values of the HTTP fields in every response that keep other sites out.
std::vector<std::pair<const char*, std::string>> securityFields(int port);

}  // namespace muster
