// Answers to HTTP requests: a sentence, JSON, a file.
#pragma once

#include <string>

#include "http_answer.h"
#include "json/json.h"
#include "muster/status.h"

namespace muster {

/// A plain sentence.
inline HttpAnswer sentence(int status, const std::string& words) {
    return {.status = status, .body = words + "\n"};
}

/// The sentence of a failure.
inline HttpAnswer failure(const Status& status) {
    int code = 400;
    if (status.code() == StatusCode::NotFound) code = 404;
    if (status.code() == StatusCode::LimitExceeded) code = 413;
    return sentence(code, status.message());
}

/// A JSON value.
inline HttpAnswer jsonAnswer(const Json& value) {
    return {.type = "application/json", .body = compactJson(value) + "\n"};
}

/// An empty object, or the sentence of a failure.
inline HttpAnswer doneAnswer(const Status& status) {
    return status.ok() ? jsonAnswer(Json::object()) : failure(status);
}

/// A file; to be saved under a name where there is one.
inline HttpAnswer fileAnswer(const Result<std::string>& path, const char* type,
                             const std::string& saveAs = {}) {
    if (!path.ok()) return failure(path.status());
    return {.type = type, .path = *path, .fileName = saveAs};
}

}  // namespace muster
