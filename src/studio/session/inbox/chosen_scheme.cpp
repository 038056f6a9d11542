#include "studio/session/inbox/chosen_scheme.h"

#include <utility>

namespace muster {

Status ChosenScheme::choose(const std::string& name, std::uint32_t client) {
    if (!name.empty()) {
        const auto found = namedScheme(name);
        if (!found.ok()) return found.status();
        def_ = found.value().def;
    }
    name_ = name;
    restart(client);
    return {};
}

void ChosenScheme::restart(std::uint32_t client) {
    driver_.reset();
    viewKnown_ = false;
    if (!name_.empty()) driver_.emplace(def_, client);
}

void ChosenScheme::setView(const GroundView& view, const World* world) {
    view_ = view;
    viewKnown_ = driver_ && world != nullptr && driver_->input(view, *world).ok();
}

Status ChosenScheme::input(const InputEvent& event, const World& world) {
    if (!driver_) return invalidArgument("found inputs, expected the choice of a control scheme before them");
    if (!view_) return invalidArgument("found inputs, expected a view of the ground before them");
    if (!viewKnown_) viewKnown_ = driver_->input(*view_, world).ok();
    return driver_->input(event, world);
}

std::vector<CommandBody> ChosenScheme::take(const World& world) {
    std::vector<CommandBody> bodies;
    if (!driver_) return bodies;
    driver_->take(world, taken_);
    for (Command& command : taken_) bodies.push_back(std::move(command.body));
    return bodies;
}

void ChosenScheme::send(std::vector<MessageBytes>& messages) {
    if (!driver_ && sent_.empty()) return;
    MessageBytes marks = protocol::encode(driver_ ? marksOf(name_, driver_->scheme().marks())
                                                  : protocol::Marks());
    if (marks == sent_) return;
    messages.push_back(marks);
    sent_ = std::move(marks);
}

}  // namespace muster
