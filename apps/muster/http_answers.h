// Answers to HTTP requests in one sentence.
#pragma once

#include <string>

#include "muster/status.h"
#include "studio_server.h"

namespace muster {

/// A plain sentence.
inline HttpAnswer sentence(int status, const std::string& words) {
    HttpAnswer answer;
    answer.status = status;
    answer.body = words + "\n";
    return answer;
}

/// The sentence of a failure.
inline HttpAnswer failure(const Status& status) {
    int code = 400;
    if (status.code() == StatusCode::NotFound) code = 404;
    if (status.code() == StatusCode::LimitExceeded) code = 413;
    return sentence(code, status.message());
}

}  // namespace muster
