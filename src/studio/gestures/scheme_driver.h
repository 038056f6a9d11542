// Feeds a control scheme with inputs and gives a world its commands, step by step.
#pragma once

#include <memory>
#include <vector>

#include "studio/gestures/control_scheme.h"

namespace muster {

/// Number of the client that commands of a control scheme come from, so that the same inputs give the same
/// hashes wherever they are fed in.
inline constexpr std::uint32_t kSchemeClient = 1;

/// Owns a control scheme, whose commands come from the client of a number. Not thread-safe.
class SchemeDriver {
public:
    explicit SchemeDriver(const SchemeDef& def, std::uint32_t client = kSchemeClient);

    /// Takes an input that belongs to the next step. The view comes first. What is malformed is refused with
    /// InvalidArgument and changes nothing.
    Status input(const InputEvent& event, const World& world);
    /// Call before every step: replaces `commands` by those for that step, numbered and stamped.
    void take(const World& world, std::vector<Command>& commands);

    const ControlScheme& scheme() const { return *scheme_; }  ///< To show its marks.

private:
    std::uint32_t client_;
    std::unique_ptr<ControlScheme> scheme_;
    std::vector<CommandBody> waiting_;
    std::uint32_t sequence_ = 0;
};

}  // namespace muster
