#include "studio/gestures/scheme_driver.h"

#include <cmath>

namespace muster {
namespace {

Status check(const InputEvent& event) {
    if (const auto* pointer = std::get_if<PointerEvent>(&event)) {
        if (pointer->phase > PointerPhase::Cancel || pointer->device > PointerDevice::Mouse ||
            pointer->button > PointerButton::Right)
            return invalidArgument("found a pointer event of an unknown kind");
        if (!std::isfinite(pointer->screen.x) || !std::isfinite(pointer->screen.y) ||
            !std::isfinite(pointer->time))
            return invalidArgument("found a pointer event with a number that is not finite");
    }
    if (const auto* key = std::get_if<KeyEvent>(&event); key != nullptr && !std::isfinite(key->time))
        return invalidArgument("found a key with a time that is not finite");
    if (const auto* view = std::get_if<GroundView>(&event); view != nullptr && !view->valid())
        return invalidArgument("found a view that cannot be inverted");
    return {};
}

}  // namespace

SchemeDriver::SchemeDriver(const SchemeDef& def, std::uint32_t client)
    : client_(client), scheme_(makeControlScheme(def, client)) {}

Status SchemeDriver::input(const InputEvent& event, const World& world) {
    if (Status status = check(event); !status.ok()) return status;
    scheme_->input(event, world, waiting_);
    return {};
}

void SchemeDriver::take(const World& world, std::vector<Command>& commands) {
    scheme_->beforeStep(world, waiting_);
    commands.clear();
    for (CommandBody& body : waiting_)
        commands.push_back({world.stepCount(), client_, ++sequence_, std::move(body)});
    waiting_.clear();
}

}  // namespace muster
