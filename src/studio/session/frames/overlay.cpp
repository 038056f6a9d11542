#include "studio/session/frames/overlay.h"

#include <algorithm>
#include <cmath>

#include "base/grid.h"
#include "engine/assignment/planning/plan.h"
#include "engine/fields/cost/density.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"

namespace muster {
namespace {

constexpr std::size_t kMaxPathPoints = 4000;
constexpr double kCostMargin = 8.0;  // Margin around the group that the overlay covers [m].

// A character, its place, and the plan that gives costs to that place.
struct Destination {
    const Plan* plan = nullptr;
    std::int32_t place = -1;
    Vec2 from;  // The character's position [m].
    Vec2 to;    // The position of its place [m].

    double cost(Vec2 p) const { return plan->costAt(place, p); }
};

// A box of whole ground cells, coarsened until their number is within the limit.
Grid coarseGrid(const Grid& ground, const Box& box) {
    const Cell low = ground.nearestCell(box.min);
    const Cell high = ground.nearestCell(box.max);
    Grid grid;
    grid.origin = {ground.origin.x + low.x * ground.cell, ground.origin.y + low.y * ground.cell};
    const std::int32_t across = high.x - low.x + 1;
    const std::int32_t up = high.y - low.y + 1;
    std::int32_t step = 1;
    const auto cells = [&](std::int32_t n) { return ((across + n - 1) / n) * ((up + n - 1) / n); };
    while (cells(step) > kOverlayCells) ++step;
    grid.cell = ground.cell * step;
    grid.width = (across + step - 1) / step;
    grid.height = (up + step - 1) / step;
    return grid;
}

template <class Value>
void fill(protocol::Overlay& overlay, const Grid& grid, Value value) {
    overlay.values.resize(grid.count());
    for (std::int32_t i = 0; i < grid.count(); ++i)
        overlay.values[i] = static_cast<float>(value(grid.centre(grid.at(i))));
}

std::optional<Destination> destinationOf(const World& world, std::uint32_t character) {
    const CharactersView all = world.characters();
    const auto found = std::lower_bound(all.id.begin(), all.id.end(), character);
    if (found == all.id.end() || *found != character) return std::nullopt;
    const auto i = static_cast<std::size_t>(found - all.id.begin());
    const std::span<const Vec2> places = world.group(all.group[i]).placePositions;
    const std::int32_t place = all.place[i];
    if (place < 0 || static_cast<std::size_t>(place) >= places.size()) return std::nullopt;
    return Destination{&inspect::plan(world, all.group[i]), place, all.position[i], places[place]};
}

Box boundsOfGroup(const World& world, const Destination& destination) {
    Box box{destination.from, destination.from};
    const auto include = [&](Vec2 p) {
        box.min = {std::min(box.min.x, p.x - kCostMargin), std::min(box.min.y, p.y - kCostMargin)};
        box.max = {std::max(box.max.x, p.x + kCostMargin), std::max(box.max.y, p.y + kCostMargin)};
    };
    include(destination.from);
    include(destination.to);
    for (const Vec2 p : world.characters().position) include(p);
    return box;
}

// Descends the field from the character in steps of one cell, along the cheapest of sixteen directions.
void tracePath(const Destination& destination, double step, protocol::Overlay& overlay) {
    constexpr int kDirections = 16;
    Vec2 at = destination.from;
    double here = destination.cost(at);
    double walked = 0.0;
    const auto append = [&](Vec2 p) {
        overlay.path.push_back(static_cast<float>(p.x));
        overlay.path.push_back(static_cast<float>(p.y));
    };
    append(at);
    while (distance(at, destination.to) > step && overlay.path.size() < 2 * kMaxPathPoints) {
        Vec2 best = at;
        for (int k = 0; k < kDirections; ++k) {
            const double angle = 6.283185307179586 * k / kDirections;
            const Vec2 next = at + Vec2{std::cos(angle), std::sin(angle)} * step;
            const double cost = destination.cost(next);
            if (cost < here) here = cost, best = next;
        }
        if (best == at) break;
        walked += distance(at, best);
        at = best;
        append(at);
    }
    walked += distance(at, destination.to);
    append(destination.to);
    overlay.way = static_cast<float>(walked);
}

std::optional<protocol::Overlay> costOverlay(const World& world, std::uint32_t character) {
    const auto destination = destinationOf(world, character);
    if (!destination || destination->plan == nullptr || inspect::unitCost(world) == nullptr)
        return std::nullopt;
    protocol::Overlay overlay;
    overlay.kind = protocol::OverlayKind::Cost;
    overlay.character = character;
    const Grid& ground = inspect::environment(world).grid();
    fill(overlay, putOverlayGrid(overlay, ground, boundsOfGroup(world, *destination)),
         [&](Vec2 p) { return destination->cost(p); });
    overlay.cost = static_cast<float>(destination->cost(destination->from));
    overlay.straight = static_cast<float>(distance(destination->from, destination->to));
    tracePath(*destination, ground.cell, overlay);
    return overlay;
}

}  // namespace

Grid putOverlayGrid(protocol::Overlay& overlay, const Grid& ground, const Box& box) {
    const Grid grid = coarseGrid(ground, box);
    overlay.x = static_cast<float>(grid.centre({0, 0}).x);
    overlay.y = static_cast<float>(grid.centre({0, 0}).y);
    overlay.cell = static_cast<float>(grid.cell);
    overlay.width = static_cast<std::uint32_t>(grid.width);
    overlay.height = static_cast<std::uint32_t>(grid.height);
    return grid;
}

std::optional<protocol::Overlay> buildOverlay(const World& world, protocol::OverlayKind kind,
                                              std::uint32_t character) {
    protocol::Overlay overlay;
    overlay.kind = kind;
    switch (kind) {
        case protocol::OverlayKind::None:
            return std::nullopt;
        case protocol::OverlayKind::Cost:
            return costOverlay(world, character);
        case protocol::OverlayKind::Reach:
            return buildReachOverlay(world);
        case protocol::OverlayKind::Field: {
            const Environment& environment = inspect::environment(world);
            fill(overlay, putOverlayGrid(overlay, environment.grid(), environment.grid().box()),
                 [&](Vec2 p) { return length(environment.potentialField(p)); });
            return overlay;
        }
        case protocol::OverlayKind::Density: {
            const DensityField& density = inspect::density(world);
            fill(overlay, putOverlayGrid(overlay, density.grid(), density.grid().box()),
                 [&](Vec2 p) { return density.densityAt(p); });
            return overlay;
        }
    }
    return std::nullopt;
}

}  // namespace muster
