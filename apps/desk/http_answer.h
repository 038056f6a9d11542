// The answer to an HTTP request, or to one like it where the page has its engine beside it.
#pragma once

#include <string>

namespace muster {

/// An answer to a request that the simulation serves.
struct HttpAnswer {
    int status = 200;
    std::string type = "text/plain; charset=utf-8";
    std::string body;
    std::string path;      ///< Of a file that is sent instead of the body; empty for none.
    std::string fileName;  ///< File name for saving; empty where the browser shows the answer.
    std::string location;  ///< Where a guest who has shown the token goes on; empty for none.
};

}  // namespace muster
