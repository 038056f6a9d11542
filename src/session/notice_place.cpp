#include "session/notice_place.h"

#include <algorithm>
#include <variant>

namespace muster {
namespace {

std::optional<Vec2> finite(Vec2 place) { return isFinite(place) ? std::optional<Vec2>(place) : std::nullopt; }

std::optional<Vec2> middle(const std::vector<double>& xs, const std::vector<double>& ys) {
    const std::size_t count = std::min(xs.size(), ys.size());
    if (count == 0) return std::nullopt;
    Vec2 sum{0.0, 0.0};
    for (std::size_t i = 0; i < count; ++i) sum += Vec2{xs[i], ys[i]};
    return finite(sum / static_cast<double>(count));
}

}  // namespace

std::optional<Vec2> placeOf(const CommandBody& command) {
    if (const auto* touch = std::get_if<TouchDown>(&command)) return finite(touch->position);
    const auto* add = std::get_if<AddControl>(&command);
    if (add == nullptr || add->positions.empty()) return std::nullopt;
    Vec2 sum{0.0, 0.0};
    for (const Vec2 position : add->positions) sum += position;
    return finite(sum / static_cast<double>(add->positions.size()));
}

std::optional<Vec2> placeOf(const protocol::ClientMessage& message) {
    if (const auto* add = std::get_if<protocol::AddControl>(&message)) return middle(add->xs, add->ys);
    const auto* touches = std::get_if<protocol::Touches>(&message);
    if (touches == nullptr) return std::nullopt;
    for (const protocol::TouchEvent& event : touches->events)
        if (event.phase == protocol::TouchPhase::Down) return finite({event.x, event.y});
    return std::nullopt;
}

}  // namespace muster
