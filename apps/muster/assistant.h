// A language model directs: the Model Context Protocol, revisions 2024-11-05 to 2025-11-25, over lines of
// text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "json/json.h"
#include "studio_link.h"

namespace muster {

/// Answers JSON-RPC 2.0 messages, one a line.
class Assistant {
public:
    explicit Assistant(StudioLink& link) : link_(link) {}

    /// The answer to a line; none for notifications.
    std::optional<std::string> answer(std::string_view line);

private:
    /// What a tool says.
    struct Outcome {
        std::string text;
        bool failed = false;
    };

    Json result(const std::string& method, const Json* params, std::string& problem, int& code);
    Json initialize(const Json* params) const;
    Json call(const Json* params, std::string& problem, int& code);
    Outcome look();
    Outcome say(const Json& arguments);
    Outcome give(const Json& arguments);
    Outcome act(std::vector<std::uint8_t> bytes, const std::string& done);
    Outcome spoken(protocol::SayAct act, const std::string& text);
    /// What the studio has against what was done, a line each.
    std::string troubles();

    StudioLink& link_;
    std::uint32_t number_ = 0;
};

}  // namespace muster
