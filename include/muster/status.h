// Outcomes of calls that bad data can make fail.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "muster/assert.h"

namespace muster {

/// What kind of thing went wrong.
enum class StatusCode {
    Ok,
    InvalidArgument,  ///< A value is outside its range or contradicts another.
    NotFound,         ///< No object has this name or id.
    ParseError,       ///< Text or bytes that do not follow the format.
    IoError,          ///< A file or socket that cannot be read or written.
    Corrupt,          ///< A checksum or hash that does not match.
    Unsupported,      ///< Valid, but of a version or kind not known here.
    LimitExceeded,    ///< Too large, too many, too often.
};

/// Success, or a code with one sentence that names the faulty value or file.
class [[nodiscard]] Status {
public:
    /// Success.
    Status() = default;
    /// Failure; `message` is one sentence without a trailing newline.
    Status(StatusCode code, std::string message) : code_(code), message_(std::move(message)) {}

    /// True on success.
    bool ok() const { return code_ == StatusCode::Ok; }
    /// The kind of failure.
    StatusCode code() const { return code_; }
    /// The sentence; empty on success.
    const std::string& message() const { return message_; }
    /// The same failure with `context` and a colon put before its sentence.
    Status within(const std::string& context) const {
        return ok() ? *this : Status(code_, context + ": " + message_);
    }

private:
    StatusCode code_ = StatusCode::Ok;
    std::string message_;
};

/// Shorthand for the commonest failure.
inline Status invalidArgument(std::string message) {
    return {StatusCode::InvalidArgument, std::move(message)};
}

/// A value, or the Status that says why there is none.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : value_(std::move(value)) {}  // NOLINT: implicit on purpose
    Result(Status status) : status_(std::move(status)) { MUSTER_ASSERT(!status_.ok()); }

    /// True where there is a value.
    bool ok() const { return value_.has_value(); }
    /// Why there is none; Ok where there is one.
    const Status& status() const { return status_; }
    /// The value. Only where ok().
    T& value() & {
        MUSTER_ASSERT(ok());
        return *value_;
    }
    const T& value() const& {  ///< The value. Only where ok().
        MUSTER_ASSERT(ok());
        return *value_;
    }
    T&& value() && {  ///< The value. Only where ok().
        MUSTER_ASSERT(ok());
        return std::move(*value_);
    }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    T& operator*() & { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    const T& operator*() const& { return value(); }

private:
    std::optional<T> value_;
    Status status_;
};

}  // namespace muster
