// What a host answers to requests about its take and its place. A host is a Session, or anything with some of
// its functions: what it lacks is answered by a sentence.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "http_answers.h"
#include "request_target.h"

namespace muster {

/// Everything since the world began, or the take that is open.
template <class Host>
HttpAnswer takeAnswer(const Host& host) {
    if constexpr (requires { host.take(); }) {
        auto bytes = host.take();
        if (!bytes.ok()) return failure(bytes.status());
        HttpAnswer answer{.type = "application/octet-stream"};
        answer.body.assign(bytes.value().begin(), bytes.value().end());
        answer.fileName = host.takeName();
        return answer;
    } else {
        return sentence(404, "There are no takes here.");
    }
}

/// Opens a take. `name`: on the shelf; empty where it is on none.
template <class Host>
HttpAnswer openTakeAnswer(Host& host, std::span<const std::uint8_t> bytes, const std::string& name,
                          std::uint32_t director = 0) {
    if constexpr (requires { host.takeName(); }) {
        const Status status = host.openTake(bytes, name.empty() ? "take" : name, name, director);
        return status.ok() ? sentence(200, "The take is open.") : failure(status);
    } else {
        return sentence(404, "There are no takes here.");
    }
}

/// What a keeper needs to go on with the world elsewhere; "?world=" and "&take=" say what it has already.
template <class Host>
HttpAnswer handoverAnswer(const Host& host, std::string_view target) {
    if constexpr (requires { host.handover(); }) {
        auto bytes = host.handover(static_cast<std::uint32_t>(queryCount(target, "world")),
                                   queryCount(target, "take"));
        if (!bytes.ok()) return failure(bytes.status());
        HttpAnswer answer{.type = "application/octet-stream"};
        answer.body.assign(bytes.value().begin(), bytes.value().end());
        return answer;
    } else {
        return sentence(404, "There is no world to hand over here.");
    }
}

/// The place as a scenario file.
template <class Host>
HttpAnswer placeAnswer(const Host& host) {
    if constexpr (requires { host.scenario(); }) {
        auto text = host.scenario();
        if (!text.ok()) return failure(text.status());
        return HttpAnswer{
            .type = "application/json", .body = std::move(text).value(), .fileName = host.scenarioName()};
    } else {
        return sentence(404, "There is no place to edit here.");
    }
}

/// Opens the text of a scenario file.
template <class Host>
HttpAnswer openPlaceAnswer(Host& host, std::span<const std::uint8_t> bytes, const std::string& name,
                           std::uint32_t director = 0) {
    if constexpr (requires { host.scenario(); }) {
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        const Status status = host.openScenario(name, text, director);
        return status.ok() ? sentence(200, "The place is open.") : failure(status);
    } else {
        return sentence(404, "There is no place to edit here.");
    }
}

}  // namespace muster
