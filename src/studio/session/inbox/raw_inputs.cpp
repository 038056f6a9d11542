#include "studio/session/inbox/chosen_scheme.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muster {

InputEvent inputOf(const protocol::RawInput& raw, double time) {
    const Modifiers modifiers{raw.shift, raw.control, raw.alt};
    if (raw.kind == protocol::InputKind::Key) return KeyEvent{raw.key, time, modifiers};
    PointerEvent event;
    event.phase = static_cast<PointerPhase>(raw.phase);
    event.device = static_cast<PointerDevice>(raw.device);
    event.button = static_cast<PointerButton>(raw.button);
    event.pointer = raw.pointer;
    event.screen = {raw.x, raw.y};
    event.time = time;
    event.modifiers = modifiers;
    return event;
}

Result<GroundView> groundViewOf(const protocol::SetView& message) {
    GroundView view;
    if (message.matrix.size() != view.toScreen.size()) {
        return invalidArgument("found a view of " + std::to_string(message.matrix.size()) +
                               " numbers, expected 9");
    }
    std::copy(message.matrix.begin(), message.matrix.end(), view.toScreen.begin());
    view.width = message.width;
    view.height = message.height;
    view.mmPerPixel = message.mmPerPixel;
    if (!view.valid()) return invalidArgument("found a view that cannot be inverted");
    return view;
}

Status checkInputs(const protocol::Inputs& message, const SessionLimits& limits) {
    if (message.events.size() > limits.touchesPerMessage) {
        return {StatusCode::LimitExceeded, "found " + std::to_string(message.events.size()) +
                                               " inputs, expected at most " +
                                               std::to_string(limits.touchesPerMessage)};
    }
    for (const protocol::RawInput& raw : message.events) {
        if (!std::isfinite(raw.time) || !std::isfinite(raw.x) || !std::isfinite(raw.y))
            return invalidArgument("found an input with a number that is not finite");
    }
    return {};
}

std::vector<float> pairsOf(const std::vector<Vec2>& points) {
    std::vector<float> pairs;
    for (const Vec2 point : points) {
        pairs.push_back(static_cast<float>(point.x));
        pairs.push_back(static_cast<float>(point.y));
    }
    return pairs;
}

protocol::Marks marksOf(std::string name, const SchemeMarks& marks) {
    protocol::Marks message;
    message.scheme = std::move(name);
    message.selected = marks.selected;
    message.rectangle = pairsOf(marks.rectangle);
    message.stroke = pairsOf(marks.stroke);
    message.goals = pairsOf(marks.goals);
    message.notice = marks.notice;
    return message;
}

protocol::SchemeInfo infoOf(const NamedScheme& scheme) {
    return {std::string(scheme.name), std::string(scheme.title), std::string(scheme.description),
            holdsMesh(scheme.def.kind)};
}

}  // namespace muster
