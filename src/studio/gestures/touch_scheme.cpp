#include "studio/gestures/touch_scheme.h"

#include <algorithm>

#include "studio/gestures/ground_strokes.h"
#include "studio/gestures/group_lookup.h"
#include "studio/gestures/reaches.h"

namespace muster {
namespace {

constexpr double kLeastReach = 0.3;  // A fingertip reaches at least so far on the ground [m]...
constexpr double kMostReach = 1.5;   // ...and at most so far.

}  // namespace

void TouchScheme::input(const InputEvent& event, const World& world, std::vector<CommandBody>& commands) {
    if (const auto* view = std::get_if<GroundView>(&event)) view_ = *view;
    const auto* pointer = std::get_if<PointerEvent>(&event);
    if (pointer == nullptr) return;
    const auto ground = view_.groundAt(pointer->screen);
    switch (pointer->phase) {
        case PointerPhase::Down:
            if (ground) down(*pointer, *ground, world, commands);
            return;
        case PointerPhase::Move:
            if (!ground) return;
            std::erase_if(presses_, [&](const Press& press) {
                if (press.pointer != pointer->pointer ||
                    distance(press.screen, pointer->screen) * view_.mmPerPixel <= travelOf(pointer->device))
                    return false;
                takeHold(press, pointer->time, world, commands);
                return true;
            });
            hands_.move(pointer->pointer, *ground, pointer->time, world, commands);
            if (strokeBy_ == pointer->pointer + 1) marks_.stroke.push_back(*ground);
            return;
        case PointerPhase::Up:
        case PointerPhase::Cancel:
            up(*pointer, world, commands);
            return;
    }
}

void TouchScheme::down(const PointerEvent& event, Vec2 ground, const World& world,
                       std::vector<CommandBody>& commands) {
    if (hands_.has(event.pointer) || strokeBy_ == event.pointer + 1) return;
    marks_.notice.clear();
    const double reach = std::clamp(metresFor(view_, event.screen, reachOf(event.device)), kLeastReach,
                                    kMostReach);
    const GroupId group = groupAt(world, ground, reach);
    // Two fingers are no tap.
    for (Press& press : presses_) {
        takeHold(press, event.time, world, commands);
        press.waits = false;
    }
    if (group) {
        // Between the people of a wide formation two taps call somebody; they must not end its way.
        const bool waits = def_.splits && def_.calls && !hands_.any() &&
                           characterAt(world, view_, event.screen, reachOf(event.device)) < 0;
        presses_.push_back({event.pointer, event.screen, event.time, group, ground, waits});
        if (!waits) hands_.down(event.pointer, group, ground, event.time, world, commands);
        return;
    }
    if (!def_.splits || strokeBy_ != 0 || (def_.oneFinger && hands_.any())) return;
    presses_.push_back({event.pointer, event.screen, event.time, {}, ground, false});
    strokeBy_ = event.pointer + 1;
    marks_.stroke.assign(1, ground);
}

void TouchScheme::takeHold(const Press& press, double time, const World& world,
                           std::vector<CommandBody>& commands) {
    if (press.waits) hands_.down(press.pointer, press.group, press.ground, time, world, commands);
}

void TouchScheme::up(const PointerEvent& event, const World& world, std::vector<CommandBody>& commands) {
    const bool cancelled = event.phase == PointerPhase::Cancel;
    const bool onGround = strokeBy_ == event.pointer + 1;
    if (onGround) {
        if (!cancelled) marks_.notice = finishStroke(world, marks_.stroke, commands);
        marks_.stroke.clear();
        strokeBy_ = 0;
    }
    const auto press = std::find_if(presses_.begin(), presses_.end(),
                                    [&](const Press& p) { return p.pointer == event.pointer; });
    const bool tap = !cancelled && press != presses_.end() && event.time - press->time < kTapTime;
    const GroupId group = press != presses_.end() ? press->group : GroupId{};
    if (press != presses_.end()) presses_.erase(press);
    if (!onGround) hands_.up(event.pointer, event.time, cancelled || tap, commands);
    if (tap) tapped(event, group, world, commands);
}

// What one taps is what one sees: people, whose formation becomes a square again by two taps, or ground on
// which nobody stands, to where two taps call whoever is nearest.
void TouchScheme::tapped(const PointerEvent& event, GroupId group, const World& world,
                         std::vector<CommandBody>& commands) {
    const bool onPeople = characterAt(world, view_, event.screen, reachOf(event.device)) >= 0;
    const Tap tap{onPeople ? group : GroupId{}, event.screen, event.time};
    const bool again = tap.group == lastTap_.group && tap.time - lastTap_.time < kDoubleTime &&
                       distance(tap.screen, lastTap_.screen) * view_.mmPerPixel < kDoubleTravel;
    lastTap_ = again ? Tap{} : tap;
    if (!again) return;
    if (onPeople)
        squareAgain(group, world, commands);
    else
        call(event.screen, world, commands);
}

void TouchScheme::squareAgain(GroupId group, const World& world, std::vector<CommandBody>& commands) const {
    const std::int32_t index = groupIndex(world, group);
    if (!def_.shapes || index < 0) return;
    ChangeGroup change{.group = group,
                       .formation = world.groupDef(static_cast<std::size_t>(index)).formation};
    change.formation->kind = FormationKind::Square;
    change.formation->files = 0;
    commands.emplace_back(std::move(change));
}

void TouchScheme::call(Vec2 screen, const World& world, std::vector<CommandBody>& commands) {
    const auto ground = view_.groundAt(screen);
    if (!def_.splits || !def_.calls || !ground) return;
    if (const auto id = whoComes(world, *ground))
        sender_.send(world, std::span(&*id, 1), *ground, false, commands);
}

void TouchScheme::beforeStep(const World& world, std::vector<CommandBody>& commands) {
    // A finger that rests for longer than a tap takes hold, too.
    std::erase_if(presses_, [&](const Press& press) {
        if (world.time() - press.time < kTapTime) return false;
        takeHold(press, world.time(), world, commands);
        return true;
    });
    hands_.beforeStep(world, commands);
    sender_.beforeStep(world, commands);
}

}  // namespace muster
