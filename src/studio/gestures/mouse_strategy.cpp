#include "studio/gestures/mouse_strategy.h"

#include <algorithm>
#include <iterator>

#include "studio/gestures/group_lookup.h"
#include "studio/gestures/reaches.h"

namespace muster {
namespace {

// Forgets those who are no longer in the world.
void keepLiving(const World& world, std::vector<std::uint32_t>& ids) {
    const std::span<const std::uint32_t> living = world.characters().id;
    std::erase_if(ids,
                  [&](std::uint32_t id) { return !std::binary_search(living.begin(), living.end(), id); });
}

}  // namespace

void MouseStrategy::input(const InputEvent& event, const World& world, std::vector<CommandBody>& commands) {
    if (const auto* view = std::get_if<GroundView>(&event)) view_ = *view;
    if (const auto* pointer = std::get_if<PointerEvent>(&event)) this->pointer(*pointer, world, commands);
    if (const auto* key = std::get_if<KeyEvent>(&event); key != nullptr && !paper())
        this->key(*key, world, commands);
}

void MouseStrategy::pointer(const PointerEvent& event, const World& world,
                            std::vector<CommandBody>& commands) {
    if (event.phase == PointerPhase::Down) {
        if (down_) return;
        down_ = true;
        drags_ = false;
        from_ = event;
        marks_.notice.clear();
        return;
    }
    if (!down_ || event.pointer != from_.pointer) return;
    const double mm = distance(event.screen, from_.screen) * view_.mmPerPixel;
    drags_ = drags_ || mm > travelOf(event.device);
    if (event.phase == PointerPhase::Move) {
        if (drags_ && from_.button == boxButton())
            marks_.rectangle = cornersOf(view_, from_.screen, event.screen);
        return;
    }
    down_ = false;
    marks_.rectangle.clear();
    if (event.phase == PointerPhase::Up) released(event, world, commands);
}

void MouseStrategy::released(const PointerEvent& event, const World& world,
                             std::vector<CommandBody>& commands) {
    if (drags_ && from_.button == boxButton())
        choose(charactersIn(world, view_, from_.screen, event.screen), event.modifiers);
    else if (!drags_ || from_.button != boxButton())
        clicked(event, world, commands);
}

void MouseStrategy::clicked(const PointerEvent& event, const World& world,
                            std::vector<CommandBody>& commands) {
    if (paper()) {
        if (from_.button == PointerButton::Left) send(event, world, false, commands);
    } else if (from_.button == PointerButton::Right) {
        send(event, world, event.modifiers.shift, commands);
    } else if (from_.button == PointerButton::Left) {
        pick(event, world);
    }
}

// A click takes a character, a second one its whole group; one on free ground takes nobody.
void MouseStrategy::pick(const PointerEvent& event, const World& world) {
    const std::int32_t found = characterAt(world, view_, event.screen, reachOf(event.device));
    const bool again = event.time - lastClick_ < kDoubleTime &&
                       distance(event.screen, lastClickAt_) * view_.mmPerPixel < kMouseTip;
    lastClick_ = event.time;
    lastClickAt_ = event.screen;
    if (found < 0) {
        if (!event.modifiers.shift && !event.modifiers.control) marks_.selected.clear();
        return;
    }
    const CharactersView characters = world.characters();
    if (again)
        choose(membersOf(world, static_cast<std::int32_t>(characters.group[found])), event.modifiers);
    else
        choose({characters.id[found]}, event.modifiers);
}

// Shift adds, Ctrl takes away; the paper's mouse has neither.
void MouseStrategy::choose(std::vector<std::uint32_t> ids, const Modifiers& modifiers) {
    std::vector<std::uint32_t>& selected = marks_.selected;
    std::vector<std::uint32_t> result;
    if (!paper() && modifiers.control)
        std::set_difference(selected.begin(), selected.end(), ids.begin(), ids.end(),
                            std::back_inserter(result));
    else if (!paper() && modifiers.shift)
        std::set_union(selected.begin(), selected.end(), ids.begin(), ids.end(), std::back_inserter(result));
    else
        result = std::move(ids);
    selected = std::move(result);
    if (selected.empty()) marks_.notice = "Nobody is in the box";
    marks_.goals.clear();
}

void MouseStrategy::send(const PointerEvent& event, const World& world, bool add,
                         std::vector<CommandBody>& commands) {
    const auto ground = view_.groundAt(event.screen);
    if (!ground) return;
    keepLiving(world, marks_.selected);
    if (marks_.selected.empty()) {
        marks_.notice = "Nobody is selected: drag a box round those whom you want to send";
        return;
    }
    if (!add) marks_.goals.clear();
    marks_.goals.push_back(*ground);
    sender_.send(world, marks_.selected, *ground, add, commands);
}

void MouseStrategy::key(const KeyEvent& event, const World& world, std::vector<CommandBody>& commands) {
    keepLiving(world, marks_.selected);
    if (event.key >= '0' && event.key <= '9') {
        std::vector<std::uint32_t>& kept = kept_[event.key - '0'];
        if (event.modifiers.control) {
            kept = marks_.selected;
        } else if (!kept.empty()) {
            keepLiving(world, kept);
            choose(kept, event.modifiers.shift ? event.modifiers : Modifiers{});
        }
    }
    if (event.key == 'A' && event.modifiers.control)
        choose({world.characters().id.begin(), world.characters().id.end()}, {});
    if (event.key == 'S' && !event.modifiers.control) sender_.stop(world, marks_.selected, commands);
    if (event.key == kEscapeKey) {
        marks_.selected.clear();
        marks_.goals.clear();
    }
}

void MouseStrategy::beforeStep(const World& world, std::vector<CommandBody>& commands) {
    sender_.beforeStep(world, commands);
}

}  // namespace muster
