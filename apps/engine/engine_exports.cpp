// The functions of the WebAssembly module that the page's worker calls (web/src/link/engine). Bytes are
// passed in memory of malloc(); what is returned is valid until the next call.
#include <emscripten.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "last_text.h"
#include "page_engine.h"

namespace {

using namespace muster;

std::unique_ptr<PageEngine> theEngine;
HttpAnswer theAnswer;
std::vector<MessageBytes> theMessages;

std::span<const std::uint8_t> bytesAt(const std::uint8_t* data, std::uint32_t size) {
    return {data, size};
}

int fail(const Status& status) {
    lastText() = status.message();
    return 1;
}

}  // namespace

namespace muster {

std::string& lastText() {
    static std::string text;
    return text;
}

}  // namespace muster

extern "C" {

/// Opens the studio with a scenario by name; "" for the default. Returns 0, or 1 with a sentence in
/// muster_text(). `threads` are those of the world; a module without threads has one.
EMSCRIPTEN_KEEPALIVE int muster_open(const char* scenario, const char* version, int threads) {
    PageEngineDef def{.scenario = scenario, .version = version, .threads = threads};
    auto engine = PageEngine::open(def);
    if (!engine.ok()) return fail(engine.status());
    theEngine = std::move(engine).value();
    return 0;
}

/// The sentence of the last failure, or what the last function says that it gives there.
EMSCRIPTEN_KEEPALIVE const char* muster_text() {
    return lastText().c_str();
}

EMSCRIPTEN_KEEPALIVE std::uint32_t muster_connect() {
    return theEngine->session().connect();
}

EMSCRIPTEN_KEEPALIVE void muster_disconnect(std::uint32_t client) {
    theEngine->session().disconnect(client);
}

EMSCRIPTEN_KEEPALIVE void muster_receive(std::uint32_t client, const std::uint8_t* data, std::uint32_t size) {
    theEngine->session().receive(client, bytesAt(data, size));
}

/// Lets time pass [s]; returns when it wants to be called again [s].
EMSCRIPTEN_KEEPALIVE double muster_advance(double seconds) {
    return theEngine->advance(seconds);
}

/// Takes the messages for a client; returns their number.
EMSCRIPTEN_KEEPALIVE std::uint32_t muster_collect(std::uint32_t client) {
    theEngine->session().outgoing(client, theMessages);
    return static_cast<std::uint32_t>(theMessages.size());
}

EMSCRIPTEN_KEEPALIVE const std::uint8_t* muster_message(std::uint32_t index) {
    return theMessages[index].data();
}

EMSCRIPTEN_KEEPALIVE std::uint32_t muster_message_size(std::uint32_t index) {
    return static_cast<std::uint32_t>(theMessages[index].size());
}

/// Answers a request; returns the status.
EMSCRIPTEN_KEEPALIVE int muster_ask(const char* method, const char* target, const std::uint8_t* body,
                                    std::uint32_t size) {
    theAnswer = theEngine->ask(method, target, bytesAt(body, size));
    return theAnswer.status;
}

EMSCRIPTEN_KEEPALIVE const char* muster_answer() {
    return theAnswer.body.data();
}

EMSCRIPTEN_KEEPALIVE std::uint32_t muster_answer_size() {
    return static_cast<std::uint32_t>(theAnswer.body.size());
}

EMSCRIPTEN_KEEPALIVE const char* muster_answer_type() {
    return theAnswer.type.c_str();
}

}  // extern "C"
