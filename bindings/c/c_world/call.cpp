#include "bindings/c/c_world/call.h"

#include <array>
#include <cstring>

namespace muster::c_api {
namespace {

constexpr const char* kStatusNames[] = {
    "ok",      "invalid argument", "not found",      "parse error",   "input or output error",
    "corrupt", "unsupported",      "limit exceeded", "out of memory", "internal error"};
static_assert(std::size(kStatusNames) == MUSTER_INTERNAL + 1);
static_assert(static_cast<int>(StatusCode::Ok) == MUSTER_OK &&
              static_cast<int>(StatusCode::InvalidArgument) == MUSTER_INVALID_ARGUMENT &&
              static_cast<int>(StatusCode::NotFound) == MUSTER_NOT_FOUND &&
              static_cast<int>(StatusCode::ParseError) == MUSTER_PARSE_ERROR &&
              static_cast<int>(StatusCode::IoError) == MUSTER_IO_ERROR &&
              static_cast<int>(StatusCode::Corrupt) == MUSTER_CORRUPT &&
              static_cast<int>(StatusCode::Unsupported) == MUSTER_UNSUPPORTED &&
              static_cast<int>(StatusCode::LimitExceeded) == MUSTER_LIMIT_EXCEEDED);

thread_local std::string lastSentence;

struct Log {
    MusterLogFunction function = nullptr;
    void* context = nullptr;
};
constinit Log hostLog;

}  // namespace

MusterStatus fail(MusterStatus code, const char* sentence) noexcept {
    try {
        lastSentence = sentence;
    } catch (...) {
        lastSentence.clear();
    }
    log(MUSTER_LOG_FAILURE, sentence);
    return code;
}

MusterStatus finish(const Status& status) noexcept {
    return status.ok() ? MUSTER_OK : fail(static_cast<MusterStatus>(status.code()), status.message().c_str());
}

void log(MusterLogLevel level, const char* message) noexcept {
    if (hostLog.function != nullptr) hostLog.function(hostLog.context, level, message);
}

}  // namespace muster::c_api

using namespace muster;

const char* muster_last_error(void) {
    return c_api::lastSentence.c_str();
}

const char* muster_status_name(MusterStatus status) {
    return status >= MUSTER_OK && status <= MUSTER_INTERNAL ? c_api::kStatusNames[status] : "unknown";
}

void muster_set_log(MusterLogFunction function, void* context) {
    c_api::hostLog = {function, context};
}
