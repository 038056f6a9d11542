// Draws the fields of random definitions: valid values of each type, and what the fields of one definition
// have to be together.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "base/random.h"
#include "muster/generated/enumerations.h"
#include "muster/generated/world_definitions.h"

namespace muster {

class DefinitionDraw {
public:
    explicit DefinitionDraw(std::uint64_t seed) : random_(seed) {}

    std::uint32_t number() { return 1 + random_.below(1000000); }
    bool flag() { return random_.below(2) == 1; }
    double real(double low, double high) { return low + (high - low) * random_.below(1001) / 1000.0; }
    std::int32_t whole(std::int32_t low, std::int32_t high) {
        return low + static_cast<std::int32_t>(random_.below(static_cast<std::uint32_t>(high - low) + 1));
    }
    Vec2 place() { return {real(-1e3, 1e3), real(-1e3, 1e3)}; }
    std::string text() { return "Guests " + std::to_string(number()); }
    template <class Enum>
    Enum value() {
        return static_cast<Enum>(random_.below(static_cast<std::uint32_t>(kCountOf<Enum>)));
    }
    /// Fills a list with one to four entries.
    template <class Item, class Make>
    void list(std::vector<Item>& items, const Make& make) {
        items.resize(0);
        for (std::uint32_t k = 1 + random_.below(4); k > 0; --k) items.push_back(make());
    }
    Polygon polygon() { return {{0, 0}, {real(1, 5), 0}, {1, 1}}; }
    PolygonWithHoles outline() { return {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}}}}; }
    /// A distribution of numbers from `low` to `high`.
    Distribution distribution(double low, double high) {
        const double a = real(low, high), b = real(low, high);
        switch (random_.below(3)) {
            case 0:
                return Distribution::constant(a);
            case 1:
                return Distribution::uniform(std::min(a, b), std::max(a, b));
            default:
                return Distribution::normal(a, 0.1 * (high - low), low, high);
        }
    }

    /// Makes the fields of a definition or a command fit each other; most do so already.
    template <class Kind>
    void relate(Kind&) {}
    void relate(TimedPath& d) {
        for (std::size_t k = 0; k < d.waypoints.size(); ++k) {
            d.waypoints[k].time = 2.5 * static_cast<double>(k);
            d.waypoints[k].angle = real(-6.0, 6.0);
        }
    }
    void relate(ObstacleDef& d) {
        if (flag()) {
            d.polygon.clear();
            d.radius = real(0.5, 4.0);
        } else {
            d.radius = 0.0;
        }
    }
    void relate(AreaDef& d) {
        d.until = std::max(d.from, d.until);
        if (d.kind != AreaKind::Exit) d.queue.clear();
        if (!d.queue.empty()) d.queue.push_back(place());
        if (d.kind != AreaKind::Source) d.timetable.clear();
        for (std::size_t k = 0; k < d.timetable.size(); ++k)
            d.timetable[k].time = 60.0 * static_cast<double>(k);
    }
    void relate(Order& d) {
        if (!d.facing) d.facing = real(-3, 3);
        d.attractions.resize(flag() ? 0 : d.exits.size());
    }
    void relate(GroupDef& d) {
        d.count = static_cast<std::int32_t>(d.starts.size());
        d.bodies.resize(flag() ? 1 : d.starts.size(), d.bodies.front());
        while (d.formation.points.size() < d.starts.size()) d.formation.points.push_back(place());
    }

private:
    Random random_;
};

}  // namespace muster
