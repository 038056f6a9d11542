#include "studio/session/frames/notice_position.h"

#include <algorithm>
#include <variant>

namespace muster {
namespace {

std::optional<Vec2> finite(Vec2 position) {
    return isFinite(position) ? std::optional<Vec2>(position) : std::nullopt;
}

// Returns the mean of pointAt(0) to pointAt(count - 1).
template <class PointAt>
std::optional<Vec2> middle(std::size_t count, PointAt pointAt) {
    if (count == 0) return std::nullopt;
    Vec2 sum{0.0, 0.0};
    for (std::size_t i = 0; i < count; ++i) sum += pointAt(i);
    return finite(sum / static_cast<double>(count));
}

}  // namespace

std::optional<Vec2> positionOf(const CommandBody& command) {
    if (const auto* touch = std::get_if<TouchDown>(&command)) return finite(touch->position);
    const auto* add = std::get_if<AddControl>(&command);
    if (add == nullptr) return std::nullopt;
    return middle(add->positions.size(), [&](std::size_t i) { return add->positions[i]; });
}

std::optional<Vec2> positionOf(const protocol::ClientMessage& message) {
    if (const auto* add = std::get_if<protocol::AddControl>(&message)) {
        return middle(std::min(add->xs.size(), add->ys.size()), [&](std::size_t i) {
            return Vec2{add->xs[i], add->ys[i]};
        });
    }
    const auto* touches = std::get_if<protocol::Touches>(&message);
    if (touches == nullptr) return std::nullopt;
    for (const protocol::TouchEvent& event : touches->events)
        if (event.phase == protocol::TouchPhase::Down) return finite({event.x, event.y});
    return std::nullopt;
}

}  // namespace muster
