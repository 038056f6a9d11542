// A world that a control scheme drives by raw inputs, as a person would.
#pragma once

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "muster/world.h"
#include "studio/gestures/scheme_driver.h"

namespace muster::testing {

/// Pixels of 0.28 mm for a metre of ground: a fingertip is 0.625 m wide there, a tap moves less than 0.357 m.
inline constexpr double kPixelsPerMetre = 40.0;

/// A square of people round `middle` that faces +x.
inline GroupDef squareOf(std::int32_t count, Vec2 middle, double spacing = 1.0) {
    return {.count = count, .formation = {.spacing = spacing}, .position = middle};
}

/// An open floor of 30 m with these groups.
inline WorldDef floorWith(std::vector<GroupDef> groups) {
    return {.box = {{-15, -15}, {15, 15}}, .groups = std::move(groups)};
}

/// Sixteen people on it.
inline WorldDef sixteen(Vec2 middle = {}) {
    return floorWith({squareOf(16, middle)});
}

inline constexpr Modifiers kShift{true, false, false};
inline constexpr Modifiers kControl{false, true, false};
inline constexpr char kEscape = 27;

/// One world and one scheme. Pointers are given on the ground; each step takes what came before it.
struct DrivenWorld {
    World world;
    SchemeDriver driver;
    GroundView view;
    PointerDevice device;
    PointerButton button = PointerButton::Left;  ///< Of the presses that follow.
    Modifiers modifiers;                         ///< Of the inputs that follow.
    std::map<std::uint32_t, Vec2> at;            ///< Where each pointer was last [m].
    std::vector<std::string> refused;            ///< Why the world has refused commands.

    DrivenWorld(const WorldDef& def, std::string_view scheme, double pixelsPerMetre = kPixelsPerMetre)
        : world(World::create(def).value()),
          driver(namedScheme(scheme).value().def),
          view(GroundView::fromAbove({}, pixelsPerMetre, 1200, 1200, 0.28)),
          device(scheme.starts_with("touch") ? PointerDevice::Touch : PointerDevice::Mouse) {
        feed(view);
    }

    void feed(const InputEvent& event) { REQUIRE(driver.input(event, world).ok()); }
    void pointer(PointerPhase phase, std::uint32_t number, Vec2 ground) {
        at[number] = ground;
        feed(PointerEvent{phase, device, button, number, *view.screenOf(ground), world.time(), modifiers});
    }
    void down(std::uint32_t number, Vec2 ground) { pointer(PointerPhase::Down, number, ground); }
    void move(std::uint32_t number, Vec2 ground) { pointer(PointerPhase::Move, number, ground); }
    void up(std::uint32_t number) { pointer(PointerPhase::Up, number, at[number]); }
    void cancel(std::uint32_t number) { pointer(PointerPhase::Cancel, number, at[number]); }
    void key(char key) { feed(KeyEvent{static_cast<std::uint8_t>(key), world.time(), modifiers}); }

    void step() {
        std::vector<Command> commands;
        driver.take(world, commands);
        for (const Command& command : commands) REQUIRE(world.submit(command).ok());
        world.step();
        for (const Rejection& rejection : world.rejections()) refused.push_back(rejection.status.message());
    }
    void run(double seconds) {
        for (long s = std::lround(seconds / world.parameters().stepTime); s > 0; --s) step();
    }
    /// Pointers that are down go straight to these points.
    void glide(const std::map<std::uint32_t, Vec2>& to, double seconds) {
        const std::map<std::uint32_t, Vec2> from = at;
        const long steps = std::lround(seconds / world.parameters().stepTime);
        for (long s = 1; s <= steps; ++s) {
            const double t = static_cast<double>(s) / static_cast<double>(steps);
            for (const auto& [number, end] : to) move(number, from.at(number) * (1.0 - t) + end * t);
            step();
        }
    }
    /// A pointer comes down, goes along a way, takes `seconds` for each stretch, and lifts.
    void draw(const std::vector<Vec2>& way, double seconds, std::uint32_t number = 1) {
        down(number, way[0]);
        step();
        for (std::size_t i = 1; i < way.size(); ++i) glide({{number, way[i]}}, seconds);
        up(number);
        step();
    }
    /// A short press.
    void tap(Vec2 ground, double seconds = 0.05) {
        down(1, ground);
        run(seconds);
        up(1);
        step();
    }
    /// Two taps; `pause` from lifting to coming down again.
    void tapTwice(Vec2 first, Vec2 second, double pause = 0.1) {
        tap(first);
        run(pause);
        tap(second);
    }
    void tapTwice(Vec2 ground) { tapTwice(ground, ground); }

    const SchemeMarks& marks() const { return driver.scheme().marks(); }
    FormationDef formation(std::size_t group = 0) const { return world.groupDef(group).formation; }
    /// Ids of a group's people.
    std::vector<std::uint32_t> members(std::size_t group) const {
        std::vector<std::uint32_t> ids;
        for (const std::int32_t i : world.group(group).members) ids.push_back(world.characters().id[i]);
        return ids;
    }
    Vec2 positionOf(std::uint32_t id) const {
        const auto ids = world.characters().id;
        return world.characters().position[std::lower_bound(ids.begin(), ids.end(), id) - ids.begin()];
    }
    std::uint32_t nearestTo(Vec2 ground) const {
        const CharactersView c = world.characters();
        std::size_t best = 0;
        for (std::size_t i = 1; i < c.size(); ++i)
            if (distance(c.position[i], ground) < distance(c.position[best], ground)) best = i;
        return c.id[best];
    }
    /// Where people are on average [m].
    Vec2 middleOf(const std::vector<std::uint32_t>& ids) const {
        Vec2 sum;
        for (const std::uint32_t id : ids) sum += positionOf(id);
        return sum / static_cast<double>(ids.size());
    }
    Vec2 middle(std::size_t group = 0) const { return middleOf(members(group)); }
    /// From the outermost to the outermost of a group along both axes [m].
    Vec2 extent(std::size_t group = 0) const {
        Vec2 least{1e9, 1e9}, most{-1e9, -1e9};
        for (const std::uint32_t id : members(group)) {
            const Vec2 p = positionOf(id);
            least = {std::min(least.x, p.x), std::min(least.y, p.y)};
            most = {std::max(most.x, p.x), std::max(most.y, p.y)};
        }
        return most - least;
    }
    std::vector<Vec2> positions() const {
        return {world.characters().position.begin(), world.characters().position.end()};
    }
    /// How far the one who has gone farthest is from where all were [m].
    double farthestFrom(const std::vector<Vec2>& before) const {
        double most = 0.0;
        for (std::size_t i = 0; i < before.size(); ++i)
            most = std::max(most, distance(before[i], world.characters().position[i]));
        return most;
    }
};

}  // namespace muster::testing
